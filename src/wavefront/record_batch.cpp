// One batch of paths, from camera rays to the film: the stages in order.
#include <algorithm>
#include <cstring>

#include "gpu/transfer.h"
#include "registry.h"
#include "wavefront/renderer_impl.h"

namespace vkpt {
namespace {

using Clock = std::chrono::steady_clock;

/// Whether shadow rays may leave the surfaces that segment `bounce` meets.
bool hasShadowRays(const RenderParams& params, std::uint32_t bounce) {
    return bounce < params.maxDepth || params.integrator == static_cast<std::uint32_t>(IntegratorId::Ao);
}

/// How often the paths of a batch begin: once, or for every sample of integrator direct.
std::uint32_t roundsOf(const RenderParams& p) {
    if (p.integrator != static_cast<std::uint32_t>(IntegratorId::Direct) || p.maxDepth == 0) return 1;
    const std::uint32_t lightSamples = p.strategy == kStrategyBsdf ? 0 : p.lightSamples;
    return std::max({p.bsdfSamples, lightSamples, 1U});
}

std::uint32_t groupsFor(std::uint32_t items) { return (items + kGroupSize - 1) / kGroupSize; }

}  // namespace

/// Whether paths that leave the scene on segment `bounce` add anything. An observer sees the stage all the same.
bool WavefrontRenderer::Impl::meetsBeyond(std::uint32_t bounce) const {
    return bounce == 0 || layout.header.envWidth != 0 || observer != nullptr;
}

/// Ends a stage that has just been recorded.
void WavefrontRenderer::Impl::finish(Stage stage, const BatchParams& batch) {
    recorder.barrier();
    if (observer) return show(stage, batch);
    if (!config.timings) return;
    stamps.push_back(stage);
    recorder.timestamp(static_cast<std::uint32_t>(stamps.size()));
}

/// Runs what is recorded and shows the device to the observer; recording goes on afterwards.
void WavefrontRenderer::Impl::show(Stage stage, const BatchParams& batch) {
    recorder.submitAndWait();
    const StageSnapshot snapshot{stage, batch, readStorage<uvec4>(device, state, 0, stateBytes(capacity) / 16),
                                 readStorage<std::uint32_t>(device, counters, 0, counterBytes(capacity) / 4)};
    (*observer)(snapshot);
    recorder.begin();
}

void WavefrontRenderer::Impl::recordStart(const FilmBand& band, const BatchParams& batch) {
    const std::size_t begin = queueCounterOffset(0, Queue::Ray);
    recorder.copy(freshCounters, begin, counters, begin, usedCounterBytes() - begin);
    recorder.barrier();
    const QueueCounter all{groupsFor(batch.pathCount), 1, 1, batch.pathCount};
    recorder.update(counters, queueCounterOffset(0, Queue::Ray), std::as_bytes(std::span(&all, 1)));
    recorder.barrier();
    recorder.dispatch(kernels.generate, band.group, batch, groupsFor(batch.pathCount));
    finish(Stage::Generate, batch);
}

void WavefrontRenderer::Impl::recordBounces(const FilmBand& band, BatchParams batch, std::uint32_t begin,
                                            std::uint32_t end) {
    const auto stage = [&](const Kernel& kernel, Queue queue, Stage id) {
        recorder.dispatchIndirect(kernel, band.group, batch, counters, queueCounterOffset(batch.bounce, queue));
        finish(id, batch);
    };
    for (batch.bounce = begin; batch.bounce < end; ++batch.bounce) {
        const WavefrontKernels& k = active();
        stage(k.intersect, Queue::Ray, Stage::Intersect);
        if (batch.bounce == 0 && batch.round == 0 && k.layers) recordLayers(band, batch);
        if (meetsBeyond(batch.bounce)) stage(k.miss, Queue::Miss, Stage::Miss);
        for (std::size_t group = 0; group < k.shade.size(); ++group)
            if (k.shade[group]) stage(*k.shade[group], kHitQueues[group], kShadeStages[group]);
        if (k.shadow && hasShadowRays(options.params, batch.bounce)) stage(*k.shadow, Queue::Shadow, Stage::Shadow);
    }
}

/// Of the hits of the camera rays.
void WavefrontRenderer::Impl::recordLayers(const FilmBand& band, const BatchParams& batch) {
    recorder.dispatch(*kernels.layers, band.group, batch, groupsFor(batch.pixelCount));
    finish(Stage::Layers, batch);
}

void WavefrontRenderer::Impl::recordEnd(const FilmBand& band, const BatchParams& batch) {
    recorder.dispatch(kernels.accumulate, band.group, batch, groupsFor(batch.pixelCount));
    finish(Stage::Accumulate, batch);
}

void WavefrontRenderer::Impl::submit(WavefrontStats& stats) {
    recorder.copy(counters, 0, readback, 0, usedCounterBytes());
    recorder.submitAndWait();
    if (!config.timings) return;
    const std::vector<double> times = recorder.timestampsSeconds();
    for (std::size_t i = 0; i < stamps.size() && i + 1 < times.size(); ++i)
        stats.stages[static_cast<std::size_t>(stamps[i])].seconds += times[i + 1] - times[i];
}

void WavefrontRenderer::Impl::renderBatch(const FilmBand& band, BatchParams batch, WavefrontStats& stats) {
    const auto start = Clock::now();
    batch.capacity = capacity;
    batch.pathCount = batch.pixelCount * batch.sampleCount;
    batch.sampleReciprocal = reciprocalOf(batch.sampleCount);
    batch.widthReciprocal = reciprocalOf(options.params.width);
    batch.filmFirst = band.band.firstPixel;
    batch.filmLayers = band.band.pixelCount * sizeof(FilmSums) / sizeof(uvec4);
    const std::uint32_t rounds = roundsOf(options.params);
    for (; batch.round < rounds; ++batch.round) renderRound(band, batch, batch.round + 1 == rounds, stats);
    stats.paths += batch.pathCount;
    ++stats.batches;
    batchSeconds = secondsSince(start);
}

/// From camera rays to the end of their paths; `last`: then to the film.
void WavefrontRenderer::Impl::renderRound(const FilmBand& band, const BatchParams& batch, bool last,
                                          WavefrontStats& stats) {
    const std::uint32_t bounces = options.params.maxDepth + 1;
    stats.stages[static_cast<std::size_t>(Stage::Generate)].items += batch.pathCount;
    bool more = true;
    for (std::uint32_t begin = 0; more; begin += kBouncesPerSubmit) {
        const std::uint32_t end = std::min(begin + kBouncesPerSubmit, bounces);
        stamps.clear();
        recorder.begin();
        if (config.timings) recorder.timestamp(0);
        if (begin == 0) recordStart(band, batch);
        recordBounces(band, batch, begin, end);
        if (end == bounces && last) recordEnd(band, batch);
        submit(stats);
        more = end < bounces;
        QueueCounter left;
        std::memcpy(&left, readback.map().data() + queueCounterOffset(end, Queue::Ray), sizeof left);
        if (more && left.items == 0) {  // every path has ended: only the film is left
            stamps.clear();
            recorder.begin();
            if (config.timings) recorder.timestamp(0);
            if (last) recordEnd(band, batch);
            submit(stats);
            more = false;
        }
    }
    gatherCounters(stats);
}

void WavefrontRenderer::Impl::gatherCounters(WavefrontStats& stats) {
    const auto* words = reinterpret_cast<const std::uint32_t*>(readback.map().data());
    for (std::uint32_t b = 0; b < counterBlocks() - 1; ++b) {
        const auto items = [&](Queue queue) { return words[queueCounterOffset(b, queue) / 4 + 3]; };
        stats.stages[static_cast<std::size_t>(Stage::Intersect)].items += items(Queue::Ray);
        if (meetsBeyond(b)) stats.stages[static_cast<std::size_t>(Stage::Miss)].items += items(Queue::Miss);
        for (std::size_t group = 0; group < kShadeStages.size(); ++group)
            stats.stages[static_cast<std::size_t>(kShadeStages[group])].items += items(kHitQueues[group]);
        stats.stages[static_cast<std::size_t>(Stage::Shadow)].items += items(Queue::Shadow);
    }
    stats.refused = words[kRefusedCounter];
    stats.refusedInLayers = words[kRefusedInLayersCounter];
}

}  // namespace vkpt
