// The glTF BSDF over grids of base colour, metallic, alpha and directions, against the reference in double.
#include "reference/bsdf.h"
#include "wavefront/probe_scene.h"
#include "wavefront/random_inputs.h"

namespace vkpt {
namespace {

using GltfProbe = GpuTest;

struct In {
    glm::vec3 base;
    float metallic;
    glm::vec3 wo;
    float alpha;
    glm::vec4 wi;
    float uLobe;
    glm::vec2 u;
    float unused = 0;
};
struct Out {
    glm::vec3 f;
    float pdf;
    glm::vec3 wi;
    float samplePdf;
    glm::vec3 weight;
    float pSpecular;
};

constexpr glm::vec3 kBases[] = {{0.8F, 0.5F, 0.05F}, {1, 1, 1}, {0, 0, 0}, {1, 0, 0}};

/// Directions from the normal to grazing; wi at random, near the mirror direction, and nearly opposite at the horizon.
std::vector<In> grid(std::uint32_t seed) {
    std::vector<In> inputs;
    RandomInputs random(seed);
    for (const glm::vec3& base : kBases)
        for (const float metallic : {0.0F, 0.35F, 1.0F})
            for (const float alpha : {0.0F, 5e-5F, 1e-4F, 1e-3F, 0.01F, 0.09F, 0.5F, 1.0F})
                for (const float cosO : {1.0F, 0.9F, 0.4F, 0.05F, 1e-3F, 1e-5F})
                    for (int i = 0; i < 12; ++i) {
                        const glm::vec3 wo = atCosine(cosO, random.unit());
                        const glm::vec3 mirror(-wo.x, -wo.y, wo.z);
                        glm::vec3 wi = atCosine(i == 0 ? 1e-5F : random.between(1e-4F, 1), random.unit());
                        if (i % 3 == 2) wi = glm::normalize(mirror + alpha * random.direction());
                        if (i == 11) wi.z = -wi.z;
                        inputs.push_back({base, metallic, wo, alpha, glm::vec4(wi, 0), random.unit(), random.square()});
                    }
    return inputs;
}

/// What double says of the same material; which lobes are delta is decided by the float alpha, as in both renderers.
reference::Bsdf<double> truthOf(const In& in, float cosO) {
    auto b = reference::makeBsdf<double>(glm::dvec3(in.base), in.metallic, 1, cosO);
    b.alpha = in.alpha;
    return b;
}

testing::Message describe(const In& in) {
    return testing::Message() << "base " << in.base.r << " " << in.base.g << " metallic " << in.metallic << " alpha "
                              << in.alpha << " cosO " << in.wo.z << " wi " << in.wi.x << " " << in.wi.y << " "
                              << in.wi.z;
}

// wm = normalize(wo + wi) keeps relative accuracy in each component, so D does. Black metal is Schlick's (1 - cos)^5
// alone, where the 1.2e-7 of the cosine counts five times over 1 - cos: hence a share of the lobe's size at F = 1. The
// diffuse lobe's 1 - Fd loses as much where both directions graze: hence an absolute 1e-7.
TEST_F(GltfProbe, ValueAndPdfAreWithin3e5Relative) {
    const auto inputs = grid(9);
    const auto out = evaluate<Out>("gltf", inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const In& in = inputs[i];
        SCOPED_TRACE(describe(in));
        const auto b = truthOf(in, in.wo.z);
        auto white = b;
        white.base = glm::dvec3(1);
        const glm::dvec3 wo(in.wo), wi(in.wi);
        const double size = 1e-7 + 2e-6 * reference::evalBsdf(white, wo, wi).x;
        ASSERT_TRUE(isNear(out[i].pSpecular, b.pSpecular, 1e-6, 1e-5));
        ASSERT_TRUE(isNear(out[i].f, reference::evalBsdf(b, wo, wi), size, 3e-5));
        auto mirrorLike = b;  // what an error of 1e-6 in the choice of lobe weighs
        mirrorLike.pSpecular = 1;
        const double pdfSize = 1e-6 * (1 + reference::pdfBsdf(mirrorLike, wo, wi));
        ASSERT_TRUE(isNear(out[i].pdf, reference::pdfBsdf(b, wo, wi), pdfSize, 3e-5));
    }
}

TEST_F(GltfProbe, NothingIsNegativeOrNotFinite) {
    auto inputs = grid(10);
    for (In in : grid(11)) {  // at the horizon and far below any cosine a float geometry yields
        in.wo = atCosine(in.wo.z * 1e-9F, 0.3F);
        inputs.push_back(in);
    }
    for (const Out& out : evaluate<Out>("gltf", inputs)) {
        for (int c = 0; c < 3; ++c) {
            ASSERT_TRUE(std::isfinite(out.f[c]) && out.f[c] >= 0);
            ASSERT_TRUE(std::isfinite(out.weight[c]) && out.weight[c] >= 0);
        }
        ASSERT_TRUE(std::isfinite(out.pdf) && out.pdf >= 0);
        ASSERT_TRUE(std::isfinite(out.samplePdf) && (out.samplePdf >= 0 || out.samplePdf == -1));
        ASSERT_TRUE(isNear(glm::dot(out.wi, out.wi), 1, 1e-5));
    }
}

TEST_F(GltfProbe, SampledDirectionsFollowTheReferenceAndTheirOwnDensity) {
    const auto inputs = grid(12);
    const auto out = evaluate<Out>("gltf", inputs);
    int compared = 0;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const In& in = inputs[i];
        SCOPED_TRACE(describe(in) << " u " << in.uLobe << " " << in.u.x << " " << in.u.y);
        const auto b = truthOf(in, in.wo.z);
        if (std::abs(b.pSpecular - in.uLobe) < 1e-5) continue;  // the lobe is rounding's choice
        const glm::dvec3 wo(in.wo);
        const auto expected = reference::sampleBsdf<double>(b, wo, in.uLobe, glm::dvec2(in.u));
        if (in.uLobe >= b.pSpecular || b.isDelta() || in.u.y > 0.01) {
            if (std::abs(expected.wi.z) > 1e-4 || out[i].wi.z > 0) {
                ASSERT_TRUE(isNear(out[i].wi, expected.wi, 1e-4));
            }
        }
        if (std::isinf(expected.pdf)) {
            ASSERT_EQ(out[i].samplePdf, -1);
            ASSERT_TRUE(isNear(out[i].weight, expected.weight, 1e-6, 1e-5));
            continue;
        }
        if (out[i].wi.z <= 0) {
            ASSERT_EQ(out[i].weight, glm::vec3(0));
            continue;
        }
        // Pdf and weight belong to the direction the shader drew, whose rounding D would magnify.
        const glm::dvec3 wi(out[i].wi);
        const double pdf = reference::pdfBsdf(b, wo, wi);
        auto white = b;
        white.base = glm::dvec3(1);
        ASSERT_TRUE(isNear(out[i].samplePdf, pdf, 0, 1e-4));
        ASSERT_TRUE(isNear(out[i].weight, reference::evalBsdf(b, wo, wi) * (wi.z / pdf),
                           1e-5 * reference::evalBsdf(white, wo, wi).x * wi.z / pdf, 1e-4));
        ++compared;
    }
    EXPECT_GT(compared, static_cast<int>(inputs.size()) / 2);
}

}  // namespace
}  // namespace vkpt
