#include "analysis/facet_study.h"

#include <cmath>
#include <numbers>

#include "reference/microfacet/facets.h"

namespace vkpt {
namespace {

using FacetsDouble = reference::Facets<double>;

constexpr int kSteepest = 89, kFixedTilt = -60;  ///< degrees

/// Tilted from the normal towards x.
glm::dvec3 tilted(int degrees) {
    const double theta = degrees * std::numbers::pi / 180;
    return {std::sin(theta), 0, std::cos(theta)};
}

bool hasOneDistribution(BsdfId model) {
    return model == BsdfId::Conductor || model == BsdfId::Dielectric || model == BsdfId::Plastic ||
           model == BsdfId::TorranceSparrow;
}

double maskedBetween(const FacetsDouble& facets, const glm::dvec3& wo, const glm::dvec3& wi) {
    return reference::maskingG2(facets, wo, wi, glm::normalize(wo + wi));
}

}  // namespace

Json facetsJson(const reference::LoneBsdf& bsdf) {
    const reference::Bsdf<double> b = bsdf.seenFrom<double>(true);
    if (!hasOneDistribution(b.model) || b.isDelta()) return nullptr;
    FacetsDouble facets = b.facets();
    if (b.model == BsdfId::TorranceSparrow) facets.masking = kMaskingVGroove;
    const glm::dvec3 normal(0, 0, 1);
    Json degrees = Json::array(), density = Json::array(), one = Json::array(), mirror = Json::array(),
         fixed = Json::array();
    for (int tilt = -kSteepest; tilt <= kSteepest; ++tilt) {
        const glm::dvec3 w = tilted(tilt);
        degrees.push_back(tilt);
        density.push_back(reference::facetD(facets, w));
        one.push_back(reference::maskingG1(facets, w, normal));
        mirror.push_back(maskedBetween(facets, tilted(-tilt), w));
        fixed.push_back(maskedBetween(facets, tilted(kFixedTilt), w));
    }
    return {{"degrees", degrees}, {"D", density}, {"G1", one}, {"G2", mirror}, {"G2From60", fixed}};
}

}  // namespace vkpt
