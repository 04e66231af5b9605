// Reproducible inputs for probes.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <random>

namespace vkpt {

/// A seeded stream of floats and vectors.
class RandomInputs {
public:
    explicit RandomInputs(std::uint32_t seed) : engine_(seed) {}

    /// A multiple of 2^-24 in [0,1), as samplers make them.
    [[nodiscard]] float unit() { return static_cast<float>(engine_() >> 8U) * 0x1p-24F; }
    [[nodiscard]] float between(float low, float high) { return low + (high - low) * unit(); }
    [[nodiscard]] std::uint32_t bits() { return static_cast<std::uint32_t>(engine_()); }
    [[nodiscard]] std::uint32_t below(std::uint32_t end) { return bits() % end; }
    [[nodiscard]] glm::vec2 square() { return {unit(), unit()}; }
    [[nodiscard]] glm::vec3 inBox(const glm::vec3& low, const glm::vec3& high) {
        return {between(low.x, high.x), between(low.y, high.y), between(low.z, high.z)};
    }
    /// Uniform on the sphere; a unit vector up to rounding.
    [[nodiscard]] glm::vec3 direction() {
        const float z = between(-1, 1), phi = between(0, 6.2831853F), r = std::sqrt(std::max(0.0F, 1 - z * z));
        return glm::normalize(glm::vec3(r * std::cos(phi), r * std::sin(phi), z));
    }

private:
    std::mt19937 engine_;
};

/// The direction whose z is `cosine`, at `turns` around it.
[[nodiscard]] inline glm::vec3 atCosine(float cosine, float turns) {
    const float s = std::sqrt((1 - cosine) * (1 + cosine));
    return {s * std::cos(6.2831853F * turns), s * std::sin(6.2831853F * turns), cosine};
}

}  // namespace vkpt
