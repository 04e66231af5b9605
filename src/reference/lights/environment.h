// The equirectangular environment: lookup, and sampling by its table.
#pragma once
#include <algorithm>
#include <span>

#include "reference/angle.h"
#include "scene/scene_arrays.h"

namespace vkpt::reference {

/// (u, v) of a direction of the environment's own frame: u = 0.25 is -z, v = 0 is +y.
template <class Real>
[[nodiscard]] Vec2<Real> environmentUv(const Vec3<Real>& d) {
    return {arcTangent2(d.z, d.x) / (2 * kPiOf<Real>)+Real(0.5),
            arcCosine(std::clamp(d.y, Real(-1), Real(1))) / kPiOf<Real>};
}

/// The unit direction at longitude u and height cosTheta: the inverse of environmentUv.
template <class Real>
[[nodiscard]] Vec3<Real> environmentDirection(Real u, Real cosTheta) {
    const Real sinTheta = std::sqrt(std::max(Real(0), 1 - cosTheta * cosTheta));
    const Vec2<Real> phi = cosSinTurns(u - Real(0.5));
    return {sinTheta * phi.x, cosTheta, sinTheta * phi.y};
}

/// Inversion of an inclusive CDF: the smallest index with u < cdf[index] (the last if none), and how far u has gone
/// through that interval.
struct TableSample {
    std::uint32_t index;
    float fraction;
};
[[nodiscard]] TableSample sampleTable(std::span<const float> cdf, float u);

class Environment {
public:
    explicit Environment(const SceneArrays& scene);

    [[nodiscard]] bool exists() const { return width_ > 0 && height_ > 0; }
    /// Radiance in nits from a unit world direction: bilinear between texel centres, u wraps, v clamps.
    [[nodiscard]] glm::vec3 radiance(const glm::vec3& direction) const;
    /// Density per solid angle with which sample() draws a unit world direction.
    [[nodiscard]] float pdf(const glm::vec3& direction) const;

    struct Sample {
        glm::vec3 direction;  ///< unit, world
        float pdf;            ///< per solid angle
    };
    [[nodiscard]] Sample sample(const Vec2<float>& u) const;

private:
    [[nodiscard]] glm::vec2 uvOf(const glm::vec3& worldDirection) const;
    [[nodiscard]] const glm::vec4& cell(std::uint32_t column, std::uint32_t row) const {
        return scene_.envTexels[std::size_t{row} * width_ + column];
    }

    const SceneArrays& scene_;
    std::uint32_t width_, height_;
    float cos_, sin_;  ///< of the rotation about +y
};

}  // namespace vkpt::reference
