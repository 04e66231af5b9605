// Closest and any hit on the device against the reference's own traversal of the same tree.
#include "reference/traverse.h"

#include "bvh/build.h"
#include "bvh/rays.h"
#include "bvh/soups.h"
#include "wavefront/probe_scene.h"
#include "wavefront/random_inputs.h"
#include "wavefront/test_scenes.h"

namespace vkpt {
namespace {

using TraverseProbe = GpuTest;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct In {
    glm::vec3 origin;
    float tMax;
    glm::vec3 direction;
    std::uint32_t key;
};
struct Out {
    float t;
    std::uint32_t slot;
    float b1, b2;
    std::uint32_t instance, any;
    glm::uvec2 unused;
};

std::vector<In> inputsOf(const std::vector<Ray>& rays) {
    std::vector<In> inputs;
    for (const Ray& ray : rays) inputs.push_back({glm::vec3(ray.origin), kInfinity, glm::vec3(ray.direction), 0});
    return inputs;
}

struct Counts {
    int hits = 0, edges = 0;
};

/// Whether rounding may decide what is hit: the ray passes within `margin` of an edge, in barycentrics.
bool isNearEdge(float b1, float b2, float margin) { return std::min({b1, b2, 1 - b1 - b2}) < margin; }

/// What t is off by where the corners' depths, of which it is a weighted mean, round by a few ulps.
double depthError(const SceneArrays& arrays, const In& in, std::uint32_t slot) {
    const TriangleRecord& t = arrays.triangles[slot];
    double reach = 0;
    for (const glm::vec3& v : {t.v0, t.v1, t.v2})
        reach = std::max(reach, glm::length(glm::dvec3(v) - glm::dvec3(in.origin)));
    return 1e-6 * reach / glm::length(glm::dvec3(in.direction));
}

struct Tolerance {
    double relative = 1e-4;  ///< of t, and tenfold of the barycentrics
    float edge = 1e-4F;      ///< how near an edge rounding may decide
    bool worldDepth = true;  ///< corners are in world space
};

/// Every ray meets the same triangle at the same distance on both sides, but for rays through edges: those are counted.
/// Of triangles at equal t both name the same one.
Counts compareHits(const SceneArrays& arrays, const std::vector<In>& inputs, const std::vector<Out>& out,
                   const Tolerance& tolerance) {
    Counts counts;
    for (std::size_t i = 0; i < inputs.size() && !testing::Test::HasFailure(); ++i) {
        SCOPED_TRACE(i);
        const In& in = inputs[i];
        const Out& o = out[i];
        const reference::Ray ray{in.origin, in.direction};
        const auto expected = reference::closestHit(arrays, ray, in.key);
        const bool hit = o.slot != kNone;
        EXPECT_EQ(o.any != 0, hit) << "any hit and closest hit disagree";
        if (!hit && !expected) continue;
        const std::uint32_t instance = !expected || expected->instance == kNone ? 0 : expected->instance;
        const double depth = tolerance.worldDepth ? depthError(arrays, in, hit ? o.slot : expected->triangle) : 0;
        const bool sameT = hit && expected && isNear(o.t, expected->t, depth, tolerance.relative);
        if (hit && expected && o.slot == expected->triangle && o.instance == instance) {
            ++counts.hits;
            EXPECT_TRUE(sameT) << o.t << " instead of " << expected->t;
            const glm::vec2 b12(expected->barycentrics.y, expected->barycentrics.z);
            EXPECT_TRUE(isNear(glm::vec2(o.b1, o.b2), b12, 10 * tolerance.relative));
            EXPECT_TRUE(reference::anyHit(arrays, ray, kInfinity, in.key));
            continue;
        }
        ++counts.edges;
        const bool edge = (hit && isNearEdge(o.b1, o.b2, tolerance.edge)) ||
                          (expected && isNearEdge(expected->barycentrics.y, expected->barycentrics.z, tolerance.edge));
        EXPECT_TRUE(edge || sameT) << "device: slot " << o.slot << " t " << o.t << "; reference: slot "
                                   << (expected ? expected->triangle : kNone) << " t " << (expected ? expected->t : 0);
    }
    return counts;
}

/// Share of rays at the inside of triangles that may still pass an edge nearer than rounding.
double edgeShare(const std::string& set) {
    if (set == "far from the origin") return 0.05;  // corners snap to a grid of 0.25 and meet in points
    if (set == "nested") return 0.1;                // most of it is smaller than the rounding of any ray
    return 0.004;
}

TEST_F(TraverseProbe, SoupsAndMeshesOfEveryKindEqualReference) {
    Fetch form = Fetch::Storage;
    for (const NamedTriangles& set : allSets()) {
        if (set.name == "line") continue;  // no areas: flatten drops such triangles, their hits are noise
        SCOPED_TRACE(set.name);
        SceneArrays arrays = sceneOf(set.triangles);
        buildBvh(arrays);
        const bool thin = set.name == "slivers" || set.name == "nested";
        const auto inputs = inputsOf(raysAt(set.triangles, 1000, Aim::Inside));
        form = form == Fetch::Texel ? Fetch::Storage : Fetch::Texel;  // in turn: compiling twenty times costs enough
        const ProbeScene scene(arrays);
        const auto out = evaluate<Out>("traverse", inputs, scene.options(form));
        const Counts counts = compareHits(arrays, inputs, out, thin ? Tolerance{3e-2, 0.02F} : Tolerance{});
        EXPECT_LE(counts.edges, static_cast<int>(static_cast<double>(inputs.size()) * edgeShare(set.name)));
    }
}

TEST_F(TraverseProbe, OfTrianglesAtEqualDistanceTheLowestPrimitiveWins) {
    SceneArrays arrays = sceneOf(duplicates(40, 30));
    const Triangles before = arrays.triangles;
    buildBvh(arrays);
    const auto inputs = inputsOf(raysAt(before, 2000, Aim::Inside));
    const auto out = ProbeScene(arrays).evaluate<Out>("traverse", inputs);
    int hits = 0;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const auto expected = reference::closestHit(arrays, {inputs[i].origin, inputs[i].direction}, 0);
        ASSERT_EQ(out[i].slot, expected ? expected->triangle : kNone) << i;
        if (!expected) continue;
        ASSERT_LT(arrays.triangles[out[i].slot].primitive, 40U) << "a copy won over the first of its kind";
        ++hits;
    }
    EXPECT_GT(hits, 1000);
}

/// Rays through the foliage in all directions, each with an alpha key of its own.
std::vector<In> raysThrough(const SceneArrays& arrays, int count, std::uint32_t seed) {
    std::vector<In> inputs;
    RandomInputs random(seed);
    const glm::vec3 middle = 0.5F * (arrays.boundsMin + arrays.boundsMax), reach = arrays.boundsMax - middle;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 target = middle + reach * random.inBox(glm::vec3(-0.8F), glm::vec3(0.8F));
        const glm::vec3 origin = middle + 2.0F * glm::length(reach) * random.direction();
        inputs.push_back({origin, kInfinity, target - origin, random.bits()});
    }
    return inputs;
}

TEST_F(TraverseProbe, AlphaDecisionsEqualReference) {
    const SceneArrays arrays = makeArrays(makeFoliage(), {.instancing = false});
    ASSERT_TRUE(arrays.features.alpha && arrays.instances.empty());
    const auto inputs = raysThrough(arrays, 6000, 60);
    const Counts counts = compareHits(arrays, inputs, ProbeScene(arrays).evaluate<Out>("traverse", inputs), {});
    EXPECT_GT(counts.hits, 2000);
    EXPECT_LE(counts.edges, 6);
}

TEST_F(TraverseProbe, TwoLevelsWithAlphaEqualReference) {
    const SceneArrays arrays = makeArrays(makeFoliage(), {.instancing = true, .instancingThreshold = 0});
    ASSERT_TRUE(arrays.features.alpha && arrays.features.instances);
    const auto inputs = raysThrough(arrays, 6000, 61);
    const Counts counts =
        compareHits(arrays, inputs, ProbeScene(arrays).evaluate<Out>("traverse", inputs), {2e-4, 1e-4F, false});
    EXPECT_GT(counts.hits, 2000);
    EXPECT_LE(counts.edges, 6);
}

/// Rays at points of placed patches.
std::vector<In> raysAtInstances(const SceneArrays& arrays, int count, std::uint32_t seed) {
    RandomInputs random(seed);
    std::vector<In> inputs;
    for (int i = 0; i < count; ++i) {
        const InstanceRecord& r = arrays.instances[random.below(static_cast<std::uint32_t>(arrays.instances.size()))];
        const glm::vec3 local(random.between(-1, 1), random.between(-1, 1), 0.1F);
        const glm::vec3 target = reference::transformPoint(r.worldFromObject, local);
        const glm::vec3 origin = target + 5.0F * random.direction();
        inputs.push_back({origin, kInfinity, target - origin, 0});
    }
    return inputs;
}

TEST_F(TraverseProbe, TwoLevelsOfUnevenlyScaledInstancesEqualReference) {
    const SceneArrays arrays = makeArrays(makePatches(), {.instancing = true, .instancingThreshold = 0});
    const auto inputs = raysAtInstances(arrays, 6000, 62);
    const Counts counts =
        compareHits(arrays, inputs, ProbeScene(arrays).evaluate<Out>("traverse", inputs), {2e-4, 1e-3F, false});
    EXPECT_GT(counts.hits, 1500);
    EXPECT_LE(counts.edges, 12);
}

TEST_F(TraverseProbe, OfInstancesAtEqualDistanceTheFirstWins) {
    Scene scene;
    scene.materials.push_back(makeMaterial({1, 1, 1}, 0, 1));
    // Enough copies to fill several nodes, which rays of opposite directions visit in opposite order.
    addObject(scene, makePatch(3, 0), std::vector<glm::mat4>(60, makeTransform({1, 2, 3}, 30, {1, 1, 0}, {2, 1, 1})));
    const SceneArrays arrays = makeArrays(scene, {.instancing = true, .instancingThreshold = 0});
    const auto inputs = raysAtInstances(arrays, 3000, 64);
    const auto out = ProbeScene(arrays).evaluate<Out>("traverse", inputs);
    int hits = 0, others = 0;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const auto expected = reference::closestHit(arrays, {inputs[i].origin, inputs[i].direction}, 0);
        if (!expected || out[i].slot == kNone) continue;
        ++hits;
        others += out[i].instance != 0 || expected->instance != 0 ? 1 : 0;
    }
    EXPECT_GT(hits, 700);
    EXPECT_EQ(others, 0);
}

TEST_F(TraverseProbe, AHitAtTheEndOfTheRayDoesNotCount) {
    const SceneArrays arrays = makeArrays(makeFoliage(), {.instancing = false});
    const ProbeScene scene(arrays);
    auto inputs = raysThrough(arrays, 3000, 63);
    const auto open = scene.evaluate<Out>("traverse", inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i)
        if (open[i].slot != kNone) inputs[i].tMax = i % 2 == 0 ? open[i].t : std::nextafter(open[i].t, kInfinity);
    const auto ended = scene.evaluate<Out>("traverse", inputs);
    int hits = 0;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (open[i].slot == kNone) continue;
        ++hits;
        ASSERT_EQ(ended[i].slot, i % 2 == 0 ? kNone : open[i].slot) << i;
        ASSERT_EQ(ended[i].any, i % 2) << i;
    }
    EXPECT_GT(hits, 100);
}

}  // namespace
}  // namespace vkpt
