#include "reference/path.h"

#include <algorithm>

#include "dimensions.h"
#include "reference/accumulate.h"
#include "reference/camera.h"
#include "reference/layers.h"
#include "reference/looks.h"
#include "reference/medium.h"
#include "scene/pixel_filter.h"

namespace vkpt::reference {

PathTracer::PathTracer(const SceneArrays& scene, const RenderOptions& options)
    : scene_(scene),
      params_(options.params),
      transport_(scene, options.params),
      bits_(samplerBits(options.sampler)),
      filter_(filterTable(options.params)) {}

void PathTracer::add(PathTally& tally, const glm::vec3& contribution, const LightOrigin& origin) const {
    if (isBlack(contribution)) return;
    FilmSums added{};
    if (!addContribution(added, contribution, hasNegativeLobes(params_.pixelFilter))) {
        ++tally.refused;
        return;
    }
    addSums(tally.sums, added);
    if (tally.layers != nullptr) tally.layers->addLight(added, origin);
}

std::uint32_t PathTracer::rounds() const {
    const Heuristic& h = transport_.heuristic;
    return std::max({1U, h.bsdfSamples(), h.lightSamples()});
}

PathState PathTracer::start(std::uint32_t x, std::uint32_t y, std::uint32_t index) const {
    PathState state;
    state.sample = sampleOf(x, y, index);
    const FilmPlace place = sampleFilter(filter_, state.sample.get2D(kDimFilter));
    const Ray pinhole = cameraRay(params_, glm::vec2(x, y) + place.position);
    state.ray = transport_.hasLens() ? lensRay(params_, pinhole, state.sample.get2D(kDimLens)) : pinhole;
    state.throughput = glm::vec3(place.weight);
    return state;
}

std::optional<Hit> PathTracer::intersect(const PathState& state, SearchCost* cost) const {
    return closestHit(scene_, state.ray, alphaKey(state.sample.id, state.keyOfSegment(), kRayPath), cost);
}

glm::vec3 PathTracer::miss(const PathState& state) const {
    if (isLook(params_.integrator)) return glm::vec3(0);
    const glm::vec3& d = state.ray.direction;
    const Environment& environment = transport_.lights.environment();
    if (state.bounce > 0) {
        const bool isLight = scene_.envLight != kNone;
        const float w = transport_.heuristic.ofEmission(state.pdfBsdf, isLight, transport_.lights.pdfEnvironment(d));
        const glm::vec3 left = transmittance(scene_, state.medium, std::numeric_limits<float>::infinity());
        return transport_.clamped(state.throughput * left * environment.radiance(d) * w, state.bounce);
    }
    if (params_.backgroundMode == kBackgroundTransparent) return glm::vec3(0);
    return state.throughput *
           (params_.backgroundMode == kBackgroundColor ? params_.background : environment.radiance(d));
}

PathVertex PathTracer::shade(const PathState& state, const Hit& hit) const {
    if (isLook(params_.integrator)) return look(transport_, state, hit);
    return Surface(transport_, state, hit).shade();
}

bool PathTracer::isOccluded(const PathState& state, const DirectLight& direct) const {
    return anyHit(scene_, direct.shadowRay, direct.tMax,
                  alphaKey(state.sample.id, state.numbersOfSurface(), kRayShadow));
}

void PathTracer::countCameraRay(PathTally& tally, const PathState& camera, const std::optional<Hit>& hit) const {
    const bool background = params_.backgroundMode != kBackgroundTransparent && !isLook(params_.integrator);
    if (hit || background) ++tally.sums.red.w;
    if (hit) ++tally.sums.green.w;
    if (tally.layers != nullptr) tally.layers->addFirstHit(camera.ray, hit);
}

/// From the surface, or nothing, that the segment of `state` met to the path's end.
void PathTracer::follow(std::optional<PathState> state, std::optional<Hit> hit, PathTally& tally) const {
    while (hit) {
        const PathVertex vertex = shade(*state, *hit);
        add(tally, vertex.emitted, {state->bounce, emitterGroup(scene_, *hit)});
        if (vertex.direct) {
            ++tally.shadowRays;
            if (!isOccluded(*state, *vertex.direct))
                add(tally, vertex.direct->contribution, {state->bounce + 1, vertex.direct->group});
        }
        state = vertex.next;
        if (!state) return;
        ++tally.pathRays;
        hit = intersect(*state);  // 1
    }
    add(tally, miss(*state), {state->bounce, scene_.lightGroups.behind});  // 2
}

void PathTracer::trace(std::uint32_t x, std::uint32_t y, std::uint32_t index, PathTally& tally) const {
    PathState camera = start(x, y, index);
    SearchCost cost;
    ++tally.pathRays;
    const auto hit = intersect(camera, &cost);
    countCameraRay(tally, camera, hit);
    if (params_.integrator == static_cast<std::uint32_t>(IntegratorId::Cost))
        return add(tally, camera.throughput * glm::vec3(cost.nodes, cost.triangles, 0), {});
    if (!hit) return add(tally, miss(camera), {0, scene_.lightGroups.behind});
    for (; camera.round < rounds(); ++camera.round) follow(camera, hit, tally);
}

}  // namespace vkpt::reference
