// The built-in studio: a procedural environment map.
#include <oneapi/tbb/parallel_for.h>

#include <array>
#include <cmath>

#include "scene/environment.h"

namespace vkpt {
namespace {

constexpr std::uint32_t kWidth = 512, kHeight = 256;
constexpr float kTurn = 6.28318530717958647692F;
constexpr float kExposure = 0.7F;  // brings the mean to kStudioMean; a test holds it there

/// A rectangular luminous panel, seen from the origin in direction `towards`.
struct Softbox {
    glm::vec3 towards;
    float halfWidth, halfHeight;  // tangents of half the angles it fills
    glm::vec3 radiance;           // at its centre
    float edge;                   // share of the half width over which the rim fades out
    float hotspot;                // how much darker the rim is than the centre
};

// Seen by a camera at the front (+z) or front right (the default view), no panel stands behind the subject.
constexpr std::array kPanels{
    // Key: warm, large, at the upper left of the camera.
    Softbox{{-0.78F, 0.72F, 0.55F}, 0.62F, 0.5F, {10.9F, 9.9F, 8.6F}, 0.22F, 0.35F},
    // Fill: cool, tall, on the right, three stops below.
    Softbox{{1.0F, 0.22F, 0.42F}, 0.42F, 0.75F, {1.25F, 1.5F, 1.85F}, 0.35F, 0.3F},
    // Rim: a narrow strip high behind, a little to the right.
    Softbox{{0.9F, 0.72F, -0.75F}, 0.15F, 0.55F, {8.2F, 8.4F, 8.8F}, 0.3F, 0.15F},
    // Kicker: a dim strip low on the left, to part dark edges from the background.
    Softbox{{-0.98F, 0.08F, -0.12F}, 0.08F, 0.55F, {2.3F, 2.2F, 2.05F}, 0.4F, 0.15F},
};

float smoothStep(float low, float high, float x) {
    const float t = glm::clamp((x - low) / (high - low), 0.0F, 1.0F);
    return t * t * (3 - 2 * t);
}

glm::vec3 panelRadiance(const Softbox& panel, const glm::vec3& d) {
    const glm::vec3 axis = glm::normalize(panel.towards);
    const float along = glm::dot(d, axis);
    if (along <= 0.05F) return glm::vec3(0);
    const glm::vec3 right = glm::normalize(glm::cross(axis, glm::vec3(0, 1, 0)));
    const glm::vec3 up = glm::cross(right, axis);
    const glm::vec2 p = glm::vec2(glm::dot(d, right) / panel.halfWidth, glm::dot(d, up) / panel.halfHeight) / along;
    // Rounded corners: the sixth-power norm is 1 on a superellipse.
    const float norm = std::pow(std::pow(p.x, 6.0F) + std::pow(p.y, 6.0F), 1.0F / 6.0F);
    const float inside = 1 - smoothStep(1 - panel.edge, 1, norm);
    const float falloff = 1 - panel.hotspot * glm::clamp(glm::dot(p, p) * 0.5F, 0.0F, 1.0F);
    return panel.radiance * inside * falloff;
}

/// Grey cyclorama: a soft glow on the wall behind the subject, dark overhead, and a floor that bounces the key.
glm::vec3 domeRadiance(const glm::vec3& d) {
    const glm::vec3 wall{0.235F, 0.24F, 0.252F}, ceiling{0.085F, 0.088F, 0.1F}, floor{0.29F, 0.278F, 0.26F};
    glm::vec3 color = glm::mix(wall, ceiling, smoothStep(-0.05F, 0.85F, d.y));
    const glm::vec3 behind = glm::normalize(glm::vec3(-0.35F, -0.05F, -1));
    color *= 0.78F + 0.75F * std::pow(glm::max(glm::dot(d, behind), 0.0F), 3.0F);
    const float underLeft = 0.85F + 0.35F * glm::max(glm::dot(d, glm::normalize(glm::vec3(-0.5F, -0.7F, 0.4F))), 0.0F);
    return glm::mix(color, floor * underLeft, smoothStep(0.02F, -0.5F, d.y));
}

glm::vec3 studioRadiance(const glm::vec3& d) {
    glm::vec3 radiance = domeRadiance(d);
    for (const Softbox& panel : kPanels) radiance += panelRadiance(panel, d);
    return radiance * kExposure;
}

}  // namespace

EnvironmentMap studioEnvironment() {
    EnvironmentMap map{kWidth, kHeight, std::vector<glm::vec3>(std::size_t{kWidth} * kHeight)};
    tbb::parallel_for(std::uint32_t{0}, kHeight, [&](std::uint32_t j) {
        const float theta = kTurn * 0.5F * (static_cast<float>(j) + 0.5F) / kHeight;
        for (std::uint32_t i = 0; i < kWidth; ++i) {
            const float phi = kTurn * ((static_cast<float>(i) + 0.5F) / kWidth - 0.5F);
            const glm::vec3 d(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
            map.texels[std::size_t{j} * kWidth + i] = studioRadiance(d);
        }
    });
    return map;
}

}  // namespace vkpt
