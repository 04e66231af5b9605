#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "base/error.h"
#include "base/math.h"
#include "base/memory.h"
#include "scene_builder.h"

namespace vkpt {
namespace {

const glm::mat4 kPlaces[] = {
    glm::mat4(1),
    glm::translate(glm::mat4(1), {1, 2, 3}) * glm::rotate(glm::mat4(1), 0.8F, glm::vec3(1, 2, 3)),
    glm::scale(glm::mat4(1), {-1, 1, 1}),
    glm::rotate(glm::mat4(1), 1.1F, glm::vec3(0, 1, 1)) * glm::scale(glm::mat4(1), {2, -0.5F, 3}),
    glm::scale(glm::mat4(1), {-1, -2, -3}),
    glm::scale(glm::mat4(1), glm::vec3(1e-5F)),
};

Primitive tiltedTriangle() {
    Primitive p = trianglePrimitive();
    p.positions = {{0, 0, 0.2F}, {1, 0.3F, 0}, {-0.1F, 1, 0.4F}};
    const glm::vec3 n = glm::normalize(glm::cross(p.positions[1] - p.positions[0], p.positions[2] - p.positions[0]));
    p.normals.assign(3, n);
    p.tangents.assign(3, glm::vec4(glm::normalize(p.positions[1] - p.positions[0]), -1));
    return p;
}

TEST(FlattenGeometry, BakedTrianglesAreThePlacedOnes) {
    for (const glm::mat4& place : kPlaces) {
        const Primitive p = tiltedTriangle();
        const SceneArrays a = flatten(sceneOf(p, {place}));
        ASSERT_EQ(a.triangles.size(), 1U);
        const TriangleRecord& t = a.triangles[0];
        const std::uint32_t indices[] = {t.i0, t.i1, t.i2};
        const glm::vec3 corners[] = {t.v0, t.v1, t.v2};
        for (int i = 0; i < 3; ++i) {
            // Corners and vertex indices move together where the winding is undone.
            const glm::vec3 expected = place * glm::vec4(p.positions[indices[i]], 1);
            EXPECT_LT(glm::distance(corners[i], expected), 1e-6F * (1 + glm::length(expected)));
            EXPECT_EQ(a.vertices[indices[i]].u0, p.uv0[indices[i]].x);
        }
    }
}

TEST(FlattenGeometry, FrontFacesStayFrontWhateverTheScale) {
    for (const glm::mat4& place : kPlaces) {
        const Primitive p = tiltedTriangle();
        const SceneArrays a = flatten(sceneOf(p, {place}));
        const glm::vec3 expected =
            glm::normalize(glm::transpose(glm::inverse(glm::mat3(place))) * p.normals[0]);  // side by inverse transpose
        EXPECT_GT(glm::dot(faceNormal(a.triangles[0]), expected), 0.99999F);
        EXPECT_GT(glm::dot(unpackNormal(a.vertices[0].normal), expected), 0.99999F);
    }
}

TEST(FlattenGeometry, BitangentsFollowTheSurface) {
    for (const glm::mat4& place : kPlaces) {
        const Primitive p = tiltedTriangle();
        const SceneArrays a = flatten(sceneOf(p, {place}));
        const glm::vec4 t = unpackTangent(a.vertices[0].tangent);
        const glm::vec3 bitangent = t.w * glm::cross(unpackNormal(a.vertices[0].normal), glm::vec3(t));
        // What the surface's own bitangent becomes; only its side is defined under a scale that is not uniform.
        const glm::vec3 carried =
            glm::mat3(place) * (p.tangents[0].w * glm::cross(p.normals[0], glm::vec3(p.tangents[0])));
        EXPECT_GT(glm::dot(bitangent, glm::normalize(carried)), 0.05F);
        EXPECT_GT(glm::dot(glm::vec3(t), glm::normalize(glm::mat3(place) * glm::vec3(p.tangents[0]))), 0.9999F);
    }
}

TEST(FlattenGeometry, DropsAndCountsTrianglesWithoutArea) {
    Primitive p = trianglePrimitive();
    p.positions.push_back({2, 0, 0});
    p.positions.push_back({std::numeric_limits<float>::quiet_NaN(), 0, 0});
    p.positions.push_back({std::numeric_limits<float>::infinity(), 0, 0});
    p.normals.assign(6, {0, 0, 1});
    p.tangents.assign(6, {1, 0, 0, 1});
    p.uv0.resize(6);
    p.triangles = {{0, 1, 3}, {0, 0, 1}, {0, 1, 4}, {0, 1, 2}, {0, 2, 5}};
    const SceneArrays a = flatten(sceneOf(p));
    ASSERT_EQ(a.triangles.size(), 1U);
    EXPECT_EQ(a.droppedTriangles, 4U);
    EXPECT_EQ(a.triangles[0].i2, 2U);
    EXPECT_EQ(a.boundsMax, glm::vec3(1, 1, 0));
    EXPECT_EQ(a.meshRanges.at(0).triangleCount, 1U);
}

TEST(FlattenGeometry, AnInstanceScaledToNothingVanishes) {
    const SceneArrays a = flatten(sceneOf(trianglePrimitive(), {glm::scale(glm::mat4(1), glm::vec3(0))}));
    EXPECT_TRUE(a.triangles.empty());
    EXPECT_EQ(a.droppedTriangles, 1U);
    EXPECT_EQ(a.boundsMin, glm::vec3(0));
}

TEST(FlattenGeometry, AFlatScaleKeepsItsNormals) {
    // Squashed along x: no inverse, but the surface still has a side.
    const SceneArrays a = flatten(sceneOf(trianglePrimitive(), {glm::scale(glm::mat4(1), {2, 2, 0})}));
    ASSERT_EQ(a.triangles.size(), 1U);
    EXPECT_EQ(unpackNormal(a.vertices[0].normal), glm::vec3(0, 0, 1));
}

TEST(FlattenGeometry, VerticesWithoutNormalGetTheFaces) {
    Primitive p = trianglePrimitive();
    p.normals.assign(3, {0, 0, 0});
    p.normals[1] = {1, 0, 0};
    const SceneArrays a = flatten(sceneOf(p));
    EXPECT_EQ(unpackNormal(a.vertices[0].normal), glm::vec3(0, 0, 1));
    EXPECT_EQ(unpackNormal(a.vertices[1].normal), glm::vec3(1, 0, 0));
}

TEST(FlattenGeometry, PrimitiveIdsAreUniqueAndObjectsNamed) {
    Scene scene = sceneOf(gridPrimitive(4), {kPlaces[0], kPlaces[1], kPlaces[2]});
    scene.instances[1].name = "second";
    const SceneArrays a = flatten(scene);
    std::set<std::uint32_t> ids;
    for (const TriangleRecord& t : a.triangles) ids.insert(t.primitive);
    EXPECT_EQ(ids.size(), 96U);
    EXPECT_EQ(a.triangles[0].object, 0U);
    EXPECT_EQ(a.triangles[40].object, 1U);
    EXPECT_EQ(a.objectNames.at(1), "second");
    EXPECT_TRUE(a.instances.empty());
    EXPECT_FALSE(a.features.instances);
}

TEST(FlattenGeometry, VertexExtrasOnlyWhereSomethingReadsThem) {
    EXPECT_TRUE(flatten(sceneOf(trianglePrimitive())).vertexExtras.empty());
    Primitive p = trianglePrimitive();
    p.colors.assign(3, {1, 0.5F, 0, 0.25F});
    p.uv1 = {{5, 6}, {7, 8}, {9, 10}};
    Scene scene = sceneOf(p);
    scene.meshes[0].primitives.push_back(trianglePrimitive());
    const SceneArrays a = flatten(scene);
    ASSERT_EQ(a.vertexExtras.size(), 6U);
    EXPECT_TRUE(a.features.vertexExtras);
    EXPECT_EQ(a.vertexExtras[1].u1, 7);
    EXPECT_EQ(a.vertexExtras[0].colorRG, 65535U | 32768U << 16U);
    EXPECT_EQ(a.vertexExtras[0].colorBA, 16384U << 16U);
    EXPECT_EQ(a.vertexExtras[4].colorRG, 0xffffffffU);  // white where a primitive has no colours
    EXPECT_NE(a.materials[0].flags & kMaterialVertexColor, 0U);
}

// ---- instancing -----------------------------------------------------------------------------------------------------

constexpr FlattenOptions kShareAlways{.instancing = true, .instancingThreshold = 1};

/// World-space corners of every triangle, however it is stored.
std::vector<std::array<glm::vec3, 3>> worldTriangles(const SceneArrays& a) {
    std::vector<std::array<glm::vec3, 3>> result;
    const auto place = [](const InstanceRecord& i, const glm::vec3& p) {
        const glm::vec4 h(p, 1);
        return glm::vec3(glm::dot(i.worldFromObject[0], h), glm::dot(i.worldFromObject[1], h),
                         glm::dot(i.worldFromObject[2], h));
    };
    if (a.instances.empty()) {
        for (const TriangleRecord& t : a.triangles) result.push_back({t.v0, t.v1, t.v2});
    }
    for (std::size_t k = 0; k < a.instances.size(); ++k) {
        const MeshRange& range = a.meshRanges[a.instanceMesh[k]];
        for (std::uint32_t i = range.firstTriangle; i < range.firstTriangle + range.triangleCount; ++i) {
            const TriangleRecord& t = a.triangles[i];
            result.push_back({place(a.instances[k], t.v0), place(a.instances[k], t.v1), place(a.instances[k], t.v2)});
        }
    }
    return result;
}

Scene manyPlaces() {
    Scene scene = sceneOf(gridPrimitive(3), {kPlaces[1], kPlaces[2], kPlaces[3], kPlaces[4], kPlaces[5]});
    scene.meshes.push_back({"single", {trianglePrimitive()}});
    scene.instances.push_back({"single", 1, kPlaces[1]});
    return scene;
}

TEST(Instancing, StoresEachMeshOnceAHandAndPlacesTheSameTriangles) {
    const Scene scene = manyPlaces();
    const SceneArrays shared = flatten(scene, kShareAlways), baked = flatten(scene, {.instancing = false});
    EXPECT_TRUE(shared.features.instances);
    EXPECT_FALSE(baked.features.instances);
    ASSERT_EQ(shared.meshRanges.size(), 3U);  // baked, the mesh, its mirror image
    EXPECT_EQ(shared.meshRanges[0].triangleCount, 1U);
    EXPECT_EQ(shared.triangles.size(), 1 + 2 * 18U);
    EXPECT_EQ(shared.instances.size(), 6U);
    EXPECT_EQ(shared.instanceMesh[0], 0U);

    auto a = worldTriangles(shared), b = worldTriangles(baked);
    ASSERT_EQ(a.size(), b.size());
    const auto centre = [](const auto& t) { return (t[0] + t[1] + t[2]) / 3.0F; };
    for (const auto& t : a) {  // every triangle has its twin, with the same orientation
        const glm::vec3 n = glm::normalize(glm::cross(t[1] - t[0], t[2] - t[0]));
        EXPECT_TRUE(std::any_of(b.begin(), b.end(), [&](const auto& other) {
            const glm::vec3 m = glm::normalize(glm::cross(other[1] - other[0], other[2] - other[0]));
            return glm::distance(centre(t), centre(other)) < 1e-5F && glm::dot(n, m) > 0.999F;
        }));
    }
    EXPECT_LT(glm::distance(shared.boundsMin, baked.boundsMin), 1e-4F);
    EXPECT_LT(glm::distance(shared.boundsMax, baked.boundsMax), 1e-4F);
}

TEST(Instancing, PlacementsKeepTheirOrientationAndInvert) {
    const SceneArrays a = flatten(manyPlaces(), kShareAlways);
    for (const InstanceRecord& i : a.instances) {
        glm::mat4 world(1), object(1);
        for (int r = 0; r < 3; ++r) {
            for (int c = 0; c < 4; ++c) world[c][r] = i.worldFromObject[r][c], object[c][r] = i.objectFromWorld[r][c];
        }
        EXPECT_GT(glm::determinant(glm::dmat4(world)), 0);
        const glm::mat4 product = object * world;
        for (int k = 0; k < 4; ++k) EXPECT_LT(glm::distance(product[k], glm::mat4(1)[k]), 1e-4F);
    }
}

TEST(Instancing, WithoutBakedGeometryNoInstancePlacesTheEmptyRange) {
    const SceneArrays a = flatten(sceneOf(gridPrimitive(3), {kPlaces[0], kPlaces[1]}), kShareAlways);
    EXPECT_EQ(a.meshRanges.at(0).triangleCount, 0U);
    EXPECT_EQ(a.instanceMesh, (std::vector<std::uint32_t>{1, 1}));
    EXPECT_EQ(a.instances[1].object, 1U);
}

TEST(Instancing, StartsAtTheThreshold) {
    const Scene scene = sceneOf(gridPrimitive(3), {kPlaces[0], kPlaces[1]});  // 18 triangles more if baked
    EXPECT_TRUE(flatten(scene, {.instancing = true, .instancingThreshold = 18}).features.instances);
    EXPECT_FALSE(flatten(scene, {.instancing = true, .instancingThreshold = 19}).features.instances);
}

TEST(Instancing, EmissiveMeshesAreBaked) {
    Scene scene = sceneOf(gridPrimitive(3), {kPlaces[0], kPlaces[1]});
    scene.materials[0].emissive = {1, 0, 0};
    const SceneArrays a = flatten(scene, kShareAlways);
    EXPECT_FALSE(a.features.instances);
    EXPECT_EQ(a.lights.size(), 36U);
}

// Emissive meshes are baked at each place, so a small file may ask for more than any machine has.
TEST(Instancing, MoreThanMemoryHoldsIsRefusedBeforeItIsTaken) {
    Scene scene = sceneOf(gridPrimitive(100));
    scene.materials[0].emissive = glm::vec3(1);
    const auto faultOf = [&](std::uint64_t triangles) {
        scene.instances.resize(triangles / 20000 + 1, scene.instances[0]);
        try {
            (void)flatten(scene);
        } catch (const FileError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    const std::uint64_t tooMany = physicalMemory() / sizeof(TriangleRecord);
    if (tooMany < 0xffffffffU) {
        EXPECT_TRUE(faultOf(tooMany).starts_with("memory.gltf: geometry: ")) << faultOf(tooMany);
    }
    EXPECT_EQ(faultOf(0xffffffffU), "memory.gltf: geometry: more than 2^32 vertices or triangles; split the scene");
}

TEST(Instancing, DropsAPlacementWithoutAnInverse) {
    const SceneArrays a =
        flatten(sceneOf(gridPrimitive(3), {kPlaces[0], kPlaces[1], glm::scale(glm::mat4(1), {1, 0, 1})}), kShareAlways);
    EXPECT_EQ(a.instances.size(), 2U);
    EXPECT_EQ(a.droppedInstances, 1U);
}

TEST(FlattenGeometry, AMillionTrianglesInParallelComeInOrder) {
    const SceneArrays a = flatten(sceneOf(gridPrimitive(708)));
    ASSERT_EQ(a.triangles.size(), 2U * 708 * 708);
    for (std::size_t i = 0; i < a.triangles.size(); i += 997) ASSERT_EQ(a.triangles[i].primitive, i);
}

}  // namespace
}  // namespace vkpt
