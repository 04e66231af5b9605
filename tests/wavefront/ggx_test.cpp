#include "reference/bsdf/ggx.h"

#include "wavefront/probe_scene.h"
#include "wavefront/random_inputs.h"

namespace vkpt {
namespace {

using GgxProbe = GpuTest;

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

// Sums of positive terms: relative errors stay near the rounding of the few operations, whatever alpha is.
TEST_F(GgxProbe, DistributionAndMaskingAreWithin1e5Relative) {
    const auto inputs = grid();
    const auto out = evaluate<Out>("ggx", inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const In& in = inputs[i];
        const double alpha = in.alpha, cosO = in.wo.z, cosI = in.cosI;
        const double d = reference::ggxD<double>(glm::dvec3(in.wm), alpha), g1 = reference::ggxG1<double>(cosO, alpha);
        SCOPED_TRACE(testing::Message() << "alpha " << alpha << " cosO " << cosO << " cosM " << in.wm.z);
        ASSERT_TRUE(isNear(out[i].d, d, 0, 1e-5));
        ASSERT_TRUE(isNear(out[i].g1, g1, 0, 1e-5));
        ASSERT_TRUE(isNear(out[i].g2, reference::ggxVisibility<double>(cosO, cosI, alpha) * 4 * cosO * cosI, 0, 1e-5));
        ASSERT_TRUE(isNear(out[i].pdf, d * g1 / (4 * cosO), 0, 2e-5));
    }
}

// h = cap + wo of the stretched space, then wm = normalize(alpha h.xy, h.z). The cap's height rounds by 2e-7; the root
// makes that 2e-7 / sin for the xy of a thin cap. What that turns wm by follows from the sine rule.
double angleError(const glm::dvec3& h, double alpha, double sinCap) {
    const double xy = alpha * std::hypot(h.x, h.y), length2 = xy * xy + h.z * h.z;
    return (alpha * 2e-7 / std::max(sinCap, 4e-4) * h.z + xy * 2e-7) / length2;
}

TEST_F(GgxProbe, SampledNormalsEqualReferenceUpToTheRoundingOfTheCap) {
    const auto inputs = grid();
    const auto out = evaluate<Out>("ggx", inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const In& in = inputs[i];
        const glm::dvec3 wo(in.wo), wm(out[i].sampled);
        const auto expected = reference::sampleGgxVisibleNormal<double>(wo, in.alpha, glm::dvec2(in.u));
        const glm::dvec3 w = glm::normalize(glm::dvec3(in.alpha * wo.x, in.alpha * wo.y, wo.z));
        const double z = (1 - double{in.u.y}) * (1 + w.z) - w.z, sinCap = std::sqrt(std::max(0.0, 1 - z * z));
        const glm::dvec3 h = w + glm::dvec3(sinCap * reference::cosSinTurns<double>(in.u.x), z);
        ASSERT_TRUE(isNear(wm, expected, 5e-7 + angleError(h, in.alpha, sinCap)))
            << "alpha " << in.alpha << " cosO " << wo.z << " u " << in.u.x << ", " << in.u.y;
        ASSERT_TRUE(isNear(glm::dot(wm, wm), 1, 1e-6));
        ASSERT_GE(wm.z, 0);
    }
}

}  // namespace
}  // namespace vkpt
