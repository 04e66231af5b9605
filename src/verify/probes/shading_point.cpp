#include "reference/geometry.h"
#include "verify/context.h"
#include "verify/inputs/random_inputs.h"
#include "verify/inputs/scenes.h"
#include "verify/probes.h"

namespace vkpt {
namespace {

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

/// Random points of random triangles (of their instance, where there are any), seen from both sides.
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

struct Counts {
    int fronts = 0, bent = 0;
};

void comparePoint(const SceneArrays& arrays, const In& in, const Out& out, Findings& findings, Counts& counts) {
    const reference::Hit hit = hitOf(arrays, in);
    const TriangleRecord& triangle = arrays.triangles[hit.triangle];
    const auto attributes = reference::interpolateAttributes(arrays, triangle, hit.barycentrics);
    const glm::vec3 wo(in.wo);
    const auto p = reference::makeShadingPoint(arrays, hit, attributes, wo);
    if (std::abs(glm::dot(p.ng, wo)) < 1e-5F) return;  // rounding chooses the side
    const double size = 1 + double{glm::length(p.position)};
    findings.near("position", out.position, p.position, 1e-6 * size);
    findings.equal("front", out.front != 0, p.front);
    findings.near("geometric normal", out.ng, p.ng, 2e-6);
    // Bending normalises a sum that may be as short as 0.01.
    findings.near("shading normal", out.ns, p.ns, 1e-4);
    findings.near("ray origin", out.position + out.ng * out.offset, p.rayOrigin, 1e-6 * size);
    findings.near("offset", out.offset, glm::length(glm::dvec3(p.rayOrigin) - glm::dvec3(p.position)), 5e-7 * size,
                  1e-3);
    findings.equal("light", out.light, triangle.light);
    findings.near("uv0", out.uv0, attributes.coords.uv0, 1e-6);
    findings.near("uv1", out.uv1, attributes.coords.uv1, 1e-6);
    const auto base = reference::baseColor(arrays, reference::materialOf(arrays, triangle), attributes);
    findings.near("base colour", out.baseColor, base, 5e-5);
    const glm::vec3 mirrored = 2 * glm::dot(wo, p.ns) * p.ns - wo;
    findings.holds("mirror direction", glm::dot(mirrored, p.ng) >= 0, "goes below the surface");
    counts.fronts += p.front ? 1 : 0;
    counts.bent += glm::dot(mirrored, p.ng) < 0.02F ? 1 : 0;
}

void comparePoints(Prober& prober, Findings& findings, const char* what, const SceneArrays& arrays, int count,
                   std::uint32_t seed) {
    const auto inputs = pointsOn(arrays, count, seed);
    const auto scope = findings.inputs([&](std::size_t i) {
        const In& in = inputs[i];
        return fmt::format("makeShadingPoint, {}: slot {}, instance {}, b1 {}, b2 {}, wo {}", what, in.slot,
                           in.instance, in.b1, in.b2, show(glm::vec3(in.wo)));
    });
    const auto out = ProbeScene(prober, arrays).evaluate<Out>(findings, "shading_point", inputs);
    Counts counts;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        findings.at(i);
        comparePoint(arrays, inputs[i], out[i], findings, counts);
    }
    findings.atLeast("points seen from the front", counts.fronts, count / 3 + 1);
    findings.atLeast("normals bent", counts.bent, 21);
}

/// flatten makes no such record, but the contract covers it: handedness turns with the sign of the determinant.
SceneArrays mirroredInX(SceneArrays arrays) {
    for (InstanceRecord& r : arrays.instances) {
        r.worldFromObject[0] = -r.worldFromObject[0];
        for (glm::vec4& row : r.objectFromWorld) row.x = -row.x;
    }
    return arrays;
}

Scene withoutExtras(Scene scene) {
    for (Mesh& mesh : scene.meshes) {
        mesh.primitives[0].uv1.clear();
        mesh.primitives[0].colors.clear();
    }
    return scene;
}

/// Triangle lights are found from their triangles.
void compareLights(Prober& prober, Findings& findings) {
    const SceneArrays arrays = makeArrays(makeLamps());
    const auto inputs = pointsOn(arrays, 500, 53);
    const auto scope = findings.inputs([&](std::size_t i) { return fmt::format("lamps: slot {}", inputs[i].slot); });
    const auto out = ProbeScene(prober, arrays).evaluate<Out>(findings, "shading_point", inputs);
    int lamps = 0;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        findings.at(i);
        if (!findings.equal("light", out[i].light, arrays.triangles[inputs[i].slot].light)) continue;
        if (out[i].light == kNone) continue;
        findings.equal("triangle of the light", arrays.lights[out[i].light].index, inputs[i].slot);
        ++lamps;
    }
    findings.atLeast("points on lamps", lamps, 101);
}

}  // namespace

void checkShadingPoint(VerifyContext& context, Findings& findings) {
    Prober& prober = context.prober();
    const SceneArrays baked = makeArrays(makePatches(), {.instancing = false});
    findings.holds("features of the baked patches", baked.instances.empty() &&
                                                        (baked.features.maps & 1U << kMapNormal) != 0 &&
                                                        baked.features.vertexExtras);
    comparePoints(prober, findings, "baked", baked, 6000, 50);

    const SceneArrays placed = makeArrays(makePatches(), {.instancing = true, .instancingThreshold = 0});
    findings.equal("instances of the patches", placed.instances.size(), 10U);
    comparePoints(prober, findings, "instances scaled unevenly and mirrored", placed, 6000, 51);
    comparePoints(prober, findings, "negative determinants", mirroredInX(placed), 3000, 54);

    const SceneArrays plain = makeArrays(withoutExtras(makePatches()), {.instancing = false});
    findings.holds("absence of a second texture set", plain.vertexExtras.empty());
    comparePoints(prober, findings, "without a second texture set", plain, 1000, 52);
    compareLights(prober, findings);
}

}  // namespace vkpt
