#include "verify/stages/shade_parts.h"

#include <algorithm>
#include <cmath>

namespace vkpt {
namespace {

constexpr double kFilmUnit = 0x1p-48;
constexpr double kPosition = 4e-7;  ///< of the largest coordinate at hand: a fifth of what rays leave a surface by

// Values that carry two decisions each: which lobe, which light. Lobes magnify rounding, hence the wide tolerances;
// narrow ones exceed them and are compared by the range of nearby inputs.
constexpr double kDirection = 2e-5, kWeight = 1e-3, kDensity = 2e-3;

/// Relative rounding of a drawn direction's cosine, sqrt(1 - x^2 - y^2): two roundings near 1 over twice the cosine's
/// square. Weights and densities follow the cosine.
double cosineRounding(double cosine) { return 0x1p-23 / std::max(cosine * cosine, 1e-12); }

/// Nits: in the tails of narrow lobes the rounding of a direction changes what is next to nothing by a percent.
constexpr double kDimSample = 1e-8;

/// Light too faint for the film to hold, or for floats: whether it exists is rounding's choice.
bool isFaint(const glm::vec3& v) { return !(std::max({v.x, v.y, v.z}) >= 1e-15F); }

/// -1 stands for the infinite density of a mirror.
double finitePdf(float pdf) { return std::isinf(pdf) ? -1.0 : double{pdf}; }

/// `magnitude`: the largest coordinate of what the vertex lies on; 0 on the device's side, which needs no tolerances.
void addDirect(Parts& parts, const reference::DirectLight& direct, double magnitude) {
    if (isFaint(direct.contribution)) return;
    const glm::dvec3 way(direct.shadowRay.direction);
    const bool directional = direct.tMax != 1;  // else the ray ends at a light
    const double size = magnitude + glm::length(glm::dvec3(direct.shadowRay.origin) + way);
    parts.push_back({"shadow ray's origin", direct.shadowRay.origin, kPosition * magnitude});
    parts.push_back({directional ? "direction of the light" : "way to the light", way,
                     directional ? kDirection : kPosition * size});
    parts.push_back({"light sample", direct.contribution, kDimSample, kWeight});
    parts.push_back({"light's group", glm::dvec3(direct.group)});
}

void addNext(Parts& parts, const reference::PathState& next, double magnitude, double cosine) {
    const double rounding = cosineRounding(cosine);
    if (isFaint(next.throughput)) return;
    parts.push_back({"next ray's origin", next.ray.origin, kPosition * magnitude});
    parts.push_back({"next direction", next.ray.direction, kDirection});
    parts.push_back({"throughput", next.throughput, 1e-9, kWeight + rounding});
    parts.push_back({"pdf", glm::dvec3(finitePdf(next.pdfBsdf)), 1e-9, kDensity + rounding});
}

}  // namespace

Part contributionPart(std::string_view name, const glm::vec3& contribution) {
    return {name, contribution, 2 * kFilmUnit, 2e-4};
}

Parts partsOf(const DeviceVertex& vertex) {
    Parts parts = {{"emitted light", vertex.emitted}};
    if (vertex.direct) addDirect(parts, *vertex.direct, 0);
    if (vertex.next) addNext(parts, *vertex.next, 0, 1);
    return parts;
}

Parts partsOf(const reference::PathVertex& vertex) {
    const double magnitude =
        glm::distance(glm::dvec3(vertex.point.rayOrigin), glm::dvec3(vertex.point.position)) / double{kOffsetScale};
    Parts parts = {contributionPart("emitted light", vertex.emitted)};
    if (vertex.direct) addDirect(parts, *vertex.direct, magnitude);
    if (vertex.next) addNext(parts, *vertex.next, magnitude, glm::dot(vertex.next->ray.direction, vertex.point.ns));
    return parts;
}

}  // namespace vkpt
