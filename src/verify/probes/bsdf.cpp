// Every BSDF model of the registry over its parameters and directions, against the reference in double. Tolerances
// follow what the reference itself gives for inputs a few ulps off: narrow lobes magnify the rounding of directions.
#include "reference/bsdf.h"

#include <cmath>

#include "verify/context.h"
#include "verify/inputs/bsdfs.h"
#include "verify/inputs/jitter.h"
#include "verify/probes.h"

namespace vkpt {
namespace {

struct In {
    glm::vec3 wo;
    std::uint32_t material;
    glm::vec3 wi;
    std::uint32_t model;
    float uLobe;
    glm::vec2 u;
    std::uint32_t front;
    glm::vec3 color;
    float roughness;
};
struct Out {
    glm::vec3 f;
    float pdf;
    glm::vec3 wi;
    float samplePdf;
    glm::vec4 weight;
};

/// Directions beyond a boundary that wo would be refracted to.
glm::vec3 refracted(const glm::vec3& wo, float eta) {
    const float s2 = (1 - wo.z * wo.z) / (eta * eta);
    return {-wo.x / eta, -wo.y / eta, -std::sqrt(std::max(1 - s2, 0.01F))};
}

std::vector<In> inputsOf(const BsdfCase& c, const BsdfRecord& record, RandomInputs& random) {
    std::vector<In> inputs;
    int i = 0;
    for (const float cosO : {1.0F, 0.95F, 0.7F, 0.4F, 0.1F, 0.01F})
        for (int k = 0; k < 8; ++k, ++i) {
            const glm::vec3 wo = atCosine(cosO, random.unit());
            const std::uint32_t front = k % 3 == 2 ? 0 : 1;
            const float spread = 2 * std::max(record.alphaX, record.alphaY) + 0.02F;
            const float eta = front != 0 ? record.eta.x : 1 / record.eta.x;
            glm::vec3 wi = atCosine(random.between(1e-3F, 1), random.unit());
            if (k % 4 == 1) wi = glm::normalize(glm::vec3(-wo.x, -wo.y, wo.z) + spread * random.direction());
            if (k % 4 == 2) wi = glm::normalize(refracted(wo, eta) + spread * random.direction());
            const bool mapped = k == 5;
            inputs.push_back({wo, c.material, wi, static_cast<std::uint32_t>(c.model), random.unit(), random.square(),
                              front, mapped ? random.inBox({0, 0, 0}, {1, 1, 1}) : glm::vec3(1),
                              mapped ? random.between(0.5F, 1) : 1.0F});
        }
    return inputs;
}

class Comparison {
public:
    Comparison(const SceneArrays& scene, Findings& findings) : scene_(scene), findings_(findings), random_(87) {}

    void compare(const In& in, const Out& out) {
        const auto model = static_cast<BsdfId>(in.model);
        name_ = kBsdfModels[in.model].name;
        // Which lobes are delta is decided by the float alpha, as in both renderers.
        bsdf_ = reference::makeBsdf<double>(model, scene_.bsdfs[in.material], glm::dvec3(in.color),
                                            double{in.roughness}, in.front != 0, scene_);
        compareValue(in, out);
        compareSample(in, out);
        checkSound(out);
    }
    [[nodiscard]] std::size_t samples() const { return samples_; }

private:
    void near(std::string_view what, const glm::dvec3& actual, const glm::dvec3& expected, double absolute,
              double relative) {
        findings_.near(fmt::format("{} {}", name_, what), actual, expected, absolute, relative);
    }
    void near(std::string_view what, double actual, double expected, double absolute, double relative) {
        findings_.near(fmt::format("{} {}", name_, what), actual, expected, absolute, relative);
    }

    /// f and pdf of wi as the device has it.
    void compareAt(std::string_view what, const glm::dvec3& wo, const glm::dvec3& wi, const glm::dvec3& f, double pdf) {
        const glm::dvec3 expected = reference::evalBsdf(bsdf_, wo, wi);
        const double fJitter = jitterOf(expected, random_, [&](RandomInputs& r) {
            return reference::evalBsdf(bsdf_, jittered(wo, r), jittered(wi, r));
        });
        near(fmt::format("f{}", what), f, expected, 1e-6 + 3 * fJitter, 5e-5);
        const double density = reference::pdfBsdf(bsdf_, wo, wi);
        const double pdfJitter = jitterOf(density, random_, [&](RandomInputs& r) {
            return reference::pdfBsdf(bsdf_, jittered(wo, r), jittered(wi, r));
        });
        near(fmt::format("pdf{}", what), pdf, density, 1e-6 + 3 * pdfJitter, 5e-5);
    }

    void compareValue(const In& in, const Out& out) {
        compareAt("", glm::dvec3(in.wo), glm::dvec3(in.wi), glm::dvec3(out.f), out.pdf);
    }

    void compareSample(const In& in, const Out& out) {
        const glm::dvec3 wo(in.wo);
        const auto draw = [&](const glm::dvec3& o, double lobe, const glm::dvec2& u) {
            return reference::sampleBsdf<double>(bsdf_, o, lobe, u);
        };
        const auto expected = draw(wo, in.uLobe, glm::dvec2(in.u));
        const double jitter = jitterOf(expected.wi, random_, [&](RandomInputs& r) {
            const auto shake = [&] { return r.between(-1.2e-7F, 1.2e-7F); };
            const glm::dvec2 u(double{in.u.x} + double{shake()}, double{in.u.y} + double{shake()});
            return draw(jittered(wo, r), double{in.uLobe} + 10 * double{shake()}, glm::clamp(u, 0.0, 1 - 0x1p-25)).wi;
        });
        if (jitter > 1e-2) return;  // another lobe, or no direction, is rounding's choice
        const bool sunk = expected.weight == glm::dvec3(0) && out.weight == glm::vec4(0);
        if (sunk) return;
        ++samples_;
        near("sampled direction", glm::dvec3(out.wi), expected.wi, 1e-5 + 3 * jitter, 0);
        if (std::isinf(expected.pdf)) {
            findings_.equal(fmt::format("{} pdf of a delta lobe", name_), out.samplePdf, -1.0F);
            near("weight of a delta lobe", glm::dvec3(out.weight), expected.weight, 1e-6, 2e-5);
            return;
        }
        // f, pdf and weight belong to the direction that the shader drew.
        const glm::dvec3 wi(out.wi), f = reference::evalBsdf(bsdf_, wo, wi);
        const double pdf = reference::pdfBsdf(bsdf_, wo, wi);
        if (!(pdf > 0)) return;
        const double pdfJitter = jitterOf(
            pdf, random_, [&](RandomInputs& r) { return reference::pdfBsdf(bsdf_, jittered(wo, r), jittered(wi, r)); });
        near("pdf of a sample", out.samplePdf, pdf, 1e-6 + 3 * pdfJitter, 1e-4);
        const auto weightAt = [&](const glm::dvec3& o, const glm::dvec3& i) {
            return reference::evalBsdf(bsdf_, o, i) * (std::abs(i.z) / reference::pdfBsdf(bsdf_, o, i));
        };
        const glm::dvec3 weight = f * (std::abs(wi.z) / pdf);
        const double weightJitter =
            jitterOf(weight, random_, [&](RandomInputs& r) { return weightAt(jittered(wo, r), jittered(wi, r)); });
        near("weight", glm::dvec3(out.weight), weight, 1e-6 + 3 * weightJitter, 1e-4);
    }

    void checkSound(const Out& out) {
        const auto isSound = [](double v) { return std::isfinite(v) && v >= 0; };
        for (int c = 0; c < 3; ++c)
            findings_.holds("finite values", isSound(out.f[c]) && isSound(out.weight[c]), "f or weight is not");
        findings_.holds("finite densities", isSound(out.pdf) && (isSound(out.samplePdf) || out.samplePdf == -1),
                        "a pdf is not");
    }

    const SceneArrays& scene_;
    Findings& findings_;
    RandomInputs random_;
    reference::Bsdf<double> bsdf_;
    std::string_view name_;
    std::size_t samples_ = 0;
};

void checkGroup(VerifyContext& context, Findings& findings, const BsdfCases& all, BsdfGroup group, const char* probe) {
    std::vector<In> inputs;
    RandomInputs random(86);
    for (const BsdfCase& c : all.cases)
        if (kBsdfModels[static_cast<std::size_t>(c.model)].group == group)
            for (const In& in : inputsOf(c, all.scene.bsdfs[c.material], random)) inputs.push_back(in);
    const ProbeScene scene(context.prober(), all.scene);
    const auto out = context.prober().evaluate<Out>(probe, inputs, scene.options(Fetch::Storage));
    const auto scope = findings.inputs([&](std::size_t i) {
        const In& in = inputs[i];
        return fmt::format("{}{}, wo {}, wi {}, uLobe {}, u {}, {}, map {} {}", all.cases[in.material].text,
                           all.scene.features.multiscatter ? ", multiscatter" : "", show(in.wo), show(in.wi), in.uLobe,
                           show(in.u), in.front != 0 ? "front" : "back", show(in.color), in.roughness);
    });
    Comparison comparison(all.scene, findings);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        findings.at(i);
        comparison.compare(inputs[i], out[i]);
    }
    findings.atLeast("samples compared", static_cast<double>(comparison.samples()),
                     0.5 * static_cast<double>(inputs.size()));
}

}  // namespace

void checkBsdfs(VerifyContext& context, Findings& findings) {
    for (const bool multiscatter : {false, true}) {
        const BsdfCases all = makeBsdfCases(multiscatter);
        checkGroup(context, findings, all, BsdfGroup::Microfacet, "bsdf_microfacet");
        checkGroup(context, findings, all, BsdfGroup::Classic, "bsdf_classic");
    }
}

}  // namespace vkpt
