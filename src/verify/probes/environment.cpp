#include "scene/environment.h"

#include <cmath>

#include "reference/lights/environment.h"
#include "verify/context.h"
#include "verify/inputs/random_inputs.h"
#include "verify/probes.h"

namespace vkpt {
namespace {

struct In {
    glm::vec4 direction, u;
};
struct Out {
    glm::vec3 radiance;
    float pdf;
    glm::vec3 sampled;
    float sampledPdf;
};

struct Sky {
    std::uint32_t width, height;
    float rotationDegrees;
};
constexpr Sky kSkies[] = {{1, 1, 0}, {2, 1, 90}, {16, 8, 0}, {10, 5, 37}, {33, 17, -120}, {64, 32, 180}};

/// Random sky with a sun and a black patch; widths that are no multiple of four leave padding in the tables.
SceneArrays makeSky(const Sky& s) {
    EnvironmentMap map{s.width, s.height, {}};
    const std::size_t texels = std::size_t{s.width} * s.height;
    RandomInputs random(18);
    for (std::size_t i = 0; i < texels; ++i) map.texels.push_back(random.inBox({0, 0, 0}, {1, 1, 1}));
    map.texels[texels / 3] = {5000, 4000, 3000};
    if (texels > 1) map.texels[texels / 2] = {0, 0, 0};
    SceneArrays arrays;
    addEnvironment(arrays, map, 2, s.rotationDegrees);
    return arrays;
}

std::vector<In> directions() {
    std::vector<In> inputs;
    RandomInputs random(19);
    for (int axis = 0; axis < 3; ++axis)
        for (const float sign : {1.0F, -1.0F}) {
            glm::vec4 d(0);
            d[axis] = sign;
            inputs.push_back({d, glm::vec4(random.square(), 0, 0)});
        }
    for (const float u : {0.0F, 0.25F, 0.5F, 0x1.fffffep-1F})
        for (const float v : {0.0F, 0.25F, 0.5F, 0x1.fffffep-1F})
            inputs.push_back({glm::vec4(random.direction(), 0), {u, v, 0, 0}});
    for (int i = 0; i < 3000; ++i)
        inputs.push_back({glm::vec4(random.direction(), 0), glm::vec4(random.square(), 0, 0)});
    return inputs;
}

/// Texel position of a world direction, in double.
glm::dvec2 texelPosition(const SceneArrays& a, const glm::dvec3& d) {
    const double c = std::cos(double{a.envRotation}), s = std::sin(double{a.envRotation});
    const glm::dvec3 turned(c * d.x - s * d.z, d.y, s * d.x + c * d.z);
    return reference::environmentUv<double>(glm::normalize(turned)) * glm::dvec2(a.envWidth, a.envHeight);
}

/// The angles are within 6e-7; u and v within 3e-7; the filter moves by that times the width. Whether the pdf, which
/// jumps between cells, was compared.
bool compareLookup(const SceneArrays& arrays, const reference::Environment& environment, const In& in, const Out& out,
                   Findings& findings) {
    const glm::vec3 d(in.direction);
    const double width = arrays.envWidth, brightest = 1e4;
    const double shift = 1e-6 * width * (1 + 1e-6 / std::max(1e-6, 1 - double{d.y} * d.y));
    const bool atPole = std::abs(d.y) > 0.99999F;
    findings.near("radiance", out.radiance, environment.radiance(d), atPole ? 1e-2 : shift * brightest, 1e-5);
    const glm::dvec2 p = texelPosition(arrays, glm::dvec3(d)), edge = glm::abs(p - glm::round(p));
    if (atPole || std::min(edge.x, edge.y) < 1e-6 * width) return false;  // either cell will do
    findings.equal("pdf", out.pdf, environment.pdf(d));
    return true;
}

void compareSample(const reference::Environment& environment, const In& in, const Out& out, Findings& findings) {
    const auto expected = environment.sample(glm::vec2(in.u));
    findings.equal("sampled pdf", out.sampledPdf, expected.pdf);
    // sin = sqrt(1 - cos^2) rounds by 1e-7 / sin.
    const double sine = std::sqrt(std::max(1e-7, 1 - double{expected.direction.y} * expected.direction.y));
    findings.near("sampled direction", out.sampled, expected.direction, 1e-6 + 3e-7 / sine);
}

}  // namespace

void checkEnvironment(VerifyContext& context, Findings& findings) {
    const auto inputs = directions();
    for (const Sky& s : kSkies) {
        const SceneArrays arrays = makeSky(s);
        const reference::Environment environment(arrays);
        const auto scope = findings.inputs([&](std::size_t i) {
            return fmt::format("sky of {}x{} turned by {} degrees: direction {}, u {}", s.width, s.height,
                               s.rotationDegrees, show(glm::vec3(inputs[i].direction)), show(glm::vec2(inputs[i].u)));
        });
        const auto out = ProbeScene(context.prober(), arrays).evaluate<Out>(findings, "environment", inputs);
        int compared = 0;
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            findings.at(i);
            compared += compareLookup(arrays, environment, inputs[i], out[i], findings) ? 1 : 0;
            compareSample(environment, inputs[i], out[i], findings);
        }
        findings.atLeast("densities compared", compared, 2901);
    }
}

}  // namespace vkpt
