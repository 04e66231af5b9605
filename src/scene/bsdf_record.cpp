#include <cmath>

#include "scene/bsdf_spec.h"
#include "scene/facets.h"

namespace vkpt {
namespace {

/// From outside, and from inside: by reciprocity.
glm::vec3 meanReflectance(const BsdfSpec& spec) {
    if (spec.metal) return glm::vec3(0);
    const double eta = spec.eta.x;
    const double mean = facets::hemisphericalMean([eta](double c) { return facets::dielectric(c, eta); });
    return {mean, 1 - (1 - mean) / (eta * eta), 0};
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
