// SPEC of the command line: text to the keys of VKPT_materials_bsdf.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "base/file_bytes.h"
#include "base/json.h"
#include "scene/bsdf_spec.h"

namespace vkpt {
namespace {

/// "0.2" is a number, "0.1/0.3" an array of numbers, anything else a word.
Json valueOf(std::string_view text) {
    Json parts = Json::array();
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find('/', begin), text.size());
        double value = 0;
        const auto [stop, error] = std::from_chars(text.data() + begin, text.data() + end, value);
        if (error != std::errc{} || stop != text.data() + end || !std::isfinite(value)) return std::string(text);
        parts.push_back(value);
        begin = end + 1;
    }
    return parts.size() == 1 ? parts[0] : parts;
}

Json parseJson(std::string_view text) {
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        throw std::invalid_argument(fmt::format("is no JSON at byte {}", error.byte));
    }
}

Json jsonFromText(std::string_view text) {
    if (text.starts_with('@')) {
        const auto bytes = readFileBytes(std::filesystem::path(text.substr(1)));
        return parseJson({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }
    if (text.starts_with('{')) return parseJson(text);
    const std::size_t colon = std::min(text.find(':'), text.size());
    Json json{{"model", std::string(text.substr(0, colon))}};
    for (std::size_t begin = colon + 1; begin < text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const std::string_view pair = text.substr(begin, end - begin);
        const std::size_t equals = pair.find('=');
        if (equals == std::string_view::npos)
            throw std::invalid_argument(fmt::format("\"{}\": expected key=value", pair));
        json[std::string(pair.substr(0, equals))] = valueOf(pair.substr(equals + 1));
        begin = end + 1;
    }
    return json;
}

}  // namespace

BsdfSpec parseBsdfSpec(std::string_view text) { return bsdfFromJson(jsonFromText(text)); }

}  // namespace vkpt
