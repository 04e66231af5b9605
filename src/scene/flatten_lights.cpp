#include "scene/flatten_lights.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include "base/math.h"
#include "scene/sampling_table.h"
#include "scene/texture_light.h"

namespace vkpt {
namespace {

constexpr std::size_t kMostTriangleLights = std::size_t{1} << 22U;  // a quarter of the steps a table can have

/// The texture coordinates at which a triangle reads a texture.
std::array<glm::vec2, 3> triangleUv(const SceneArrays& arrays, const TriangleRecord& triangle, bool second) {
    std::array<glm::vec2, 3> uv{};
    const std::array<std::uint32_t, 3> corners{triangle.i0, triangle.i1, triangle.i2};
    for (std::size_t i = 0; i < 3; ++i) {
        if (!second) {
            uv[i] = {arrays.vertices[corners[i]].u0, arrays.vertices[corners[i]].v0};
        } else if (!arrays.vertexExtras.empty()) {
            uv[i] = {arrays.vertexExtras[corners[i]].u1, arrays.vertexExtras[corners[i]].v1};
        }
    }
    return uv;
}

double triangleArea(const TriangleRecord& t) {
    return 0.5 * glm::length(glm::cross(glm::dvec3(t.v1) - glm::dvec3(t.v0), glm::dvec3(t.v2) - glm::dvec3(t.v0)));
}

/// By index of the TextureRecord: each belongs to one material, and so to one factor.
using EmissiveTextures = std::unordered_map<std::uint32_t, EmissiveTexture>;

EmissiveTextures prepareTextures(const SceneArrays& arrays) {
    EmissiveTextures prepared;
    for (const MaterialRecord& m : arrays.materials)
        if (m.emissiveTexture != kNone && m.emissive != glm::vec3(0))
            prepared.try_emplace(m.emissiveTexture, arrays, arrays.textures[m.emissiveTexture], m.emissive);
    return prepared;
}

/// By its material: glass that is not double-sided is met from behind, too, and yet shines in front alone.
bool shinesOnBothSides(const MaterialRecord& material) { return (material.flags & kMaterialDoubleSided) != 0; }

/// Flux of a Lambertian emitter, pi x area x luminance a side; 0 where the triangle is to have no light.
double trianglePower(const SceneArrays& arrays, const EmissiveTextures& textures, const TriangleRecord& triangle) {
    const MaterialRecord& material = arrays.materials[triangle.flags >> kTriangleMaterialShift];
    if (material.emissive == glm::vec3(0) || (triangle.flags & kTriangleHasAlpha) != 0) return 0;
    float mean = luminance(material.emissive);
    if (material.emissiveTexture != kNone) {
        const TextureRecord& texture = arrays.textures[material.emissiveTexture];
        const bool second = (texture.flags & kTextureUv1) != 0;
        mean = textures.at(material.emissiveTexture).mean(triangleUv(arrays, triangle, second));
    }
    const double sides = shinesOnBothSides(material) ? 2 : 1;
    return sides * std::numbers::pi * triangleArea(triangle) * static_cast<double>(mean);
}

void addTriangleLights(SceneArrays& arrays) {
    const EmissiveTextures textures = prepareTextures(arrays);
    std::vector<double> power(arrays.triangles.size());
    tbb::parallel_for(std::size_t{0}, power.size(),
                      [&](std::size_t i) { power[i] = trianglePower(arrays, textures, arrays.triangles[i]); });
    std::vector<std::uint32_t> emitters;
    for (std::uint32_t i = 0; i < power.size(); ++i) {
        if (power[i] > 0 && std::isfinite(power[i])) emitters.push_back(i);
    }
    if (emitters.size() > kMostTriangleLights) {  // the dimmest are left to chance, in source order
        std::nth_element(
            emitters.begin(), emitters.begin() + kMostTriangleLights, emitters.end(),
            [&](std::uint32_t a, std::uint32_t b) { return power[a] > power[b] || (power[a] == power[b] && a < b); });
        emitters.resize(kMostTriangleLights);
        std::sort(emitters.begin(), emitters.end());
    }
    for (const std::uint32_t i : emitters) {
        TriangleRecord& triangle = arrays.triangles[i];
        const MaterialRecord& material = arrays.materials[triangle.flags >> kTriangleMaterialShift];
        triangle.light = static_cast<std::uint32_t>(arrays.lights.size());
        LightRecord light{};
        light.kind = shinesOnBothSides(material) ? kLightTriangleTwoSided : kLightTriangle;
        light.a = triangle.v0, light.b = triangle.v1, light.c = triangle.v2;
        const glm::vec3 reach = glm::max(glm::abs(light.a), glm::max(glm::abs(light.b), glm::abs(light.c)));
        light.offset = kOffsetScale * std::max({reach.x, reach.y, reach.z});
        light.color = material.emissive;
        light.index = i;
        arrays.lights.push_back(light);
        arrays.lightPower.push_back(static_cast<float>(power[i]));
        arrays.features.triangleLights = true;
        arrays.features.texturedEmission |= material.emissiveTexture != kNone;
    }
}

/// KHR_lights_punctual: -Z of the node, scale without effect.
glm::vec3 beamDirection(const PunctualLight& light) {
    const glm::dvec3 z(light.worldFromLight[2]);
    const double length = glm::length(z);
    return length > 0 ? glm::vec3(-z / length) : glm::vec3(0, 0, -1);
}

LightRecord punctualRecord(const PunctualLight& light) {
    LightRecord record{};
    record.kind = light.kind == PunctualKind::Point  ? kLightPoint
                  : light.kind == PunctualKind::Spot ? kLightSpot
                                                     : kLightDirectional;
    record.a = glm::vec3(light.worldFromLight[3]);
    record.b = beamDirection(light);
    record.color = light.intensity;
    if (light.kind == PunctualKind::Spot) {
        const float inner = std::cos(light.innerConeAngle), outer = std::cos(light.outerConeAngle);
        record.c.x = 1.0F / std::max(0.001F, inner - outer);
        record.c.y = -outer * record.c.x;
    }
    record.c.z = std::max(light.range, 0.0F);
    return record;
}

double punctualPower(const PunctualLight& light, double radius) {
    const double intensity = luminance(light.intensity);
    switch (light.kind) {
        case PunctualKind::Point:
            return 4 * std::numbers::pi * intensity;
        case PunctualKind::Spot: {
            // The squared ramp between the cones lets a third of its solid angle's light through.
            const double cosines = 2 * std::cos(double{light.innerConeAngle}) + std::cos(double{light.outerConeAngle});
            return 2 * std::numbers::pi * (1 - cosines / 3) * intensity;
        }
        case PunctualKind::Directional:
            return std::numbers::pi * radius * radius * intensity;
    }
    return 0;
}

}  // namespace

float sceneRadius(const SceneArrays& arrays) {
    const float radius = 0.5F * glm::distance(arrays.boundsMin, arrays.boundsMax);
    return radius > 0 ? radius : 1.0F;
}

void flattenLights(const Scene& scene, SceneArrays& arrays) {
    addTriangleLights(arrays);
    for (const PunctualLight& light : scene.lights) {
        if (!(luminance(light.intensity) > 0)) continue;
        arrays.lights.push_back(punctualRecord(light));
        arrays.punctualNames.push_back(light.name);
        arrays.lightPower.push_back(static_cast<float>(punctualPower(light, sceneRadius(arrays))));
        arrays.features.punctualLights = true;
    }
    buildLightTable(arrays);
}

void buildLightTable(SceneArrays& arrays) {
    // A light too dim or too bright for float still has to be chosen now and then.
    std::vector<double> weights(arrays.lightPower.size());
    std::transform(arrays.lightPower.begin(), arrays.lightPower.end(), weights.begin(), [](float power) {
        return std::clamp(double{power}, double{std::numeric_limits<float>::min()},
                          double{std::numeric_limits<float>::max()});
    });
    arrays.lightCdf = inclusiveCdf(weights);
    for (std::size_t i = 0; i < arrays.lights.size(); ++i) arrays.lights[i].pmf = cdfStep(arrays.lightCdf, i);
}

}  // namespace vkpt
