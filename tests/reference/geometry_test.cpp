// Packed directions, bent normals and shading points.
#include "reference/geometry.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "reference/traverse.h"
#include "test_scene.h"

namespace vkpt::reference {
namespace {

TEST(UnpackNormal, DecodesWorkedValues) {
    const auto pack = [](int x, int y) {
        return (static_cast<std::uint32_t>(x) & 0xffffU) | static_cast<std::uint32_t>(y) << 16U;
    };
    EXPECT_LT(glm::distance(unpackNormal(pack(0, 0)), glm::vec3(0, 0, 1)), 1e-6);
    EXPECT_LT(glm::distance(unpackNormal(pack(32767, 0)), glm::vec3(1, 0, 0)), 1e-6);
    EXPECT_LT(glm::distance(unpackNormal(pack(0, -32767)), glm::vec3(0, -1, 0)), 1e-6);
    EXPECT_LT(glm::distance(unpackNormal(pack(32767, 32767)), glm::vec3(0, 0, -1)), 1e-6);
    EXPECT_LT(glm::distance(unpackNormal(pack(16384, 16384)), glm::normalize(glm::vec3(1, 1, 0))), 1e-4);
    // Lower half: (1, -1, -1)/sqrt 3 has p = (1/3, -1/3), folded to (2/3, -2/3).
    EXPECT_LT(glm::distance(unpackNormal(pack(21845, -21845)), glm::normalize(glm::vec3(1, -1, -1))), 1e-4);
}

TEST(UnpackTangent, DecodesWorkedValuesAndHandedness) {
    const auto pack = [](int x, int y) {
        return (static_cast<std::uint32_t>(x) & 0x7fffU) | (static_cast<std::uint32_t>(y) & 0x7fffU) << 15U;
    };
    EXPECT_LT(glm::distance(unpackTangent(pack(16383, 0)), glm::vec4(1, 0, 0, 1)), 1e-6);
    EXPECT_LT(glm::distance(unpackTangent(pack(0, -16383) | 1U << 31U), glm::vec4(0, -1, 0, -1)), 1e-6);
}

TEST(BendNormal, LiftsTheMirrorDirectionAndOnlyWhenItMust) {
    const glm::dvec3 ng(0, 0, 1);
    for (int i = 0; i < 400; ++i) {
        const double a = 0.02 + 0.95 * (i % 20) / 20, tilt = 1.2 * (i / 20) / 20.0;
        const glm::dvec3 wo(std::sqrt(1 - a * a), 0, a), ns(-std::sin(tilt), 0.1, std::cos(tilt));
        const glm::dvec3 n = glm::normalize(ns), bent = bendNormal(wo, n, ng);
        const glm::dvec3 before = 2 * glm::dot(wo, n) * n - wo, after = 2 * glm::dot(wo, bent) * bent - wo;
        EXPECT_NEAR(glm::length(bent), 1, 1e-12);
        EXPECT_GT(glm::dot(bent, wo), 0);
        if (before.z >= 0.01) {
            EXPECT_EQ(bent, n);
        } else {
            EXPECT_GT(after.z, 0.005);
        }
    }
}

/// Two triangles in z = 0 whose vertex normals lean, two-sided.
test::SceneBuilder leaningQuad() {
    test::SceneBuilder builder;
    Material m = test::matte(glm::vec3(1));
    m.doubleSided = true;
    builder.material(m);
    builder.quad(0, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
    builder.scene().meshes[0].primitives[0].normals.assign(4, glm::normalize(glm::vec3(0.2F, 0, 1)));
    return builder;
}

ShadingPoint shade(const SceneArrays& scene, const Ray& ray) {
    const auto hit = closestHit(scene, ray, 0);
    if (!hit) throw std::logic_error("the ray should hit");
    const TriangleRecord& triangle = scene.triangles[hit->triangle];
    return makeShadingPoint(scene, *hit, interpolateAttributes(scene, triangle, hit->barycentrics),
                            -glm::normalize(ray.direction));
}

TEST(ShadingPoint, FacesTheViewerFromBothSides) {
    const SceneArrays scene = leaningQuad().build();
    const ShadingPoint front = shade(scene, {{0.3F, 0.1F, 2}, {0, 0, -1}});
    EXPECT_TRUE(front.front);
    EXPECT_LT(glm::distance(front.position, glm::vec3(0.3F, 0.1F, 0)), 1e-6);
    EXPECT_EQ(front.ng, glm::vec3(0, 0, 1));
    EXPECT_LT(glm::distance(front.ns, glm::normalize(glm::vec3(0.2F, 0, 1))), 1e-4);
    EXPECT_GT(front.rayOrigin.z, 0);
    EXPECT_NEAR(front.rayOrigin.z, kOffsetScale, 1e-9);
    const ShadingPoint back = shade(scene, {{0.3F, 0.1F, -2}, {0, 0, 1}});
    EXPECT_FALSE(back.front);
    EXPECT_EQ(back.ng, glm::vec3(0, 0, -1));
    EXPECT_LT(glm::distance(back.ns, -glm::normalize(glm::vec3(0.2F, 0, 1))), 1e-4);
    EXPECT_LT(back.rayOrigin.z, 0);
}

TEST(ShadingPoint, OfAnInstanceEqualsTheBakedOne) {
    test::SceneBuilder builder = leaningQuad();
    builder.scene().instances.clear();
    for (int i = 0; i < 3; ++i) {
        glm::mat4 m = glm::translate(glm::mat4(1), glm::vec3(3 * i, 1, 0));
        builder.place(0, glm::scale(glm::rotate(m, 0.4F, {0.6F, 0.8F, 0}), {1, 0.5F, 2}));
    }
    FlattenOptions shared, baked;
    shared.instancingThreshold = 1;
    baked.instancing = false;
    const SceneArrays two = builder.build(nullptr, shared), one = builder.build(nullptr, baked);
    ASSERT_FALSE(two.instances.empty());
    for (int i = 0; i < 3; ++i) {
        for (const float side : {-1.0F, 1.0F}) {
            const Ray ray{{3.0F * static_cast<float>(i) + 0.2F, 1.1F, 4 * side}, {0, 0, -side}};
            const ShadingPoint a = shade(two, ray), b = shade(one, ray);
            EXPECT_EQ(a.front, b.front);
            EXPECT_LT(glm::distance(a.position, b.position), 1e-5);
            EXPECT_LT(glm::distance(a.ng, b.ng), 1e-5);
            EXPECT_LT(glm::distance(a.ns, b.ns), 2e-4);
        }
    }
}

/// A normal map of one texel, tilted along +u by `x` and +v by `y` (bytes).
SceneArrays mapped(std::uint32_t x, std::uint32_t y, float scale, float handedness) {
    test::SceneBuilder builder;
    Material m = test::matte(glm::vec3(1));
    m.doubleSided = true;
    m.normalScale = scale;
    m.normalTexture.image = 0;
    builder.material(m);
    builder.scene().images.push_back({"map", 1, 1, {x | y << 8U | 230U << 16U | 255U << 24U}});
    builder.quad(0, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
    builder.scene().meshes[0].primitives[0].tangents.assign(4, glm::vec4(1, 0, 0, handedness));
    return builder.build();
}

TEST(ShadingPoint, NormalMapTiltsAlongTangentAndBitangent) {
    const auto channel = [](std::uint32_t byte) { return 2 * static_cast<float>(byte) / 255 - 1; };
    const Ray ray{{0, 0.1F, 2}, {0, 0, -1}};
    for (const float handedness : {1.0F, -1.0F}) {
        const glm::vec3 ns = shade(mapped(160, 140, 0.5F, handedness), ray).ns;
        const glm::vec3 expected(channel(160) * 0.5F, channel(140) * 0.5F * handedness, channel(230));
        EXPECT_LT(glm::distance(ns, glm::normalize(expected)), 2e-4) << handedness;
    }
}

}  // namespace
}  // namespace vkpt::reference
