#include "reference/light.h"

#include "reference/geometry.h"
#include "reference/lights/punctual.h"
#include "reference/lights/spherical_triangle.h"

namespace vkpt::reference {

namespace {

SphericalTriangle<float> seenFrom(const LightRecord& light, const glm::vec3& from) {
    return {from, light.a, light.b, light.c};
}

/// Per steradian, the choice of the light included. In the plane itself rounding would decide: there it is 0, too.
float densityOf(const LightRecord& light, const SphericalTriangle<float>& seen) {
    const bool isBehind = seen.height() < -light.offset && light.kind == kLightTriangleTwoSided;
    const bool isLit = (seen.height() > light.offset || isBehind) && seen.solidAngle() > 0;
    return isLit ? light.pmf / seen.solidAngle() : 0;
}

}  // namespace

std::optional<LightSample> Lights::sample(const glm::vec3& from, glm::uvec2 bits) const {
    const std::vector<float>& cdf = scene_.lightCdf;
    const std::uint32_t chosen = sampleTable(cdf, toUnit(bits.x)).index;
    const LightRecord& light = scene_.lights[chosen];
    if (light.pmf <= 0) return std::nullopt;
    // How far bits.x lies into the interval that chose, all its 32 bits counted. [Shirley 96]
    const float begin = chosen == 0 ? 0 : cdf[chosen - 1];
    const float into = (toUnit(bits.x) - begin + static_cast<float>(bits.x % 256) * 0x1p-32F) / (cdf[chosen] - begin);
    const Vec2<float> u{std::min(into, kBelowOne), toUnit(bits.y)};
    std::optional<LightSample> sample = sampleOf(light, from, u);
    if (sample) sample->light = chosen;
    return sample;
}

std::optional<LightSample> Lights::sampleOf(const LightRecord& light, const glm::vec3& from,
                                            const Vec2<float>& u) const {
    if (light.kind <= kLightTriangleTwoSided) return sampleTriangle(light, from, u);
    if (light.kind == kLightEnvironment) return sampleEnvironment(light, u);
    return samplePunctual(light, from);
}

std::optional<LightSample> Lights::sampleTriangle(const LightRecord& light, const glm::vec3& from,
                                                  const Vec2<float>& u) const {
    const auto seen = seenFrom(light, from);
    LightSample sample;
    sample.pdf = densityOf(light, seen);
    if (sample.pdf <= 0) return std::nullopt;
    const glm::vec3 b = seen.point(u);
    const glm::vec3 point = b.x * light.a + b.y * light.b + b.z * light.c;
    const glm::vec3 toLight = point - from;
    sample.distance = glm::length(toLight);
    sample.wi = toLight / sample.distance;
    const TriangleRecord& triangle = scene_.triangles[light.index];
    const MaterialRecord& material = materialOf(scene_, triangle);
    sample.radiance = light.color;
    if (material.emissiveTexture != kNone) {
        sample.radiance = emission(scene_, material, interpolateAttributes(scene_, triangle, b));
    }
    const glm::vec3 normal = glm::normalize(glm::cross(light.b - light.a, light.c - light.a));
    sample.end = point + normal * (seen.height() > 0 ? light.offset : -light.offset);
    return sample;
}

std::optional<LightSample> Lights::samplePunctual(const LightRecord& light, const glm::vec3& from) const {
    LightSample sample;
    sample.punctual = true;
    sample.pdf = light.pmf;
    if (light.kind == kLightDirectional) {
        sample.wi = -light.b;
        sample.radiance = light.color;
        sample.infinite = true;
        return sample;
    }
    const glm::vec3 toLight = light.a - from;
    const float distance2 = glm::dot(toLight, toLight);
    if (distance2 <= 0) return std::nullopt;
    sample.distance = std::sqrt(distance2);
    sample.wi = toLight / sample.distance;
    sample.radiance = light.color / distance2 * rangeWindow(distance2, light.c.z);
    if (light.kind == kLightSpot) sample.radiance *= spotFalloff(-glm::dot(light.b, sample.wi), light.c.x, light.c.y);
    sample.end = light.a;
    return sample;
}

std::optional<LightSample> Lights::sampleEnvironment(const LightRecord& light, const Vec2<float>& u) const {
    if (!environment_.exists()) return std::nullopt;
    const Environment::Sample drawn = environment_.sample(u);
    if (drawn.pdf <= 0) return std::nullopt;
    LightSample sample;
    sample.wi = drawn.direction;
    sample.radiance = environment_.radiance(drawn.direction);
    sample.pdf = light.pmf * drawn.pdf;
    sample.infinite = true;
    return sample;
}

float Lights::pdfTriangle(const LightRecord& light, const glm::vec3& from) const {
    return densityOf(light, seenFrom(light, from));
}

float Lights::pdfEnvironment(const glm::vec3& d) const {
    if (scene_.envLight == kNone) return 0;
    return scene_.lights[scene_.envLight].pmf * environment_.pdf(d);
}

}  // namespace vkpt::reference
