// Fields of JSON objects that are numbers within bounds, or words out of a list. What a field may not be throws
// std::invalid_argument, whose text names the field, its value and what it may be.
#pragma once
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <glm/glm.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "base/json.h"

namespace vkpt {

/// Says what the field may be.
[[noreturn]] inline void refuse(std::string_view key, const Json& value, std::string_view wanted) {
    throw std::invalid_argument(fmt::format("{}: {} is not {}", key, jsonText(value, -1), wanted));
}

/// One number, or `least` to `most` of them in an array; all within [low, high].
[[nodiscard]] inline std::vector<float> numbers(std::string_view key, const Json& value, std::size_t least,
                                                std::size_t most, double low, double high) {
    std::vector<float> result;
    const Json list = value.is_array() ? value : Json::array({value});
    for (const Json& element : list) {
        const bool fits = element.is_number() && element.get<double>() >= low && element.get<double>() <= high;
        if (!fits) refuse(key, value, fmt::format("within {:g} and {:g}", low, high));
        result.push_back(element.get<float>());
    }
    if (result.size() != 1 && (result.size() < least || result.size() > most))
        refuse(key, value, most == 1 ? "one number" : fmt::format("one number or {}", most));
    return result;
}

/// One number; two or three, of which one stands for all.
[[nodiscard]] inline float number(std::string_view key, const Json& value, double low, double high) {
    return numbers(key, value, 1, 1, low, high)[0];
}
[[nodiscard]] inline glm::vec2 two(std::string_view key, const Json& value, double low, double high) {
    const auto n = numbers(key, value, 2, 2, low, high);
    return {n.front(), n.back()};
}
[[nodiscard]] inline glm::vec3 three(std::string_view key, const Json& value, double low, double high) {
    const auto n = numbers(key, value, 3, 3, low, high);
    return n.size() == 1 ? glm::vec3(n[0]) : glm::vec3(n[0], n[1], n[2]);
}

/// A value and what it is called.
template <class Value>
struct Choice {
    std::string_view name;
    Value value;
};

/// The value of the name that `value` is.
template <class Value, std::size_t n>
[[nodiscard]] Value choose(std::string_view key, const Json& value, const std::array<Choice<Value>, n>& choices) {
    if (value.is_string())
        for (const auto& choice : choices)
            if (choice.name == value.get<std::string>()) return choice.value;
    std::vector<std::string_view> names;
    for (const auto& choice : choices) names.push_back(choice.name);
    refuse(key, value, fmt::format("one of {}", fmt::join(names, ", ")));
}

/// The name of a value that is among them.
template <class Value, std::size_t n>
[[nodiscard]] std::string nameOf(const std::array<Choice<Value>, n>& choices, Value value) {
    for (const auto& choice : choices)
        if (choice.value == value) return std::string(choice.name);
    return {};
}

}  // namespace vkpt
