// Closest and any hit on the device against the reference's own traversal of the same tree.
#include "reference/traverse.h"

#include <cmath>
#include <limits>

#include "bvh/build.h"
#include "verify/context.h"
#include "verify/inputs/random_inputs.h"
#include "verify/inputs/rays.h"
#include "verify/inputs/scenes.h"
#include "verify/inputs/soups.h"
#include "verify/probes.h"
#include "verify/stages/hits.h"

namespace vkpt {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct In {
    glm::vec3 origin;
    float tMax;
    glm::vec3 direction;
    std::uint32_t key;
};
struct Out {
    DeviceHit hit;
    std::uint32_t any;
    glm::uvec2 unused;
};

std::vector<In> inputsOf(const std::vector<Ray>& rays) {
    std::vector<In> inputs;
    for (const Ray& ray : rays) inputs.push_back({glm::vec3(ray.origin), kInfinity, glm::vec3(ray.direction), 0});
    return inputs;
}

/// The inputs of one scene, and their description.
struct Rays {
    std::string scene;
    std::vector<In> inputs;

    [[nodiscard]] Findings::InputScope scope(Findings& findings) const {
        return findings.inputs([this](std::size_t i) {
            const In& in = inputs[i];
            return fmt::format("traverse, {}: from {} along {}, tMax {}, key {}", scene, show(in.origin),
                               show(in.direction), in.tMax, in.key);
        });
    }
};

HitCounts compareHits(Prober& prober, Findings& findings, const SceneArrays& arrays, const Rays& rays,
                      const HitTolerance& tolerance = {}) {
    const auto scope = rays.scope(findings);
    const auto out = ProbeScene(prober, arrays).evaluate<Out>(findings, "traverse", rays.inputs);
    HitCounts counts;
    for (std::size_t i = 0; i < rays.inputs.size(); ++i) {
        findings.at(i);
        const In& in = rays.inputs[i];
        const reference::Ray ray{in.origin, in.direction};
        compareHit(arrays, ray, in.key, out[i].hit, tolerance, findings, counts);
        const bool hit = out[i].hit.slot != kNone;
        findings.equal("any hit", out[i].any != 0, hit);
        const auto closest = reference::closestHit(arrays, ray, in.key);
        findings.equal("the reference's any hit", reference::anyHit(arrays, ray, kInfinity, in.key),
                       closest.has_value());
    }
    return counts;
}

/// Share of rays at the inside of triangles that may still pass an edge nearer than rounding.
double edgeShare(const std::string& set) {
    if (set == "far from the origin") return 0.05;  // corners snap to a grid of 0.25 and meet in points
    if (set == "nested") return 0.1;                // most of it is smaller than the rounding of any ray
    return 0.004;
}

void compareSoups(Prober& prober, Findings& findings) {
    for (const NamedTriangles& set : allSets()) {
        if (set.name == "line") continue;  // no areas: flatten drops such triangles, their hits are noise
        SceneArrays arrays = sceneOf(set.triangles);
        buildBvh(arrays);
        const bool thin = set.name == "slivers" || set.name == "nested";
        const Rays rays{set.name, inputsOf(raysAt(set.triangles, 1000, Aim::Inside))};
        const auto counts =
            compareHits(prober, findings, arrays, rays, thin ? HitTolerance{3e-2, 0.02F} : HitTolerance{});
        findings.atMost("rays at edges: " + set.name, counts.edges,
                        std::floor(static_cast<double>(rays.inputs.size()) * edgeShare(set.name)));
    }
}

/// Of triangles at equal distance the lowest primitive wins.
void compareDuplicates(Prober& prober, Findings& findings) {
    SceneArrays arrays = sceneOf(duplicates(40, 30));
    const Triangles before = arrays.triangles;
    buildBvh(arrays);
    const Rays rays{"duplicates", inputsOf(raysAt(before, 2000, Aim::Inside))};
    const auto scope = rays.scope(findings);
    const auto out = ProbeScene(prober, arrays).evaluate<Out>(findings, "traverse", rays.inputs);
    int hits = 0;
    for (std::size_t i = 0; i < rays.inputs.size(); ++i) {
        findings.at(i);
        const auto expected = reference::closestHit(arrays, {rays.inputs[i].origin, rays.inputs[i].direction}, 0);
        const std::uint32_t slot = out[i].hit.slot;
        if (!findings.equal("slot among equals", slot, expected ? expected->triangle : kNone) || !expected) continue;
        findings.holds("first of its kind", arrays.triangles[slot].primitive < 40, "a copy won");
        ++hits;
    }
    findings.atLeast("hits on duplicates", hits, 1001);
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

void compareAlpha(Prober& prober, Findings& findings) {
    const SceneArrays baked = makeArrays(makeFoliage(), {.instancing = false});
    findings.holds("features of the foliage", baked.features.alpha && baked.instances.empty());
    HitCounts counts = compareHits(prober, findings, baked, {"foliage", raysThrough(baked, 6000, 60)});
    findings.atLeast("hits on foliage", counts.hits, 2001);
    findings.atMost("edges of foliage", counts.edges, 6);

    const SceneArrays placed = makeArrays(makeFoliage(), {.instancing = true, .instancingThreshold = 0});
    findings.holds("features of the instanced foliage", placed.features.alpha && placed.features.instances);
    counts = compareHits(prober, findings, placed, {"instanced foliage", raysThrough(placed, 6000, 61)},
                         {2e-4, 1e-4F, false});
    findings.atLeast("hits on instanced foliage", counts.hits, 2001);
    findings.atMost("edges of instanced foliage", counts.edges, 6);
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

void compareInstances(Prober& prober, Findings& findings) {
    const SceneArrays arrays = makeArrays(makePatches(), {.instancing = true, .instancingThreshold = 0});
    const auto counts =
        compareHits(prober, findings, arrays, {"instances scaled unevenly", raysAtInstances(arrays, 6000, 62)},
                    {2e-4, 1e-3F, false});
    findings.atLeast("hits on instances", counts.hits, 1501);
    findings.atMost("edges of instances", counts.edges, 12);
}

/// Of instances at equal distance the first wins.
void compareCoinciding(Prober& prober, Findings& findings) {
    Scene scene;
    scene.materials.push_back(makeMaterial({1, 1, 1}, 0, 1));
    // Enough copies to fill several nodes, which rays of opposite directions visit in opposite order.
    addObject(scene, makePatch(3, 0), std::vector<glm::mat4>(60, makeTransform({1, 2, 3}, 30, {1, 1, 0}, {2, 1, 1})));
    const SceneArrays arrays = makeArrays(scene, {.instancing = true, .instancingThreshold = 0});
    const Rays rays{"coinciding instances", raysAtInstances(arrays, 3000, 64)};
    const auto scope = rays.scope(findings);
    const auto out = ProbeScene(prober, arrays).evaluate<Out>(findings, "traverse", rays.inputs);
    int hits = 0;
    for (std::size_t i = 0; i < rays.inputs.size(); ++i) {
        findings.at(i);
        const auto expected = reference::closestHit(arrays, {rays.inputs[i].origin, rays.inputs[i].direction}, 0);
        if (!expected || out[i].hit.slot == kNone) continue;
        ++hits;
        findings.equal("instance among equals", out[i].hit.instance, 0U);
        findings.equal("the reference's instance among equals", expected->instance, 0U);
    }
    findings.atLeast("hits on coinciding instances", hits, 701);
}

/// A hit at the end of the ray does not count; one just before it does.
void compareEnds(Prober& prober, Findings& findings) {
    const SceneArrays arrays = makeArrays(makeFoliage(), {.instancing = false});
    const ProbeScene scene(prober, arrays);
    Rays rays{"foliage", raysThrough(arrays, 3000, 63)};
    const auto scope = rays.scope(findings);
    const auto open = scene.evaluate<Out>(findings, "traverse", rays.inputs);
    for (std::size_t i = 0; i < rays.inputs.size(); ++i) {
        const DeviceHit& hit = open[i].hit;
        if (hit.slot != kNone) rays.inputs[i].tMax = i % 2 == 0 ? hit.t : std::nextafter(hit.t, kInfinity);
    }
    const auto ended = scene.evaluate<Out>(findings, "traverse", rays.inputs);
    int hits = 0;
    for (std::size_t i = 0; i < rays.inputs.size(); ++i) {
        if (open[i].hit.slot == kNone) continue;
        findings.at(i);
        ++hits;
        findings.equal("slot at the end", ended[i].hit.slot, i % 2 == 0 ? kNone : open[i].hit.slot);
        findings.equal("any hit at the end", ended[i].any, static_cast<std::uint32_t>(i % 2));
    }
    findings.atLeast("rays that end at a hit", hits, 101);
}

}  // namespace

void checkTraverse(VerifyContext& context, Findings& findings) {
    Prober& prober = context.prober();
    compareSoups(prober, findings);
    compareDuplicates(prober, findings);
    compareAlpha(prober, findings);
    compareInstances(prober, findings);
    compareCoinciding(prober, findings);
    compareEnds(prober, findings);
}

}  // namespace vkpt
