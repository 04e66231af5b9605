#include <cmath>

#include "scene/bsdf_spec.h"
#include "scene/facets.h"

namespace vkpt {
namespace {

glm::vec3 meanReflectance(const BsdfSpec& spec) {
    glm::vec3 mean(0);
    if (spec.metal) {
        for (int c = 0; c < 3; ++c)
            mean[c] = static_cast<float>(facets::hemisphericalMean(
                [&](double cosine) { return facets::conductor(cosine, spec.eta[c], spec.k[c]); }));
        return mean;
    }
    const double eta = spec.eta.x;
    const auto mean1 = [](double n) {
        return static_cast<float>(facets::hemisphericalMean([n](double c) { return facets::dielectric(c, n); }));
    };
    mean.x = mean1(eta);
    mean.y = static_cast<float>(1 - (1 - static_cast<double>(mean.x)) / (eta * eta));  // by reciprocity
    return mean;
}

/// Beer-Lambert, 1/m.
glm::vec3 absorption(const BsdfSpec& spec) {
    return -glm::log(spec.attenuationColor) / spec.attenuationDistance + 0.0F;  // no -0
}

}  // namespace

bool isAnisotropic(const BsdfSpec& spec) {
    const bool twoWays = spec.model == BsdfId::Conductor || spec.model == BsdfId::Dielectric ||
                         spec.model == BsdfId::Plastic || spec.model == BsdfId::TorranceSparrow;
    if (spec.model == BsdfId::AshikhminShirley) return spec.exponent.x != spec.exponent.y;
    return twoWays && spec.alpha.x != spec.alpha.y;
}

BsdfRecord bsdfRecord(const BsdfSpec& spec) {
    BsdfRecord record{};
    record.color = spec.color;
    record.diffuse = spec.model == BsdfId::Dielectric ? absorption(spec) : spec.diffuse;
    record.alphaX = spec.alpha.x;
    record.alphaY = spec.alpha.y;
    record.eta = spec.eta;
    record.k = spec.k;
    record.exponentX = spec.exponent.x;
    record.exponentY = spec.exponent.y;
    record.average = meanReflectance(spec);
    record.weight = spec.weight;
    record.flags = static_cast<std::uint32_t>(spec.distribution) |
                   static_cast<std::uint32_t>(spec.masking) << kBsdfMaskingShift | (spec.metal ? kBsdfMetal : 0U) |
                   (spec.conserving ? kBsdfConserving : 0U);
    record.table = kNone;
    record.sigma = spec.sigma;
    record.specular = spec.specular;
    return record;
}

}  // namespace vkpt
