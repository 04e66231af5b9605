#include "reference/microfacet/ggx.h"

#include "verify/context.h"
#include "verify/inputs/random_inputs.h"
#include "verify/probes.h"

namespace vkpt {
namespace {

struct In {
    glm::vec3 wo;
    float alpha;
    glm::vec3 wm;
    float cosI;
    glm::vec2 u, unused{0};
};
struct Out {
    float d, g1, g2, pdf;
    glm::vec4 sampled;
};

/// Every alpha from the delta limit to 1, directions from the normal to grazing, normals about the peak and far off.
std::vector<In> grid() {
    std::vector<In> inputs;
    RandomInputs random(8);
    for (const float alpha : {1e-4F, 1e-3F, 0.01F, 0.1F, 0.25F, 0.5F, 1.0F})
        for (const float cosO : {1.0F, 0.999F, 0.7F, 0.3F, 0.05F, 1e-3F, 1e-5F})
            for (int i = 0; i < 40; ++i) {
                const float slope = alpha * std::exp(random.between(-5, 5));  // tan of the angle of wm
                const glm::vec3 wm = atCosine(1 / std::sqrt(1 + slope * slope), random.unit());
                inputs.push_back({atCosine(cosO, random.unit()), alpha, glm::normalize(wm), random.between(1e-5F, 1),
                                  random.square()});
            }
    return inputs;
}

/// Sums of positive terms: relative errors stay near the rounding of the few operations, whatever alpha is.
void compareValues(const In& in, const Out& out, Findings& findings) {
    const double alpha = in.alpha, cosO = in.wo.z, cosI = in.cosI;
    const double d = reference::ggxD<double>(glm::dvec3(in.wm), alpha), g1 = reference::ggxG1<double>(cosO, alpha);
    findings.near("ggxD", out.d, d, 0, 1e-5);
    findings.near("ggxG1", out.g1, g1, 0, 1e-5);
    findings.near("ggxG2", out.g2, reference::ggxVisibility<double>(cosO, cosI, alpha) * 4 * cosO * cosI, 0, 1e-5);
    findings.near("ggxReflectionPdf", out.pdf, d * g1 / (4 * cosO), 0, 2e-5);
}

/// h = cap + wo of the stretched space, then wm = normalize(alpha h.xy, h.z). The cap's height rounds by 2e-7; the root
/// makes that 2e-7 / sin for the xy of a thin cap. What that turns wm by follows from the sine rule.
double angleError(const glm::dvec3& h, double alpha, double sinCap) {
    const double xy = alpha * std::hypot(h.x, h.y), length2 = xy * xy + h.z * h.z;
    return (alpha * 2e-7 / std::max(sinCap, 4e-4) * h.z + xy * 2e-7) / length2;
}

void compareSample(const In& in, const Out& out, Findings& findings) {
    const glm::dvec3 wo(in.wo), wm(out.sampled);
    const auto expected = reference::sampleGgxVisibleNormal<double>(wo, in.alpha, glm::dvec2(in.u));
    const glm::dvec3 w = glm::normalize(glm::dvec3(in.alpha * wo.x, in.alpha * wo.y, wo.z));
    const double z = (1 - double{in.u.y}) * (1 + w.z) - w.z, sinCap = std::sqrt(std::max(0.0, 1 - z * z));
    const glm::dvec3 h = w + glm::dvec3(sinCap * reference::cosSinTurns<double>(in.u.x), z);
    findings.near("ggxSampleVisibleNormal", wm, expected, 5e-7 + angleError(h, in.alpha, sinCap));
    findings.near("its length", glm::dot(wm, wm), 1, 1e-6);
    findings.holds("its side", wm.z >= 0, "is below the surface");
}

}  // namespace

void checkGgx(VerifyContext& context, Findings& findings) {
    const auto inputs = grid();
    const auto out = context.prober().evaluate<Out>("ggx", inputs);
    const auto scope = findings.inputs([&](std::size_t i) {
        const In& in = inputs[i];
        return fmt::format("alpha {}, wo {}, wm {}, cosI {}, u {}", in.alpha, show(in.wo), show(in.wm), in.cosI,
                           show(in.u));
    });
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        findings.at(i);
        compareValues(inputs[i], out[i], findings);
        compareSample(inputs[i], out[i], findings);
    }
}

}  // namespace vkpt
