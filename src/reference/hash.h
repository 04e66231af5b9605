// The integer hash behind every random decision. estimator.md, Numbers.
#pragma once
#include <bit>
#include <cstdint>
#include <glm/glm.hpp>

namespace vkpt::reference {

/// pcg4d. [Jarzynski 20]
[[nodiscard]] inline glm::uvec4 hash(glm::uvec4 v) {
    v = v * 1664525U + 1013904223U;
    const auto mix = [&v] {
        v.x += v.y * v.w;
        v.y += v.z * v.x;
        v.z += v.x * v.y;
        v.w += v.y * v.z;
    };
    mix();
    v ^= v >> 16U;
    mix();
    return v;
}

/// The upper 24 bits as a float in [0,1): exact, never 1.
[[nodiscard]] inline float toUnit(std::uint32_t bits) { return static_cast<float>(bits >> 8U) * 0x1p-24F; }

}  // namespace vkpt::reference
