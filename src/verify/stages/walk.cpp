#include "verify/stages/walk.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "reference/accumulate.h"
#include "reference/looks.h"
#include "reference/traverse.h"
#include "registry.h"
#include "scene/pixel_filter.h"
#include "verify/stages/shade_parts.h"
#include "wavefront/kernels.h"

namespace vkpt {
namespace {

/// Share of what a stage does that rounding may decide otherwise. Where all pixels have the same random numbers, a
/// number on an edge (the first point of most sequences is 0) is there in all of them.
double mostExcused(const SamplerChoice& sampler) { return sampler.isRandomised() ? 0.01 : 0.5; }

}  // namespace

StageWalk::StageWalk(const SceneArrays& scene, const RenderOptions& options, std::string what)
    : scene_(scene),
      params_(options.params),
      mostExcused_(mostExcused(options.sampler)),
      paths_(scene, options),
      light_(scene, options),
      what_(std::move(what)) {}

void StageWalk::run(WavefrontRenderer& renderer, std::uint32_t firstPixel, std::uint32_t pixelCount) {
    const auto film = renderer.observe(firstPixel, pixelCount, [this](const StageSnapshot& now) {
        see(now);
        light_.see(paths_, before_, now);
        before_ = now;
    });
    accumulate(before_, film);
}

void StageWalk::finish() {
    for (const Stage stage : {Stage::Intersect, Stage::Miss, Stage::Shade, Stage::Shadow})
        for (const Quantity& q : std::vector(of(stage).quantities()))
            of(stage).atMost("excused: " + q.name, static_cast<double>(q.excused),
                             5 + mostExcused_ * static_cast<double>(q.compared));
}

void StageWalk::see(const StageSnapshot& now) {
    switch (now.stage) {
        case Stage::Generate:
            return generate(now);
        case Stage::Intersect:
            return intersect(now);
        case Stage::Miss:
            return miss(now);
        case Stage::Shade:
        case Stage::ShadeMicrofacet:
        case Stage::ShadeClassic:
            return shade(now);
        case Stage::Shadow:
            return shadow(now);
        case Stage::Accumulate:
        case Stage::Layers:  // writes to the film alone
            return;
    }
}

Findings::InputScope StageWalk::scope(Findings& findings, std::uint32_t bounce) {
    return findings.inputs([this, bounce](std::size_t path) {
        const DevicePaths::Place p = paths_.placeOf(before_.batch, static_cast<std::uint32_t>(path));
        return fmt::format("{}: pixel {},{}, sample {}, bounce {}", what_, p.x, p.y, p.index, bounce);
    });
}

/// Shade group of the triangle that was met.
std::uint32_t StageWalk::groupOf(const reference::Hit& hit) const {
    if (hit.triangle >= scene_.triangles.size()) return kNone;
    return scene_.triangles[hit.triangle].flags >> kTriangleGroupShift & kTriangleGroupMask;
}

/// Both hold the same slots, each once.
void StageWalk::compareQueue(Findings& findings, std::string_view name, std::vector<std::uint32_t> actual,
                             std::vector<std::uint32_t> expected) {
    std::ranges::sort(actual);
    std::ranges::sort(expected);
    findings.holds(name, actual == expected, "does not hold each path once");
}

/// Sums of paths that a stage has no business with stay as they are.
void StageWalk::compareUntouched(Findings& findings, const StageSnapshot& now, const std::vector<bool>& touched) {
    for (std::uint32_t path = 0; path < now.batch.pathCount; ++path) {
        if (touched[path]) continue;
        findings.at(path);
        findings.holds("other paths", sumsOf(now, path) == sumsOf(before_, path), "their sums changed");
    }
}

/// What a stage added to a path's sums; `first`: they begin with it.
glm::dvec3 StageWalk::added(const StageSnapshot& now, std::uint32_t path, bool first) const {
    return addedTo(first ? PathSums{} : sumsOf(before_, path), sumsOf(now, path));
}

/// Whether what is added now is the first that the paths have.
bool StageWalk::beginsSums(const StageSnapshot& now) { return now.batch.bounce == 0 && now.batch.round == 0; }

bool StageWalk::seesBackground() const {
    return !reference::isLook(params_.integrator) && params_.backgroundMode != kBackgroundTransparent;
}

bool StageWalk::countsSearch() const { return params_.integrator == static_cast<std::uint32_t>(IntegratorId::Cost); }

void StageWalk::generate(const StageSnapshot& now) {
    before_ = now;
    Findings& f = of(Stage::Generate);
    const auto where = scope(f, 0);
    std::vector<std::uint32_t> all(now.batch.pathCount);
    std::iota(all.begin(), all.end(), 0U);
    for (const std::uint32_t path : all) {
        f.at(path);
        const DevicePaths::Place place = paths_.placeOf(now.batch, path);
        const reference::PathState expected = paths_.tracer().start(place.x, place.y, place.index);
        const reference::PathState state = paths_.stateOf(now, path, 0);
        const double size = std::max(1e-30, double{glm::length(expected.ray.origin)});
        f.near("origin", state.ray.origin, expected.ray.origin, 4e-7 * size + 4e-7);
        f.near("direction", state.ray.direction, expected.ray.direction, 1e-6);
        f.equal("throughput", state.throughput, expected.throughput);
        f.holds("pdf", state.pdfBsdf == expected.pdfBsdf, "is finite");
    }
    const auto queue = now.queue(0, Queue::Ray);
    compareQueue(f, "ray queue", {queue.begin(), queue.end()}, all);
}

void StageWalk::intersect(const StageSnapshot& now) {
    Findings& f = of(Stage::Intersect);
    const std::uint32_t bounce = now.batch.bounce;
    const auto where = scope(f, bounce);
    const HitTolerance tolerance{.worldDepth = scene_.instances.empty(), .jitter = true};
    const auto compare = [&](std::uint32_t path, bool met) {
        f.at(path);
        const reference::PathState state = paths_.stateOf(before_, path, bounce);
        DeviceHit hit;
        if (met) {
            const reference::Hit h = paths_.hitOf(now, path);
            hit = {h.t, h.triangle, h.barycentrics.y, h.barycentrics.z, h.instance == kNone ? 0 : h.instance};
            if (!f.holds("slots of triangles", hit.slot < scene_.triangles.size(), "beyond the last")) return;
        }
        compareHit(scene_, state.ray, reference::alphaKey(state.sample.id, state.keyOfSegment(), kRayPath), hit,
                   tolerance, f, hits_);
    };
    const auto rays = before_.queue(bounce, Queue::Ray), missed = now.queue(bounce, Queue::Miss);
    std::vector<std::uint32_t> sorted(missed.begin(), missed.end());
    for (const Queue queue : kHitQueues) {
        const auto hit = now.queue(bounce, queue);
        sorted.insert(sorted.end(), hit.begin(), hit.end());
    }
    compareQueue(f, "hit and miss queues", sorted, {rays.begin(), rays.end()});
    for (std::uint32_t group = 0; group < kGroups; ++group)
        for (const std::uint32_t path : now.queue(bounce, kHitQueues[group])) {
            compare(path, true);
            f.equal("shade groups", needsNoBsdf(params_.integrator) ? kGroupGltf : groupOf(paths_.hitOf(now, path)),
                    group);
        }
    for (const std::uint32_t path : missed) compare(path, false);
    compareUntouched(f, now, std::vector<bool>(now.batch.pathCount));
}

void StageWalk::miss(const StageSnapshot& now) {
    Findings& f = of(Stage::Miss);
    const std::uint32_t bounce = now.batch.bounce;
    const auto where = scope(f, bounce);
    std::vector<bool> touched(now.batch.pathCount);
    for (const std::uint32_t path : before_.queue(bounce, Queue::Miss)) {
        f.at(path);
        touched[path] = true;
        const reference::PathState state = paths_.stateOf(before_, path, bounce);
        const Parts device = {{"contribution", added(now, path, beginsSums(now))}};
        compareParts(f, "miss", device, [&](Jitter* jitter) -> Parts {
            glm::vec3 expected(0);
            if (countsSearch())
                expected = state.throughput;
            else if (bounce > 0 || beginsSums(now))
                expected = paths_.tracer().miss(jitter != nullptr ? jitter->near(state) : state);
            return {contributionPart("contribution", expected)};
        });
        if (bounce > 0) continue;
        f.equal("alpha", alphaOf(now, path), seesBackground() ? 1U : 0U);
    }
    compareUntouched(f, now, touched);
}

/// Integrator cost: each renderer counts its own search; the film gets what kernel intersect has made of `throughput`.
void StageWalk::compareCost(Findings& f, const DevicePaths::Place& place, const glm::vec3& emitted,
                            const glm::vec3& throughput) const {
    f.equal("cost", emitted, throughput);
    const glm::vec3 counts = throughput / paths_.tracer().start(place.x, place.y, place.index).throughput;
    f.holds("cost", counts.x > 0.99F && counts.y > 0.99F, "is below one node and one triangle");
}

void StageWalk::shade(const StageSnapshot& now) {
    Findings& f = of(Stage::Shade);
    const std::uint32_t bounce = now.batch.bounce;
    const Queue hits = kHitQueues[shadeGroupOf(now.stage)];
    const auto name = kStageNames[static_cast<std::size_t>(now.stage)];
    // The kernels of the groups append one after the other.
    const std::uint32_t firstItem = before_.queueSize(bounce, Queue::Shadow),
                        firstRay = before_.queueSize(bounce + 1, Queue::Ray);
    const auto where = scope(f, bounce);
    const std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> itemOf(now.batch.pathCount, none);
    for (std::uint32_t item = firstItem; item < now.queueSize(bounce, Queue::Shadow); ++item) {
        const std::uint32_t path = shadowOf(now, item).path;
        if (!f.holds("shadow items", path < now.batch.pathCount && itemOf[path] == none, "two of one path")) continue;
        itemOf[path] = item;
    }
    std::vector<bool> goesOn(now.batch.pathCount), touched(now.batch.pathCount);
    for (const std::uint32_t path : now.queue(bounce + 1, Queue::Ray).subspan(firstRay)) {
        f.at(path);
        if (f.holds("ray queue", path < goesOn.size() && !goesOn[path], "holds a path twice")) goesOn[path] = true;
    }
    for (const std::uint32_t path : before_.queue(bounce, hits)) {
        f.at(path);
        touched[path] = true;
        DeviceVertex vertex{added(now, path, beginsSums(now)), {}, {}};
        if (itemOf[path] != none) vertex.direct = shadowOf(now, itemOf[path]).light;
        if (goesOn[path]) vertex.next = paths_.stateOf(now, path, bounce + 1);
        if (bounce == 0) f.equal("alpha", alphaOf(now, path), 1U);
        itemOf[path] = none;
        goesOn[path] = false;
        const reference::PathState state = paths_.stateOf(before_, path, bounce);
        const reference::Hit hit = paths_.hitOf(before_, path);
        if (countsSearch()) {
            compareCost(f, paths_.placeOf(now.batch, path), glm::vec3(vertex.emitted), state.throughput);
            continue;
        }
        compareParts(f, name, partsOf(vertex), [&](Jitter* jitter) {
            return jitter != nullptr ? partsOf(paths_.tracer().shade(jitter->near(state), jitter->near(hit)))
                                     : partsOf(paths_.tracer().shade(state, hit));
        });
    }
    for (std::uint32_t path = 0; path < now.batch.pathCount; ++path) {
        f.at(path);
        f.holds("other paths", itemOf[path] == none && !goesOn[path], "one that met nothing goes on");
    }
    compareUntouched(f, now, touched);
}

void StageWalk::shadow(const StageSnapshot& now) {
    Findings& f = of(Stage::Shadow);
    const std::uint32_t bounce = now.batch.bounce;
    const auto where = scope(f, bounce);
    std::vector<bool> touched(now.batch.pathCount);
    for (std::uint32_t item = 0; item < before_.queueSize(bounce, Queue::Shadow); ++item) {
        const auto [path, light] = shadowOf(before_, item);
        f.at(path);
        touched[path] = true;
        FilmSums sums{};
        if (!reference::addContribution(sums, light.contribution, hasNegativeLobes(params_.pixelFilter))) continue;
        const PathSums whole = {sumOf(sums.red), sumOf(sums.green), sumOf(sums.blue)};
        const PathSums change = changeOf(sumsOf(before_, path), sumsOf(now, path));
        const bool arrived = change == whole;
        if (!f.holds("sums", arrived || change == PathSums{}, "neither unchanged nor with the sample added")) continue;
        if (whole == PathSums{}) continue;  // too faint for the film: whether it arrived cannot be seen
        const reference::PathState state = paths_.stateOf(before_, path, bounce);
        const auto parts = [](bool arrives) -> Parts {
            if (!arrives) return {};
            return {{"light that arrives", glm::dvec3(1)}};
        };
        compareParts(f, "shadow ray", parts(arrived), [&](Jitter* jitter) {
            reference::DirectLight ray = light;
            if (jitter != nullptr) ray.shadowRay = jitter->near(light.shadowRay);
            reference::PathState at = state;
            at.bounce = bounce;
            return parts(!paths_.tracer().isOccluded(at, ray));
        });
    }
    compareUntouched(f, now, touched);
}

void StageWalk::accumulate(const StageSnapshot& now, const ObservedFilm& film) {
    Findings& f = of(Stage::Accumulate);
    const auto where = scope(f, 0);
    std::vector<PathSums> expected(now.batch.pixelCount);
    std::vector<std::uint32_t> alpha(now.batch.pixelCount);
    for (std::uint32_t path = 0; path < now.batch.pathCount; ++path) {
        const std::uint32_t pixel = placeOfSlot(now.batch, path).pixel - now.batch.firstPixel;
        const PathSums sums = sumsOf(now, path);
        for (std::size_t c = 0; c < 3; ++c) expected[pixel][c] = (expected[pixel][c] + sums[c]) % kModulus;
        alpha[pixel] += alphaOf(now, path);
    }
    for (std::uint32_t pixel = 0; pixel < now.batch.pixelCount; ++pixel) {
        f.at(std::size_t{pixel} * now.batch.sampleCount);
        const FilmSums& sums = film.sums[pixel];
        f.holds("film", PathSums{sumOf(sums.red), sumOf(sums.green), sumOf(sums.blue)} == expected[pixel],
                "is not the sum of its paths");
        f.equal("alpha", sums.red.w, alpha[pixel]);
    }
    light_.compare(f, film, now.batch.sampleCount);
    f.equal("refused contributions", now.counters[kRefusedCounter], 0U);
}

}  // namespace vkpt
