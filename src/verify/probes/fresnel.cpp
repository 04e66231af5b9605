// Fresnel terms against the reference in double.
#include "reference/microfacet/fresnel.h"

#include "verify/context.h"
#include "verify/inputs/random_inputs.h"
#include "verify/probes.h"

namespace vkpt {
namespace {

struct In {
    glm::vec3 eta;
    float cosine;
    glm::vec4 k;
};
struct Out {
    float outside, inside, unused[2];
    glm::vec4 conductor, schlick;
};

/// Indices of glasses and metals, and angles from the normal to grazing.
std::vector<In> grid() {
    std::vector<In> inputs;
    RandomInputs random(82);
    for (const float cosine : {1.0F, 0.999F, 0.8F, 0.6F, 0.3F, 0.05F, 1e-3F, 1e-5F})
        for (int i = 0; i < 100; ++i)
            inputs.push_back({random.inBox({1.02F, 0.04F, 0.3F}, {3.5F, 1.5F, 4}), cosine * random.between(0.7F, 1),
                              glm::vec4(random.inBox({0, 1, 0.5F}, {9, 6, 3}), 0)});
    return inputs;
}

void compare(const In& in, const Out& out, Findings& findings) {
    const double cosine = in.cosine, eta = in.eta.x;
    findings.near("dielectric, from outside", out.outside, reference::dielectricFresnel<double>(cosine, eta), 1e-6);
    // Near total reflection the root of what remains magnifies the rounding of sin^2.
    const double rest = 1 - (1 - cosine * cosine) * eta * eta;
    findings.near("dielectric, from inside", out.inside, reference::dielectricFresnel<double>(cosine, 1 / eta),
                  2e-6 + 4e-6 * eta * eta / std::sqrt(std::max(std::abs(rest), 1e-7)));
    findings.near("conductor", glm::vec3(out.conductor),
                  reference::conductorFresnel<double>(cosine, glm::dvec3(in.eta), glm::dvec3(in.k)), 2e-6);
    const glm::dvec3 f0 = glm::clamp(glm::dvec3(in.eta), 0.0, 1.0);
    if (f0 == glm::dvec3(in.eta))
        findings.near("Schlick", glm::vec3(out.schlick), reference::schlickFresnel<double>(cosine, f0), 1e-6);
}

}  // namespace

void checkFresnel(VerifyContext& context, Findings& findings) {
    auto inputs = grid();
    for (std::size_t i = 0; i < inputs.size(); i += 2) inputs[i].eta = glm::vec3(1) / inputs[i].eta;  // F0 below 1
    for (In& in : inputs)
        if (in.eta.x < 1) in.eta.x = std::min(in.eta.x, 0.98F);
    const auto out = context.prober().evaluate<Out>("fresnel", inputs);
    const auto scope = findings.inputs([&](std::size_t i) {
        return fmt::format("eta {}, k {}, cosine {}", show(inputs[i].eta), show(inputs[i].k), inputs[i].cosine);
    });
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        findings.at(i);
        compare(inputs[i], out[i], findings);
    }
}

}  // namespace vkpt
