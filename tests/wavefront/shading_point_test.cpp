#include "reference/geometry.h"

#include "wavefront/probe_scene.h"
#include "wavefront/random_inputs.h"
#include "wavefront/test_scenes.h"

namespace vkpt {
namespace {

using ShadingPointProbe = GpuTest;

struct In {
    std::uint32_t slot, instance;
    float b1, b2;
    glm::vec4 wo;
};
struct Out {
    glm::vec3 position;
    float offset;
    glm::vec3 ng;
    float front;
    glm::vec3 ns;
    std::uint32_t light;
    glm::vec4 baseColor;
    glm::vec2 uv0, uv1;
};

/// Random points of random triangles (of their instance, where there are any), seen from both sides, a quarter of them
/// grazing.
std::vector<In> pointsOn(const SceneArrays& arrays, int count, std::uint32_t seed) {
    std::vector<In> inputs;
    RandomInputs random(seed);
    for (int i = 0; i < count; ++i) {
        const auto instances = static_cast<std::uint32_t>(arrays.instances.size());
        const std::uint32_t instance = instances == 0 ? 0 : random.below(instances);
        const MeshRange& range = arrays.meshRanges[instances == 0 ? 0 : arrays.instanceMesh[instance]];
        const float b1 = random.unit(), b2 = random.between(0, 1 - b1);
        inputs.push_back({range.firstTriangle + random.below(range.triangleCount), instance, b1, b2,
                          glm::vec4(random.direction(), 0)});
    }
    return inputs;
}

reference::Hit hitOf(const SceneArrays& arrays, const In& in) {
    reference::Hit hit;
    hit.t = 1;
    hit.barycentrics = {1 - in.b1 - in.b2, in.b1, in.b2};
    hit.triangle = in.slot;
    hit.instance = arrays.instances.empty() ? kNone : in.instance;
    return hit;
}

void comparePoints(const SceneArrays& arrays, const std::vector<In>& inputs) {
    const auto out = ProbeScene(arrays).evaluate<Out>("shading_point", inputs);
    int fronts = 0, bent = 0;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        SCOPED_TRACE(testing::Message() << i << ": slot " << inputs[i].slot << " instance " << inputs[i].instance);
        const reference::Hit hit = hitOf(arrays, inputs[i]);
        const TriangleRecord& triangle = arrays.triangles[hit.triangle];
        const auto attributes = reference::interpolateAttributes(arrays, triangle, hit.barycentrics);
        const glm::vec3 wo(inputs[i].wo);
        const auto p = reference::makeShadingPoint(arrays, hit, attributes, wo);
        if (std::abs(glm::dot(p.ng, wo)) < 1e-5F) continue;  // rounding chooses the side
        const double size = 1 + double{glm::length(p.position)};
        ASSERT_TRUE(isNear(out[i].position, p.position, 1e-6 * size));
        ASSERT_EQ(out[i].front != 0, p.front);
        ASSERT_TRUE(isNear(out[i].ng, p.ng, 2e-6));
        // Bending normalises a sum that may be as short as 0.01.
        ASSERT_TRUE(isNear(out[i].ns, p.ns, 1e-4));
        ASSERT_TRUE(isNear(out[i].position + out[i].ng * out[i].offset, p.rayOrigin, 1e-6 * size));
        ASSERT_TRUE(
            isNear(out[i].offset, glm::length(glm::dvec3(p.rayOrigin) - glm::dvec3(p.position)), 5e-7 * size, 1e-3));
        ASSERT_EQ(out[i].light, triangle.light);
        ASSERT_TRUE(isNear(out[i].uv0, attributes.coords.uv0, 1e-6));
        ASSERT_TRUE(isNear(out[i].uv1, attributes.coords.uv1, 1e-6));
        const auto base = reference::baseColor(arrays, reference::materialOf(arrays, triangle), attributes);
        ASSERT_TRUE(isNear(out[i].baseColor, base, 5e-5));
        fronts += p.front ? 1 : 0;
        const glm::vec3 mirrored = 2 * glm::dot(wo, p.ns) * p.ns - wo;
        ASSERT_GE(glm::dot(mirrored, p.ng), 0) << "the mirror direction goes below the surface";
        bent += glm::dot(mirrored, p.ng) < 0.02F ? 1 : 0;
    }
    EXPECT_GT(fronts, static_cast<int>(inputs.size()) / 3);
    EXPECT_GT(bent, 20) << "too few normals were bent for a test of bending";
}

TEST_F(ShadingPointProbe, BakedGeometryEqualsReference) {
    const SceneArrays arrays = makeArrays(makePatches(), {.instancing = false});
    ASSERT_TRUE(arrays.instances.empty() && arrays.features.normalMaps && arrays.features.vertexExtras);
    comparePoints(arrays, pointsOn(arrays, 6000, 50));
}

TEST_F(ShadingPointProbe, InstancesScaledUnevenlyAndMirroredEqualReference) {
    const SceneArrays arrays = makeArrays(makePatches(), {.instancing = true, .instancingThreshold = 0});
    ASSERT_EQ(arrays.instances.size(), 10U);
    comparePoints(arrays, pointsOn(arrays, 6000, 51));
}

// flatten makes no such record, but the contract covers it: handedness turns with the sign of the determinant.
TEST_F(ShadingPointProbe, RecordsOfNegativeDeterminantEqualReference) {
    SceneArrays arrays = makeArrays(makePatches(), {.instancing = true, .instancingThreshold = 0});
    for (InstanceRecord& r : arrays.instances) {  // world mirrored in x
        r.worldFromObject[0] = -r.worldFromObject[0];
        for (glm::vec4& row : r.objectFromWorld) row.x = -row.x;
    }
    comparePoints(arrays, pointsOn(arrays, 3000, 54));
}

TEST_F(ShadingPointProbe, SecondTextureSetIsTheOriginWhereTheSceneHasNone) {
    Scene scene = makePatches();
    for (Mesh& mesh : scene.meshes) {
        mesh.primitives[0].uv1.clear();
        mesh.primitives[0].colors.clear();
    }
    const SceneArrays arrays = makeArrays(scene, {.instancing = false});
    ASSERT_TRUE(arrays.vertexExtras.empty());
    comparePoints(arrays, pointsOn(arrays, 1000, 52));
}

TEST_F(ShadingPointProbe, TriangleLightsAreFoundFromTheirTriangles) {
    const SceneArrays arrays = makeArrays(makeLamps());
    const auto inputs = pointsOn(arrays, 500, 53);
    const auto out = ProbeScene(arrays).evaluate<Out>("shading_point", inputs);
    int lamps = 0;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        ASSERT_EQ(out[i].light, arrays.triangles[inputs[i].slot].light);
        if (out[i].light == kNone) continue;
        ASSERT_EQ(arrays.lights[out[i].light].index, inputs[i].slot);
        ++lamps;
    }
    EXPECT_GT(lamps, 100);
}

}  // namespace
}  // namespace vkpt
