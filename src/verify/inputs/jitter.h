// How far rounding may carry a function: its values for inputs a few ulps off.
#pragma once
#include <algorithm>
#include <glm/glm.hpp>

#include "verify/inputs/random_inputs.h"

namespace vkpt {

/// w, off by about an ulp of 1 in each component: its length rounds as well.
[[nodiscard]] inline glm::dvec3 jittered(const glm::dvec3& w, RandomInputs& random) {
    return w + 1.5e-7 * glm::dvec3(random.inBox(glm::vec3(-1), glm::vec3(1)));
}

/// The largest difference from `value` in any component that `evaluate(random)`, for inputs it jitters itself, shows.
template <class Value, class Evaluate>
[[nodiscard]] double jitterOf(const Value& value, RandomInputs& random, const Evaluate& evaluate) {
    constexpr int kTries = 6;
    double most = 0;
    for (int i = 0; i < kTries; ++i) {
        const Value other = evaluate(random) - value;
        if constexpr (std::is_arithmetic_v<Value>) {
            most = std::max(most, std::abs(double{other}));
        } else {
            for (int c = 0; c < Value::length(); ++c) most = std::max(most, std::abs(double{other[c]}));
        }
    }
    return most;
}

}  // namespace vkpt
