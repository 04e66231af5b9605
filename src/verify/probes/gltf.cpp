// The glTF BSDF over grids of base colour, metallic, alpha and directions, against the reference in double.
#include <cmath>

#include "reference/bsdf.h"
#include "reference/bsdf/compensation.h"
#include "scene/albedo_tables.h"
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
    float specular, interreflection;  ///< probabilities of the lobes
    glm::vec3 unused;
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
reference::Bsdf<double> truthOf(const SceneArrays& scene, const In& in) {
    auto b = reference::makeGltfBsdf<double>(glm::dvec3(in.base), in.metallic, in.alpha);
    b.multiscatter = scene.features.multiscatter;
    b.table.cells = scene.albedoTables.data();
    return b;
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

void compareValue(const SceneArrays& scene, const In& in, const Out& out, Findings& findings) {
    const auto b = truthOf(scene, in);
    const glm::dvec3 wo(in.wo), wi(in.wi);
    const double size = 1e-7 + 2e-6 * whiteValue(b, wo, wi);
    const auto shares = reference::gltfShares(b, wo);
    constexpr double choice = 1e-6;
    findings.near("choice of the specular lobe", out.specular, shares.specular, choice, 1e-5);
    findings.near("choice of interreflection", out.interreflection, shares.interreflection, 0, 1e-5);
    findings.near("f", out.f, reference::evalBsdf(b, wo, wi), size, 3e-5);
    // What an error in the choice of lobe weighs: a black metal is all specular, but for interreflection.
    const auto mirrorLike = reference::makeGltfBsdf<double>(glm::dvec3(0), 1, in.alpha);
    const double lobes =
        reference::pdfBsdf(mirrorLike, wo, wi) + (b.compensates() ? reference::lostEnergyLobePdf(b, wi) : 0);
    const double pdfSize = choice * (1 + lobes);
    findings.near("pdf", out.pdf, reference::pdfBsdf(b, wo, wi), pdfSize, 3e-5);
}

/// Whether pdf and weight were compared.
bool compareSample(const SceneArrays& scene, const In& in, const Out& out, Findings& findings) {
    const auto b = truthOf(scene, in);
    const glm::dvec3 wo(in.wo);
    const auto shares = reference::gltfShares(b, wo);
    const double diffuse = 1 - (1 - shares.interreflection) * (1 - shares.specular);  // chosen from here on
    const auto draw = [&](double uLobe) { return reference::sampleBsdf<double>(b, wo, uLobe, glm::dvec2(in.u)); };
    const auto expected = draw(in.uLobe);
    for (const double change : {-1e-5, 1e-5})  // the lobe is rounding's choice
        if (draw(in.uLobe + change).wi != expected.wi) return false;
    const bool wellPosed = in.uLobe >= diffuse || b.isDelta() || in.u.y > 0.01;
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

/// One setting of interreflection: `scene` has glTF's albedo table.
class GltfComparison {
public:
    GltfComparison(Prober& prober, const SceneArrays& scene, Findings& findings)
        : prober_(prober), scene_(scene), probeScene_(prober, scene), findings_(findings) {}

    void values() {
        forEach(grid(9), [&](const In& in, const Out& out) { compareValue(scene_, in, out, findings_); });
    }
    void samples() {
        const auto inputs = grid(12);
        std::size_t compared = 0;
        forEach(inputs,
                [&](const In& in, const Out& out) { compared += compareSample(scene_, in, out, findings_) ? 1 : 0; });
        findings_.atLeast("samples compared", static_cast<double>(compared), static_cast<double>(inputs.size()) / 2);
    }
    /// At the horizon and far below any cosine a float geometry yields.
    void extremes() {
        auto inputs = grid(10);
        for (In in : grid(11)) {
            in.wo = atCosine(in.wo.z * 1e-9F, 0.3F);
            inputs.push_back(in);
        }
        forEach(inputs, [&](const In&, const Out& out) { checkFinite(out, findings_); });
    }

private:
    template <class Compare>
    void forEach(const std::vector<In>& inputs, const Compare& compare) {
        const auto out = prober_.evaluate<Out>("gltf", inputs, probeScene_.options(Fetch::Storage));
        const auto scope = findings_.inputs([&](std::size_t i) {
            return describe(inputs[i]) + (scene_.features.multiscatter ? ", multiscatter" : "");
        });
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            findings_.at(i);
            compare(inputs[i], out[i]);
        }
    }

    Prober& prober_;
    const SceneArrays& scene_;
    ProbeScene probeScene_;
    Findings& findings_;
};

}  // namespace

void checkGltf(VerifyContext& context, Findings& findings) {
    SceneArrays scene;
    const auto table = gltfAlbedoTable();
    scene.albedoTables.assign(table.begin(), table.end());
    for (const bool multiscatter : {false, true}) {
        scene.features.multiscatter = multiscatter;
        GltfComparison comparison(context.prober(), scene, findings);
        comparison.values();
        comparison.samples();
        comparison.extremes();
    }
}

}  // namespace vkpt
