// Traversal and triangle test: watertightness, brute force, ties, instances, sides and alpha.
#include "reference/traverse.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "reference/hash.h"
#include "reference/intersect.h"
#include "reference/material.h"
#include "test_scene.h"

namespace vkpt::reference {
namespace {

using test::SceneBuilder;

glm::vec3 randomPoint(std::uint32_t i, std::uint32_t salt, float half = 1) {
    const glm::uvec4 h = hash({i, salt, 0, 1});
    return (glm::vec3(toUnit(h.x), toUnit(h.y), toUnit(h.z)) * 2.0F - 1.0F) * half;
}

Primitive flatPrimitive(std::vector<glm::vec3> positions, std::vector<glm::uvec3> triangles) {
    Primitive p;
    p.normals.assign(positions.size(), glm::vec3(0, 0, 1));
    p.positions = std::move(positions);
    p.triangles = std::move(triangles);
    return p;
}

/// Unit sphere of latitude and longitude bands, closed, fronts outwards.
Primitive sphere(std::uint32_t bands) {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;
    const std::uint32_t columns = 2 * bands;
    for (std::uint32_t i = 0; i <= bands; ++i) {
        for (std::uint32_t j = 0; j < columns; ++j) {
            const double theta = glm::pi<double>() * i / bands, phi = 2 * glm::pi<double>() * j / columns;
            const double sine = i == 0 || i == bands ? 0 : std::sin(theta);
            positions.emplace_back(sine * std::cos(phi), std::cos(theta), -sine * std::sin(phi));
        }
    }
    for (std::uint32_t i = 0; i < bands; ++i) {
        for (std::uint32_t j = 0; j < columns; ++j) {
            const std::uint32_t k = (j + 1) % columns, row = i * columns, next = row + columns;
            if (i > 0) triangles.emplace_back(row + j, next + j, row + k);
            if (i + 1 < bands) triangles.emplace_back(row + k, next + j, next + k);
        }
    }
    Primitive p = flatPrimitive(positions, triangles);
    p.normals = positions;
    return p;
}

/// The nearest hit among all triangles by the triangle test alone.
std::optional<Hit> bruteForce(const SceneArrays& scene, const Ray& ray) {
    const ShearedRay sheared(ray);
    std::optional<Hit> best;
    for (std::uint32_t i = 0; i < scene.triangles.size(); ++i) {
        const TriangleRecord& t = scene.triangles[i];
        const auto hit = sheared.intersect(t.v0, t.v1, t.v2);
        if (!hit || ((t.flags & kTriangleSingleSided) != 0 && !hit->front)) continue;
        const bool nearer =
            !best || hit->t < best->t || (hit->t == best->t && t.primitive < scene.triangles[best->triangle].primitive);
        if (nearer) best = Hit{hit->t, hit->barycentrics, i, kNone};
    }
    return best;
}

void expectEqualsBruteForce(const SceneArrays& scene, const Ray& ray) {
    const auto expected = bruteForce(scene, ray), hit = closestHit(scene, ray, 0);
    ASSERT_EQ(hit.has_value(), expected.has_value());
    EXPECT_EQ(anyHit(scene, ray, INFINITY, 0), expected.has_value());
    if (!hit) return;
    EXPECT_EQ(hit->t, expected->t);
    EXPECT_EQ(hit->triangle, expected->triangle);
    EXPECT_TRUE(anyHit(scene, ray, expected->t * 1.01F, 0));
    EXPECT_FALSE(anyHit(scene, ray, expected->t, 0)) << "t < tMax is strict";
}

TEST(TriangleTest, GivesDistanceBarycentricsAndSide) {
    const Ray ray{{0.2F, 0.3F, 4}, {0, 0, -2}};
    const auto front = ShearedRay(ray).intersect({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    ASSERT_TRUE(front);
    EXPECT_FLOAT_EQ(front->t, 2);
    EXPECT_LT(glm::distance(front->barycentrics, glm::vec3(0.5F, 0.2F, 0.3F)), 1e-6);
    EXPECT_TRUE(front->front);
    EXPECT_FALSE(ShearedRay(ray).intersect({0, 0, 0}, {0, 1, 0}, {1, 0, 0})->front);
    EXPECT_FALSE(ShearedRay(ray).intersect({0, 0, 5}, {1, 0, 5}, {0, 1, 5})) << "behind the origin";
    EXPECT_FALSE(ShearedRay(ray).intersect({0, 0, 4}, {1, 0, 4}, {0, 1, 4})) << "t = 0 is no hit";
}

TEST(Traversal, EqualsBruteForceOnTriangleSoup) {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;
    for (std::uint32_t i = 0; i < 600; ++i) {
        const glm::vec3 centre = randomPoint(i, 1, 3);
        for (std::uint32_t k = 0; k < 3; ++k) positions.push_back(centre + randomPoint(3 * i + k, 2, 0.7F));
        triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    SceneBuilder builder;
    Material twoSided = test::matte(glm::vec3(1));
    twoSided.doubleSided = true;
    builder.material(twoSided);
    const SceneArrays scene = builder.mesh({flatPrimitive(positions, triangles)}, glm::mat4(1)).build();
    for (std::uint32_t i = 0; i < 4000; ++i) {
        expectEqualsBruteForce(scene, {randomPoint(i, 3, 4), glm::normalize(randomPoint(i, 4))});
    }
    for (int axis = 0; axis < 3; ++axis) {  // directions with zero components
        for (std::uint32_t i = 0; i < 300; ++i) {
            glm::vec3 d(0);
            d[axis] = (i & 1U) != 0 ? 1.0F : -1.0F;
            expectEqualsBruteForce(scene, {randomPoint(i, 5, 4), d});
        }
    }
}

// Rays from within a closed mesh through its very vertices and edges, where rounding decides; near and far from 0.
TEST(Traversal, ClosedMeshesDoNotLeakAtEdgesAndVertices) {
    for (const glm::vec3 centre : {glm::vec3(0), glm::vec3(1000, -300, 77)}) {
        SceneBuilder builder;
        Material twoSided = test::matte(glm::vec3(1));
        twoSided.doubleSided = true;
        builder.material(twoSided);
        const SceneArrays scene = builder.mesh({sphere(24)}, glm::translate(glm::mat4(1), centre)).build();
        for (std::uint32_t i = 0; i < scene.triangles.size(); ++i) {
            const TriangleRecord& t = scene.triangles[i];
            const glm::vec3 origin = centre + randomPoint(i, 6, 0.5F);
            for (const glm::vec3& target : {t.v0, t.v1, t.v2, (t.v0 + t.v1) / 2.0F, t.v1 * 0.3F + t.v2 * 0.7F}) {
                ASSERT_TRUE(closestHit(scene, {origin, target - origin}, 0)) << i;
                ASSERT_TRUE(closestHit(scene, {origin, glm::normalize(target - origin)}, 0)) << i;
                ASSERT_TRUE(anyHit(scene, {centre, target - centre}, 2, 0)) << i;
            }
        }
    }
}

// A grid in a plane of constant z, hit along -z through its shared vertices: no padding but the box test's own helps.
TEST(Traversal, FlatGridsDoNotLeak) {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;
    constexpr std::uint32_t kSide = 17;
    for (std::uint32_t y = 0; y < kSide; ++y) {
        for (std::uint32_t x = 0; x < kSide; ++x) positions.emplace_back(x / 7.0F, y / 7.0F, 0.1F);
    }
    for (std::uint32_t y = 0; y + 1 < kSide; ++y) {
        for (std::uint32_t x = 0; x + 1 < kSide; ++x) {
            const std::uint32_t i = y * kSide + x;
            triangles.emplace_back(i, i + 1, i + kSide);
            triangles.emplace_back(i + 1, i + kSide + 1, i + kSide);
        }
    }
    SceneBuilder builder;
    builder.material(test::matte(glm::vec3(1)));
    const SceneArrays scene = builder.mesh({flatPrimitive(positions, triangles)}, glm::mat4(1)).build();
    for (const glm::vec3& p : positions) {
        EXPECT_TRUE(closestHit(scene, {{p.x, p.y, 3}, {0, 0, -1}}, 0)) << p.x << " " << p.y;
        EXPECT_FALSE(closestHit(scene, {{p.x, p.y, -3}, {0, 0, 1}}, 0)) << "single-sided from behind";
    }
}

TEST(Traversal, OfEqualDistancesTheLowerPrimitiveWins) {
    const std::vector<glm::vec3> corners{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
    const std::vector<glm::uvec3> copies(40, glm::uvec3(0, 1, 2));
    SceneBuilder builder;
    builder.material(test::matte(glm::vec3(1)));
    const SceneArrays scene = builder.mesh({flatPrimitive(corners, copies)}, glm::mat4(1)).build();
    for (std::uint32_t i = 0; i < 50; ++i) {
        const auto hit = closestHit(scene, {randomPoint(i, 7, 0.2F) + glm::vec3(0, 0, 2), {0, 0, -1}}, 0);
        ASSERT_TRUE(hit);
        EXPECT_EQ(scene.triangles[hit->triangle].primitive, 0U);
    }
}

TEST(Traversal, InstancesEqualTheSameGeometryBaked) {
    SceneBuilder builder;
    builder.material(test::matte(glm::vec3(1)));
    builder.mesh({sphere(6)}, glm::mat4(1));
    for (std::uint32_t i = 0; i < 30; ++i) {
        glm::mat4 m = glm::translate(glm::mat4(1), randomPoint(i, 8, 6));
        m = glm::rotate(m, static_cast<float>(i), glm::normalize(randomPoint(i, 9)));
        builder.place(0, glm::scale(m, {0.5F, i % 3 == 0 ? -0.8F : 0.8F, 1.1F}));
    }
    FlattenOptions shared, baked;
    shared.instancingThreshold = 1;
    baked.instancing = false;
    const SceneArrays two = builder.build(nullptr, shared), one = builder.build(nullptr, baked);
    ASSERT_FALSE(two.instances.empty());
    ASSERT_TRUE(one.instances.empty());
    std::uint32_t hits = 0;
    for (std::uint32_t i = 0; i < 4000; ++i) {
        const Ray ray{randomPoint(i, 10, 9), glm::normalize(randomPoint(i, 11))};
        const auto a = closestHit(two, ray, 0), b = closestHit(one, ray, 0);
        if (a.has_value() != b.has_value()) {
            ADD_FAILURE() << "ray " << i;
            continue;
        }
        EXPECT_EQ(a.has_value(), anyHit(two, ray, INFINITY, 0));
        if (!a) continue;
        ++hits;
        EXPECT_NEAR(a->t, b->t, 2e-5) << i;
    }
    EXPECT_GT(hits, 300U);
}

TEST(Traversal, AnEmptySceneIsEmpty) {
    SceneBuilder builder;
    const SceneArrays scene = builder.build();
    EXPECT_FALSE(closestHit(scene, {{0, 0, 0}, {0, 0, 1}}, 0));
    EXPECT_FALSE(anyHit(scene, {{0, 0, 0}, {0, 0, 1}}, INFINITY, 0));
}

SceneArrays alphaQuad(AlphaMode mode, float alpha) {
    SceneBuilder builder;
    Material m = test::matte(glm::vec3(1));
    m.alphaMode = mode;
    m.baseColor.a = alpha;
    builder.material(m);
    return builder.quad(0, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}).build();
}

TEST(AlphaTest, BlendPassesItsShareAndMaskItsCutoff) {
    for (const float alpha : {0.0F, 0.3F, 1.0F}) {
        const SceneArrays scene = alphaQuad(AlphaMode::Blend, alpha);
        double hits = 0;
        constexpr std::uint32_t kRays = 20000;
        for (std::uint32_t i = 0; i < kRays; ++i) {
            hits += closestHit(scene, {{0.1F, 0.2F, 1}, {0, 0, -1}}, alphaKey({i, 0, 1, 0}, 0, kRayPath)) ? 1 : 0;
        }
        const double a = double{alpha};
        EXPECT_NEAR(hits / kRays, a, 4 * std::sqrt(a * (1 - a) / kRays)) << alpha;
    }
    for (const float alpha : {0.49F, 0.5F, 0.51F}) {
        const SceneArrays scene = alphaQuad(AlphaMode::Mask, alpha);
        EXPECT_EQ(anyHit(scene, {{0, 0.1F, 1}, {0, 0, -1}}, INFINITY, 1), alpha >= 0.5F) << alpha;
    }
}

}  // namespace
}  // namespace vkpt::reference
