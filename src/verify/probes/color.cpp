#include <algorithm>
#include <cmath>

#include "reference/real.h"
#include "reference/texture.h"
#include "verify/context.h"
#include "verify/inputs/random_inputs.h"
#include "verify/probes.h"
#include "wavefront/kernels.h"

namespace vkpt {
namespace {

struct In {
    glm::vec4 color{0};
    glm::vec2 pdfs{1, 1};
    float beta = 2, unused = 0;
};
struct Out {
    glm::vec3 linear;
    float luminance, largest, weight;
    glm::vec2 unused;
};

/// Every byte, and the joint of the curve.
void compareSrgb(Prober& prober, Findings& findings) {
    std::vector<In> inputs;
    for (std::uint32_t i = 0; i < 256; ++i)
        inputs.push_back({.color = {static_cast<float>(i) / 255, static_cast<float>(255 - i) / 255, 0.04045F, 0}});
    const auto out = prober.evaluate<Out>("color", inputs);
    const auto scope =
        findings.inputs([&](std::size_t i) { return "srgbToLinear of " + show(glm::vec3(inputs[i].color)); });
    for (std::uint32_t i = 0; i < 256; ++i) {
        findings.at(i);
        findings.near("srgbToLinear", out[i].linear.r, reference::decodeSrgb(i), 0, 1e-6);
        findings.near("srgbToLinear", out[i].linear.g, reference::decodeSrgb(255 - i), 0, 1e-6);
        findings.near("srgbToLinear", out[i].linear.b, 0.04045 / 12.92, 0, 1e-6);
    }
}

void compareLuminance(Prober& prober, Findings& findings) {
    std::vector<In> inputs;
    RandomInputs random(5);
    for (int i = 0; i < 1000; ++i) inputs.push_back({.color = glm::vec4(random.inBox({0, 0, 0}, {10, 1, 100}), 0)});
    const auto out = prober.evaluate<Out>("color", inputs);
    const auto scope = findings.inputs([&](std::size_t i) { return "the colour " + show(glm::vec3(inputs[i].color)); });
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        findings.at(i);
        const glm::vec3 c(inputs[i].color);
        findings.near("luminance", out[i].luminance, reference::luminance<double>(glm::dvec3(c)), 0, 1e-6);
        findings.equal("maxComponent", out[i].largest, std::max({c.r, c.g, c.b}));
    }
}

/// Densities whose powers overflow or underflow among them.
void compareHeuristic(Prober& prober, Findings& findings, float beta) {
    std::vector<In> inputs;
    for (const float pdf : {1e-30F, 1e-3F, 0.3F, 1.0F, 7.0F, 1e4F, 1e30F})
        for (const float other : {0.0F, 1e-30F, 1e-3F, 0.3F, 1.0F, 7.0F, 1e4F, 1e30F})
            inputs.push_back({.pdfs = {pdf, other}, .beta = beta});
    KernelOptions kernel;
    kernel.params.beta = beta;
    ProbeOptions options;
    options.specialization = specializationOf({}, {}, kernel);
    const auto out = prober.evaluate<Out>("color", inputs, options);
    const auto scope = findings.inputs(
        [&](std::size_t i) { return fmt::format("the densities {}, exponent {}", show(inputs[i].pdfs), beta); });
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        findings.at(i);
        const glm::dvec2 p(inputs[i].pdfs);
        const double weight = 1 / (1 + std::pow(p.y / p.x, double{beta}));
        findings.near("misWeight", out[i].weight, weight, 1e-30, beta == 1 || beta == 2 ? 1e-6 : 1e-5);
    }
}

}  // namespace

void checkColor(VerifyContext& context, Findings& findings) {
    compareSrgb(context.prober(), findings);
    compareLuminance(context.prober(), findings);
    for (const float beta : {1.0F, 2.0F, 1.7F}) compareHeuristic(context.prober(), findings, beta);
}

}  // namespace vkpt
