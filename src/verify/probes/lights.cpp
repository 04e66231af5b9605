#include "reference/light.h"

#include <array>

#include "scene/environment.h"
#include "verify/context.h"
#include "verify/inputs/random_inputs.h"
#include "verify/inputs/scenes.h"
#include "verify/probes.h"

namespace vkpt {
namespace {

struct In {
    glm::vec3 from;
    float nearness = 0;  ///< to the edge of a light: its length over the distance
    glm::uvec4 bits{0};
};
struct Out {
    glm::vec3 wi;
    float pdf;
    glm::vec3 radiance;
    float infinite;
    glm::vec3 target;
    float delta;
};

std::vector<In> pointsAmong(int count, std::uint32_t seed) {
    std::vector<In> inputs;
    RandomInputs random(seed);
    for (int i = 0; i < count; ++i)
        inputs.push_back({random.inBox({-3, 0, -3}, {3, 3, 3}), 0, {random.bits(), random.bits(), 0, 0}});
    return inputs;
}

/// Points close to the edges of each triangle light, on either side, where it covers half of the view; with numbers
/// that choose it.
std::vector<In> pointsAtEdges(const SceneArrays& arrays, std::uint32_t seed) {
    std::vector<In> inputs;
    RandomInputs random(seed);
    for (std::size_t i = 0; i < arrays.lights.size(); ++i) {
        const LightRecord& light = arrays.lights[i];
        if (light.kind > kLightTriangleTwoSided) continue;
        const float before = i > 0 ? arrays.lightCdf[i - 1] : 0, after = arrays.lightCdf[i];
        const std::array corners = {light.a, light.b, light.c};
        const glm::vec3 normal = glm::normalize(glm::cross(light.b - light.a, light.c - light.a));
        for (std::size_t edge = 0; edge < 3; ++edge)
            for (float nearness = 50; nearness < 4e4F; nearness *= 5)
                for (int k = 0; k < 100; ++k) {
                    const glm::vec3 from = corners[edge], along = corners[(edge + 1) % 3] - from;
                    const float height = glm::length(along) / nearness * (k % 2 == 0 ? 1.0F : -1.0F);
                    const double choice = random.between(before, after);
                    inputs.push_back({from + along * random.between(0.3F, 0.7F) + normal * height,
                                      nearness,
                                      {static_cast<std::uint32_t>(choice * 0x1p32), random.bits(), 0, 0}});
                }
    }
    return inputs;
}

const LightRecord& chosenLight(const SceneArrays& arrays, const In& in) {
    return arrays.lights[reference::sampleTable(arrays.lightCdf, reference::toUnit(in.bits.x)).index];
}

/// Sine of the elevation above the plane of a triangle light, as its first corner sees the point.
double elevationAt(const LightRecord& light, const glm::dvec3& from) {
    const glm::dvec3 a(light.a), n = glm::cross(glm::dvec3(light.b) - a, glm::dvec3(light.c) - a);
    return std::abs(glm::dot(glm::normalize(n), glm::normalize(from - a)));
}

/// Directions: the rounding of the point on the light, 3e-7 of its size, over the distance; beside an edge, that of the
/// directions of corners, magnified by the nearness. The pdf of a triangle is in inverse proportion to its elevation,
/// which is rounded to a few ulps of 1; that of the sky is read from a table.
void compareSample(const LightRecord& light, const reference::LightSample& expected, const In& in, const Out& out,
                   Findings& findings) {
    const bool triangle = light.kind <= kLightTriangleTwoSided, sky = light.kind == kLightEnvironment;
    const double distance = expected.infinite ? 1 : glm::distance(expected.end, in.from);
    const double magnified = 1e-6 * double{in.nearness};
    const double angle = sky ? 2e-5 : 1e-6 + 3e-6 / distance + magnified;
    const double pdfError = triangle ? 1e-6 / elevationAt(light, glm::dvec3(in.from)) : 4 * angle;
    findings.near("wi", out.wi, expected.wi, angle);
    findings.near("pdf", out.pdf, expected.pdf, 0, 1e-5 + pdfError);
    findings.near("radiance", out.radiance, expected.radiance, sky ? 1e-2 : 2e-5, 1e-5 + 4 * angle);
    findings.equal("infinite", out.infinite != 0, expected.infinite);
    findings.equal("delta", out.delta != 0, expected.punctual);
    findings.near("target", out.target, expected.infinite ? expected.wi : expected.end,
                  expected.infinite ? angle : 2e-6 + magnified * distance);
}

/// Counts the samples of each kind that bring light.
using Lit = std::array<int, 6>;

Lit compareSamples(Prober& prober, Findings& findings, const SceneArrays& arrays, const std::vector<In>& inputs) {
    Lit lit{};
    const reference::Lights lights(arrays);
    const auto scope = findings.inputs([&](std::size_t i) {
        return fmt::format("sampleLight from {}, bits {:#x} {:#x}, a light of kind {}", show(inputs[i].from),
                           inputs[i].bits.x, inputs[i].bits.y, chosenLight(arrays, inputs[i]).kind);
    });
    const auto out = ProbeScene(prober, arrays).evaluate<Out>(findings, "lights", inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        findings.at(i);
        const LightRecord& light = chosenLight(arrays, inputs[i]);
        const auto expected = lights.sample(inputs[i].from, inputs[i].bits);
        if (!expected) {
            findings.holds("no light", out[i].radiance == glm::vec3(0) || out[i].pdf <= 0, "there is some");
            continue;
        }
        compareSample(light, *expected, inputs[i], out[i], findings);
        if (glm::length(expected->radiance) > 0) ++lit[light.kind];
    }
    return lit;
}

void compareEveryKind(Prober& prober, Findings& findings) {
    SceneArrays arrays = makeArrays(makeLamps());
    EnvironmentMap map{6, 4, {}};
    RandomInputs random(40);
    for (int i = 0; i < 24; ++i) map.texels.push_back(random.inBox({0, 0, 0}, {1, 1, 1}));
    addEnvironment(arrays, map, 3, 25);
    const Lit beside = compareSamples(prober, findings, arrays, pointsAtEdges(arrays, 44));
    for (const std::uint32_t kind : {kLightTriangle, kLightTriangleTwoSided})
        findings.atLeast("samples lit beside edges", beside[kind], 1000);
    const Lit lit = compareSamples(prober, findings, arrays, pointsAmong(16000, 41));
    for (const int count : lit) findings.atLeast("samples lit by each kind", count, 31);
}

/// One light needs no table.
void compareSingleLights(Prober& prober, Findings& findings) {
    Scene scene = makeLamps();
    for (Material& material : scene.materials) material.emissive = glm::vec3(0);
    for (const PunctualLight& light : makeLamps().lights) {
        scene.lights = {light};
        const SceneArrays arrays = makeArrays(scene);
        findings.equal("lights in the scene", arrays.lights.size(), 1U);
        const Lit lit = compareSamples(prober, findings, arrays, pointsAmong(2000, 42));
        findings.atLeast("samples lit by a single light", lit[arrays.lights[0].kind], 101);
    }
}

/// Lights are chosen in proportion to their pmf.
void compareShares(Prober& prober, Findings& findings) {
    const SceneArrays arrays = makeArrays(makeLamps());
    std::vector<In> inputs;
    constexpr std::uint32_t count = 1U << 14U;
    for (std::uint32_t i = 0; i < count; ++i) inputs.push_back({{0, 0.5F, 0}, 0, {i << 18U, 0x60000000U, 0, 0}});
    const auto scope = findings.inputs([](std::size_t) { return std::string("the first number over [0, 1)"); });
    const auto out = ProbeScene(prober, arrays).evaluate<Out>(findings, "lights", inputs);
    double spots = 0, expected = 0;  // delta lights: what pdf reports is the pmf itself
    for (const Out& o : out) spots += o.delta != 0 ? 1 : 0;
    for (const LightRecord& light : arrays.lights)
        if (light.kind >= kLightPoint && light.kind <= kLightDirectional) expected += double{light.pmf};
    findings.near("share of delta lights", spots / count, expected, 8.0 / count);
}

}  // namespace

void checkLights(VerifyContext& context, Findings& findings) {
    compareEveryKind(context.prober(), findings);
    compareSingleLights(context.prober(), findings);
    compareShares(context.prober(), findings);
}

}  // namespace vkpt
