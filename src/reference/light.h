// Lights as the estimator sees them: one sample towards any of them, and the densities of those samples.
#pragma once
#include <limits>
#include <optional>

#include "reference/lights/environment.h"
#include "reference/material.h"
#include "reference/real.h"

namespace vkpt::reference {

/// One light sample as seen from a point.
struct LightSample {
    glm::vec3 wi{0, 0, 1};  ///< unit
    glm::vec3 radiance{0};  ///< Le in nits; of punctual lights the irradiance at normal incidence, in lux
    float pdf = 0;          ///< per solid angle, choice of the light included; of punctual lights the choice alone
    bool punctual = false;  ///< no BSDF sample can meet it: MIS weight 1
    bool infinite = false;  ///< nothing ends the shadow ray
    float distance = std::numeric_limits<float>::infinity();  ///< metres
    glm::vec3 end{0};                                         ///< where the shadow ray ends, unless infinite
    std::uint32_t light = kNone;                              ///< which of SceneArrays::lights it is of
};

class Lights {
public:
    explicit Lights(const SceneArrays& scene) : scene_(scene), environment_(scene) {}

    [[nodiscard]] bool empty() const { return scene_.lights.empty(); }
    [[nodiscard]] const Environment& environment() const { return environment_; }

    /// Chooses a light, and a direction to it, by two sampler values. Nothing where no light comes from there.
    [[nodiscard]] std::optional<LightSample> sample(const glm::vec3& from, glm::uvec2 bits) const;

    /// Density of sample() from there for the directions that meet a triangle light, per steradian; 0 from behind a
    /// light of one side, and in its plane.
    [[nodiscard]] float pdfTriangle(const LightRecord& light, const glm::vec3& from) const;
    /// Density of sample() for a unit direction that met nothing.
    [[nodiscard]] float pdfEnvironment(const glm::vec3& d) const;

private:
    [[nodiscard]] std::optional<LightSample> sampleOf(const LightRecord& light, const glm::vec3& from,
                                                      const Vec2<float>& u) const;
    [[nodiscard]] std::optional<LightSample> sampleTriangle(const LightRecord& light, const glm::vec3& from,
                                                            const Vec2<float>& u) const;
    [[nodiscard]] std::optional<LightSample> samplePunctual(const LightRecord& light, const glm::vec3& from) const;
    [[nodiscard]] std::optional<LightSample> sampleEnvironment(const LightRecord& light, const Vec2<float>& u) const;

    const SceneArrays& scene_;
    Environment environment_;
};

}  // namespace vkpt::reference
