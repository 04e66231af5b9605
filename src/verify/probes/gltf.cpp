// The glTF BSDF over grids of base colour, metallic, alpha and directions, against the reference in double.
#include <cmath>

#include "reference/bsdf.h"
#include "verify/context.h"
#include "verify/inputs/random_inputs.h"
#include "verify/probes.h"

namespace vkpt {
namespace {

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
reference::Bsdf<double> truthOf(const In& in) {
    return reference::makeGltfBsdf<double>(glm::dvec3(in.base), in.metallic, in.alpha);
}

/// The size of f, whose errors are relative to that of a white surface.
double whiteValue(reference::Bsdf<double> b, const glm::dvec3& wo, const glm::dvec3& wi) {
    b.color = glm::dvec3(1);
    return reference::evalBsdf(b, wo, wi).x;
}

std::string describe(const In& in) {
    return fmt::format("base {}, metallic {}, alpha {}, wo {}, wi {}, uLobe {}, u {}", show(in.base), in.metallic,
                       in.alpha, show(in.wo), show(glm::vec3(in.wi)), in.uLobe, show(in.u));
}

void compareValue(const In& in, const Out& out, Findings& findings) {
    const auto b = truthOf(in);
    const glm::dvec3 wo(in.wo), wi(in.wi);
    const double size = 1e-7 + 2e-6 * whiteValue(b, wo, wi);
    const double pSpecular = reference::gltfSpecularShare(b, wo);
    findings.near("pSpecular", out.pSpecular, pSpecular, 1e-6, 1e-5);
    findings.near("f", out.f, reference::evalBsdf(b, wo, wi), size, 3e-5);
    // What an error of 1e-6 in the choice of lobe weighs: a black metal is all specular.
    const auto mirrorLike = reference::makeGltfBsdf<double>(glm::dvec3(0), 1, in.alpha);
    const double pdfSize = 1e-6 * (1 + reference::pdfBsdf(mirrorLike, wo, wi));
    findings.near("pdf", out.pdf, reference::pdfBsdf(b, wo, wi), pdfSize, 3e-5);
}

/// Whether pdf and weight were compared.
bool compareSample(const In& in, const Out& out, Findings& findings) {
    const auto b = truthOf(in);
    const glm::dvec3 wo(in.wo);
    const double pSpecular = reference::gltfSpecularShare(b, wo);
    if (std::abs(pSpecular - in.uLobe) < 1e-5) return false;  // the lobe is rounding's choice
    const auto expected = reference::sampleBsdf<double>(b, wo, in.uLobe, glm::dvec2(in.u));
    const bool wellPosed = in.uLobe >= pSpecular || b.isDelta() || in.u.y > 0.01;
    if (wellPosed && (std::abs(expected.wi.z) > 1e-4 || out.wi.z > 0))
        findings.near("sampled direction", out.wi, expected.wi, 1e-4);
    if (std::isinf(expected.pdf)) {
        findings.equal("pdf of a mirror", out.samplePdf, -1.0F);
        findings.near("weight of a mirror", out.weight, expected.weight, 1e-6, 1e-5);
        return false;
    }
    if (out.wi.z <= 0) {
        findings.equal("weight below the surface", out.weight, glm::vec3(0));
        return false;
    }
    // Pdf and weight belong to the direction the shader drew, whose rounding D would magnify.
    const glm::dvec3 wi(out.wi);
    const double pdf = reference::pdfBsdf(b, wo, wi);
    findings.near("sampled pdf", out.samplePdf, pdf, 0, 1e-4);
    findings.near("weight", out.weight, reference::evalBsdf(b, wo, wi) * (wi.z / pdf),
                  1e-5 * whiteValue(b, wo, wi) * wi.z / pdf, 1e-4);
    return true;
}

void checkFinite(const Out& out, Findings& findings) {
    const auto isSound = [](double v) { return std::isfinite(v) && v >= 0; };
    for (int c = 0; c < 3; ++c)
        findings.holds("finite values", isSound(out.f[c]) && isSound(out.weight[c]), "f or weight is not");
    findings.holds("finite densities", isSound(out.pdf) && (isSound(out.samplePdf) || out.samplePdf == -1),
                   "a pdf is not");
    findings.near("length of wi", glm::dot(glm::dvec3(out.wi), glm::dvec3(out.wi)), 1, 1e-5);
}

template <class Compare>
void forEach(Prober& prober, Findings& findings, const std::vector<In>& inputs, const Compare& compare) {
    const auto out = prober.evaluate<Out>("gltf", inputs);
    const auto scope = findings.inputs([&](std::size_t i) { return describe(inputs[i]); });
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        findings.at(i);
        compare(inputs[i], out[i]);
    }
}

}  // namespace

void checkGltf(VerifyContext& context, Findings& findings) {
    Prober& prober = context.prober();
    forEach(prober, findings, grid(9), [&](const In& in, const Out& out) { compareValue(in, out, findings); });

    const auto inputs = grid(12);
    std::size_t compared = 0;
    forEach(prober, findings, inputs,
            [&](const In& in, const Out& out) { compared += compareSample(in, out, findings) ? 1 : 0; });
    findings.atLeast("samples compared", static_cast<double>(compared), static_cast<double>(inputs.size()) / 2);

    auto extremes = grid(10);
    for (In in : grid(11)) {  // at the horizon and far below any cosine a float geometry yields
        in.wo = atCosine(in.wo.z * 1e-9F, 0.3F);
        extremes.push_back(in);
    }
    forEach(prober, findings, extremes, [&](const In&, const Out& out) { checkFinite(out, findings); });
}

}  // namespace vkpt
