// Every distribution of facets under every masking, against the reference in double.
#include "reference/microfacet/facets.h"

#include "verify/context.h"
#include "verify/inputs/jitter.h"
#include "verify/probes.h"

namespace vkpt {
namespace {

struct In {
    glm::vec3 wo;
    float alphaX;
    glm::vec3 wm;
    float alphaY;
    glm::vec3 wi;
    std::uint32_t flags;
    glm::vec2 u;
    float uChoice, unused = 0;
};
struct Out {
    float d, g1, g2, pdf;
    glm::vec3 sampled;
    float left;
    glm::vec4 sampledD;
};

std::vector<In> grid() {
    std::vector<In> inputs;
    RandomInputs random(83);
    const glm::vec2 alphas[] = {{1e-4F, 1e-4F}, {1e-3F, 1e-3F}, {0.1F, 0.1F}, {0.1F, 0.5F}, {1, 1}, {0.9F, 0.02F}};
    for (const std::uint32_t distribution : {kDistributionGgx, kDistributionBeckmann, kDistributionPhong})
        for (const std::uint32_t masking : {kMaskingCorrelated, kMaskingSeparable, kMaskingVGroove})
            for (const glm::vec2& alpha : alphas)
                for (const float cosO : {1.0F, 0.99F, 0.6F, 0.2F, 0.02F, 1e-3F})
                    for (int i = 0; i < 20; ++i) {
                        const glm::vec2 slope = alpha * random.between(0, 3);
                        const float phi = random.between(0, 6.28F);
                        const glm::vec3 wm =
                            glm::normalize(glm::vec3(slope.x * std::cos(phi), slope.y * std::sin(phi), 1));
                        const glm::vec3 wo = atCosine(cosO, i == 0 ? 0 : random.unit());
                        glm::vec3 wi = atCosine(random.between(1e-3F, 1), random.unit());
                        if (i % 2 == 1) wi.z = -wi.z;
                        inputs.push_back({wo, alpha.x, wm, alpha.y, wi, distribution | masking << kBsdfMaskingShift,
                                          i == 3 ? glm::vec2(0) : random.square(), random.unit()});
                    }
    return inputs;
}

reference::Facets<double> facetsOf(const In& in) {
    return {in.alphaX, in.alphaY, in.flags & kBsdfDistributionMask, in.flags >> kBsdfMaskingShift & kBsdfMaskingMask};
}

void compareValues(const In& in, const Out& out, RandomInputs& random, Findings& findings) {
    const auto f = facetsOf(in);
    const glm::dvec3 wo(in.wo), wi(in.wi), wm(in.wm);
    const auto near = [&](const char* name, double actual, const auto& evaluate) {
        const double expected = evaluate(wo, wi, wm);
        const double jitter = jitterOf(expected, random, [&](RandomInputs& r) {
            return evaluate(jittered(wo, r), jittered(wi, r), jittered(wm, r));
        });
        findings.near(name, actual, expected, 1e-30 + 2 * jitter, 1e-5);
    };
    using V = const glm::dvec3&;
    near("D", out.d, [&](V, V, V m) { return reference::facetD(f, m); });
    near("G1", out.g1, [&](V o, V, V m) { return reference::maskingG1(f, o, m); });
    near("G2", out.g2, [&](V o, V i, V m) { return reference::maskingG2(f, o, i, m); });
    near("pdf", out.pdf, [&](V o, V, V m) { return reference::visibleFacetPdf(f, o, m); });
}

/// u rounds too: what is drawn near an end of its range moves with the last bit of 1 - u.
template <class Sample>
bool compareSample(const char* name, const glm::dvec3& actual, const In& in, RandomInputs& random, Findings& findings,
                   const Sample& sample) {
    const glm::dvec3 expected = sample(glm::dvec3(in.wo), glm::dvec2(in.u));
    const double jitter = jitterOf(expected, random, [&](RandomInputs& r) {
        const glm::dvec2 u = glm::dvec2(in.u) + glm::dvec2(r.between(-1, 1), r.between(-1, 1)) * 1.2e-7;
        return sample(jittered(glm::dvec3(in.wo), r), glm::clamp(u, 0.0, 1 - 0x1p-25));
    });
    findings.near(name, actual, expected, 5e-6 + 2 * jitter);
    findings.near("its length", glm::length(actual), 1, 1e-6);
    return jitter < 1e-3;
}

}  // namespace

void checkFacets(VerifyContext& context, Findings& findings) {
    const auto inputs = grid();
    const auto out = context.prober().evaluate<Out>("facets", inputs);
    const auto scope = findings.inputs([&](std::size_t i) {
        const In& in = inputs[i];
        return fmt::format("distribution {}, masking {}, alpha {} {}, wo {}, wi {}, wm {}, u {}, uChoice {}",
                           in.flags & kBsdfDistributionMask, in.flags >> kBsdfMaskingShift, in.alphaX, in.alphaY,
                           show(in.wo), show(in.wi), show(in.wm), show(in.u), in.uChoice);
    });
    RandomInputs random(84);
    std::size_t sharp = 0;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        findings.at(i);
        const In& in = inputs[i];
        const auto f = facetsOf(in);
        compareValues(in, out[i], random, findings);
        compareSample("normal of D cos", glm::dvec3(out[i].sampledD), in, random, findings,
                      [&](const glm::dvec3&, const glm::dvec2& u) { return reference::sampleFacet(f, u); });
        double left = 0;
        sharp += compareSample("visible normal", glm::dvec3(out[i].sampled), in, random, findings,
                               [&](const glm::dvec3& wo, const glm::dvec2& u) {
                                   left = in.uChoice;
                                   return reference::sampleVisibleFacet(f, wo, u, left);
                               })
                     ? 1
                     : 0;
    }
    findings.atLeast("samples that rounding leaves alone", static_cast<double>(sharp),
                     0.9 * static_cast<double>(inputs.size()));
}

}  // namespace vkpt
