#include "wavefront/renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <limits>

#include "base/error.h"
#include "gpu/device.h"
#include "gpu/memory_plan.h"
#include "gpu/recorder.h"
#include "gpu/transfer.h"
#include "wavefront/batches.h"
#include "wavefront/kernels.h"
#include "wavefront/layout.h"
#include "wavefront/scene_upload.h"

namespace vkpt {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint32_t kDefaultPaths = 1U << 18;
constexpr std::uint32_t kBouncesPerSubmit = 16;
constexpr double kSubmitSeconds = 0.15;  ///< aim on real GPUs, whose watchdogs end long submissions

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

std::uint32_t groupsFor(std::uint32_t items) { return (items + kGroupSize - 1) / kGroupSize; }

struct Frame {  // the uniform block of shaders/geometry/fetch.glsl
    SceneHeader scene;
    RenderParams render;
};

WavefrontStats zeroStats(bool withLayers) {
    WavefrontStats stats;
    for (const char* name : kStageNames) stats.stages.push_back({name, 0, 0});
    if (!withLayers) stats.stages.pop_back();
    return stats;
}

bool useTexels(const Device& device, WavefrontConfig::Fetch fetch, std::size_t bytes) {
    const bool texelsFit = TexelView::fits(device, bytes);
    const bool storageFits = bytes <= device.info().limits.maxStorageBufferRange;
    if (!texelsFit && !storageFits)
        throw DeviceError(fmt::format("the scene needs {} MiB in one buffer; {} binds at most {} MiB", bytes >> 20,
                                      device.info().name,
                                      std::max<std::uint64_t>(device.info().limits.maxStorageBufferRange,
                                                              device.info().limits.maxTexelBufferElements * 16) >>
                                          20));
    if (fetch == WavefrontConfig::Fetch::Texel && !texelsFit)
        throw DeviceError("--fetch texel: the scene exceeds the device's maxTexelBufferElements; use storage");
    if (fetch == WavefrontConfig::Fetch::Storage && !storageFits)
        throw DeviceError("--fetch storage: the scene exceeds the device's maxStorageBufferRange; use texel");
    if (fetch != WavefrontConfig::Fetch::Auto) return fetch == WavefrontConfig::Fetch::Texel;
    return texelsFit && (device.info().isCpu || !storageFits);
}

/// Path state is read through texels where kernels run on the CPU: a load takes a third of the time there.
bool useStateTexels(const Device& device, WavefrontConfig::Fetch fetch, std::size_t bytes) {
    return fetch != WavefrontConfig::Fetch::Storage && device.info().isCpu && TexelView::fits(device, bytes);
}

/// What kernels that know N fold: grids of strata, their reciprocals, lengths of loops.
std::uint32_t setSamples(const RenderOptions& options) {
    return samplerInfo(options.sampler.id).counts == SampleCounts::Any ? 0 : options.params.spp;
}

}  // namespace

struct WavefrontRenderer::Impl {
    struct FilmBand {
        Band band;
        Buffer film;  ///< FilmSums of every pixel, then the words of its layers
        BindGroup group;
    };

    /// Shows `observer` every stage while it lives.
    struct Watch {
        Watch(Impl& renderer, const StageObserver& observer) : impl(renderer) { impl.observer = &observer; }
        ~Watch() { impl.observer = nullptr; }
        Watch(const Watch&) = delete;
        Watch& operator=(const Watch&) = delete;
        Impl& impl;
    };

    RenderOptions options;
    WavefrontConfig config;
    Device device;
    SceneLayout layout;
    FilmLayout filmLayout;
    std::uint32_t capacity;
    bool texels, stateTexel, ballot;
    MemoryPlan plan;
    WavefrontKernels kernels;
    Buffer frame, scene, dummy, state, counters, freshCounters, readback;
    TexelView sceneTexels, stateTexels;
    std::vector<FilmBand> bands;
    Recorder recorder;
    double uploadSeconds = 0;

    Impl(const SceneArrays& arrays, const RenderOptions& renderOptions, const WavefrontConfig& wavefrontConfig);
    void createBuffers(const SceneArrays& arrays);
    void writeFrame();
    void clearFilm();
    [[nodiscard]] std::uint32_t counterBlocks() const { return options.params.maxDepth + 2; }

    void recordStart(const FilmBand& band, const BatchParams& batch);
    void recordBounces(const FilmBand& band, BatchParams batch, std::uint32_t begin, std::uint32_t end);
    void recordLayers(const FilmBand& band, const BatchParams& batch);
    void recordEnd(const FilmBand& band, const BatchParams& batch);
    void finish(Stage stage, const BatchParams& batch);
    void show(Stage stage, const BatchParams& batch);
    void submit(WavefrontStats& stats);
    void renderBatch(const FilmBand& band, BatchParams batch, WavefrontStats& stats);
    void renderPass(std::uint32_t firstSample, std::uint32_t sampleCount, const RenderControl& control,
                    std::uint64_t totalPaths, WavefrontStats& stats);
    void gatherCounters(WavefrontStats& stats);
    [[nodiscard]] Film readFilm(std::uint32_t samplesDone);
    [[nodiscard]] std::size_t filmBytesPerPixel() const {
        return sizeof(FilmSums) + filmLayout.words() * sizeof(uvec4);
    }

    std::uint32_t pathsPerBatch = 0;
    std::vector<Stage> stamps;  ///< stage that ends at each timestamp slot of the current submission
    const StageObserver* observer = nullptr;
    double batchSeconds = 0;
};

WavefrontRenderer::Impl::Impl(const SceneArrays& arrays, const RenderOptions& renderOptions,
                              const WavefrontConfig& wavefrontConfig)
    : options(renderOptions),
      config(wavefrontConfig),
      device({config.device, config.validation}),
      layout(planScene(arrays, options.sampler)),
      filmLayout(options.aovs),
      capacity(config.pathsInFlight != 0 ? config.pathsInFlight : kDefaultPaths),
      texels(useTexels(device, config.fetch, layout.bytes)),
      stateTexel(useStateTexels(device, config.fetch, stateBytes(capacity))),
      ballot(config.ballot && device.info().subgroupBallot),
      kernels(device, config.kernels ? config.kernels : SpirvSource(kernelSpirv),
              specializationOf(arrays.features, layout.header,
                               {.sampler = options.sampler,
                                .lastIndex = std::max(options.params.spp, 1U) - 1,
                                .setSamples = setSamples(options),
                                .fetchTexel = texels,
                                .useBallot = ballot,
                                .stateTexel = stateTexel,
                                .film = filmLayout}),
              ballot, filmLayout.hasSurfaceLayer()),
      recorder(device, config.timings ? 4 * kBouncesPerSubmit + 5 : 0),
      pathsPerBatch(capacity) {
    if (counterBlocks() > kMaxBounceBlocks)
        throw Error(ExitCode::Usage,
                    fmt::format("--max-depth {}: at most {}", options.params.maxDepth, kMaxBounceBlocks - 2));
    const auto start = Clock::now();
    createBuffers(arrays);
    uploadSeconds = secondsSince(start);
}

void WavefrontRenderer::Impl::createBuffers(const SceneArrays& arrays) {
    const auto& limits = device.info().limits;
    const std::uint32_t width = options.params.width, height = options.params.height;
    const auto bandList = makeBands(width, height, limits.maxStorageBufferRange / filmBytesPerPixel());
    plan.add("scene", layout.bytes, !texels);
    plan.add("path state", stateBytes(capacity));
    plan.add("queues", counterBytes(capacity));
    for (const Band& band : bandList) plan.add("film", band.pixelCount * filmBytesPerPixel());
    plan.check(device.info());

    const std::size_t counterBytesUsed = std::size_t{kQueueBase} * 4;
    frame = Buffer(device, BufferUse::Uniform, sizeof(Frame), "frame");
    scene = Buffer(device, BufferUse::Storage, layout.bytes, "scene");
    dummy = Buffer(device, BufferUse::Storage, 16, "dummy");
    state = Buffer(device, BufferUse::Storage, stateBytes(capacity), "path state");
    counters = Buffer(device, BufferUse::Indirect, counterBytes(capacity), "queues");
    freshCounters = Buffer(device, BufferUse::Upload, counterBytesUsed, "fresh counters");
    readback = Buffer(device, BufferUse::Readback, counterBytesUsed, "counters read back");
    sceneTexels = texels ? TexelView(device, scene, VK_FORMAT_R32G32B32A32_UINT, 0, layout.bytes)
                         : TexelView(device, dummy, VK_FORMAT_R32G32B32A32_UINT, 0, 16);
    stateTexels = stateTexel ? TexelView(device, state, VK_FORMAT_R32G32B32A32_UINT, 0, stateBytes(capacity))
                             : TexelView(device, dummy, VK_FORMAT_R32G32B32A32_UINT, 0, 16);

    writeFrame();
    const std::vector<QueueCounter> fresh(counterBytesUsed / sizeof(QueueCounter) - 4);
    std::memset(freshCounters.map().data(), 0, counterBytesUsed);
    std::memcpy(freshCounters.map().data(), fresh.data(), fresh.size() * sizeof(QueueCounter));
    uploadScene(device, scene, arrays, layout);
    for (const Band& band : bandList) {
        FilmBand b{band, Buffer(device, BufferUse::Storage, band.pixelCount * filmBytesPerPixel(), "film"), {}};
        const std::array<Binding, 7> bindings = {
            frame, texels ? dummy : scene, sceneTexels, state, counters, b.film, stateTexels};
        b.group = BindGroup(device, kernels.generate, bindings);
        bands.push_back(std::move(b));
    }
}

void WavefrontRenderer::Impl::writeFrame() {
    const Frame contents{layout.header, options.params};
    std::memcpy(frame.map().data(), &contents, sizeof contents);
}

void WavefrontRenderer::Impl::clearFilm() {
    recorder.begin();
    for (const auto& b : bands) recorder.fill(b.film, 0, b.film.size(), 0);
    recorder.fill(counters, kRefusedCounter * 4, 8, 0);
    recorder.submitAndWait();
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
    recorder.copy(freshCounters, 0, counters, 0, queueCounterOffset(counterBlocks(), Queue::Ray));
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
        stage(kernels.intersect, Queue::Ray, Stage::Intersect);
        if (batch.bounce == 0 && kernels.layers) recordLayers(band, batch);
        stage(kernels.miss, Queue::Miss, Stage::Miss);
        stage(kernels.shade, Queue::Hit, Stage::Shade);
        if (batch.bounce < options.params.maxDepth) stage(kernels.shadow, Queue::Shadow, Stage::Shadow);
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
    recorder.copy(counters, 0, readback, 0, std::size_t{kQueueBase} * 4);
    recorder.submitAndWait();
    if (!config.timings) return;
    const std::vector<double> times = recorder.timestampsSeconds();
    for (std::size_t i = 0; i < stamps.size() && i + 1 < times.size(); ++i)
        stats.stages[static_cast<std::size_t>(stamps[i])].seconds += times[i + 1] - times[i];
}

void WavefrontRenderer::Impl::renderBatch(const FilmBand& band, BatchParams batch, WavefrontStats& stats) {
    const auto start = Clock::now();
    const std::uint32_t bounces = options.params.maxDepth + 1;
    batch.capacity = capacity;
    batch.pathCount = batch.pixelCount * batch.sampleCount;
    batch.filmFirst = band.band.firstPixel;
    batch.filmLayers = band.band.pixelCount * sizeof(FilmSums) / sizeof(uvec4);
    bool more = true;
    for (std::uint32_t begin = 0; more; begin += kBouncesPerSubmit) {
        const std::uint32_t end = std::min(begin + kBouncesPerSubmit, bounces);
        stamps.clear();
        recorder.begin();
        if (config.timings) recorder.timestamp(0);
        if (begin == 0) recordStart(band, batch);
        recordBounces(band, batch, begin, end);
        if (end == bounces) recordEnd(band, batch);
        submit(stats);
        more = end < bounces;
        QueueCounter left;
        std::memcpy(&left, readback.map().data() + queueCounterOffset(end, Queue::Ray), sizeof left);
        if (more && left.items == 0) {  // every path has ended: only the film is left
            stamps.clear();
            recorder.begin();
            if (config.timings) recorder.timestamp(0);
            recordEnd(band, batch);
            submit(stats);
            more = false;
        }
    }
    gatherCounters(stats);
    stats.paths += batch.pathCount;
    ++stats.batches;
    batchSeconds = secondsSince(start);
}

void WavefrontRenderer::Impl::gatherCounters(WavefrontStats& stats) {
    const auto* words = reinterpret_cast<const std::uint32_t*>(readback.map().data());
    for (std::uint32_t b = 0; b < counterBlocks() - 1; ++b) {
        const auto items = [&](Queue queue) { return words[queueCounterOffset(b, queue) / 4 + 3]; };
        stats.stages[static_cast<std::size_t>(Stage::Intersect)].items += items(Queue::Ray);
        stats.stages[static_cast<std::size_t>(Stage::Miss)].items += items(Queue::Miss);
        stats.stages[static_cast<std::size_t>(Stage::Shade)].items += items(Queue::Hit);
        stats.stages[static_cast<std::size_t>(Stage::Shadow)].items += items(Queue::Shadow);
    }
    stats.refused = words[kRefusedCounter];
    stats.refusedInLayers = words[kRefusedInLayersCounter];
}

void WavefrontRenderer::Impl::renderPass(std::uint32_t firstSample, std::uint32_t sampleCount,
                                         const RenderControl& control, std::uint64_t totalPaths,
                                         WavefrontStats& stats) {
    for (const FilmBand& band : bands) {
        std::uint32_t done = 0;
        while (done < band.band.pixelCount) {
            const std::uint32_t pixels =
                std::min(band.band.pixelCount - done, std::max(pathsPerBatch / sampleCount, 1U));
            renderBatch(band,
                        {.firstPixel = band.band.firstPixel + done,
                         .pixelCount = pixels,
                         .firstSample = firstSample,
                         .sampleCount = sampleCount},
                        stats);
            done += pixels;
            if (!device.info().isCpu && batchSeconds > kSubmitSeconds)
                pathsPerBatch = std::max(pathsPerBatch / 2, 4096U);
            if (control.progress) control.progress(stats.paths, totalPaths);
        }
    }
}

Film WavefrontRenderer::Impl::readFilm(std::uint32_t samplesDone) {
    Film film(options.params.width, options.params.height, options.aovs);
    film.ranges = {{options.sampleBegin, options.sampleBegin + samplesDone}};
    const std::size_t words = filmLayout.words();
    for (const FilmBand& b : bands) {
        const std::size_t first = b.band.firstPixel, count = b.band.pixelCount;
        downloadBuffer(device, b.film, 0, std::as_writable_bytes(std::span(film.sums).subspan(first, count)));
        if (words > 0)
            downloadBuffer(device, b.film, count * sizeof(FilmSums),
                           std::as_writable_bytes(std::span(film.layers).subspan(first * words, count * words)));
    }
    return film;
}

WavefrontRenderer::WavefrontRenderer(const SceneArrays& arrays, const RenderOptions& options,
                                     const WavefrontConfig& config)
    : impl_(std::make_unique<Impl>(arrays, options, config)) {}

WavefrontRenderer::~WavefrontRenderer() = default;

Film WavefrontRenderer::render(const RenderControl& control, WavefrontStats* statsOut) {
    Impl& r = *impl_;
    const auto start = Clock::now();
    WavefrontStats stats = zeroStats(r.kernels.layers.has_value());
    stats.device = r.device.info().name;
    stats.driver = r.device.info().driver;
    stats.fetch = r.texels ? "texel" : "storage";
    stats.uploadSeconds = r.uploadSeconds;
    stats.deviceBytes = r.plan.totalBytes();

    r.clearFilm();
    const std::uint64_t pixels = std::uint64_t{r.options.params.width} * r.options.params.height;
    const std::uint32_t samples = r.options.sampleEnd - r.options.sampleBegin;
    std::uint32_t done = 0;
    while (done < samples && !(done > 0 && control.shouldStop())) {
        const std::uint32_t count = samplesPerPass(pixels, r.pathsPerBatch, done, samples - done);
        r.renderPass(r.options.sampleBegin + done, count, control, pixels * samples, stats);
        if (done == 0) stats.secondsToFirstPass = secondsSince(start);
        done += count;
    }
    Film film = r.readFilm(done);
    film.refused = stats.refused;
    film.refusedInLayers = stats.refusedInLayers;
    stats.stages[0].items = stats.stages[5].items = stats.paths;
    if (r.kernels.layers) stats.stages.back().items = stats.paths;
    stats.pathRays = stats.stages[1].items;
    stats.shadowRays = stats.stages[4].items;
    stats.renderSeconds = secondsSince(start);
    stats.validationMessages = r.device.validationMessages();
    if (statsOut) *statsOut = stats;
    return film;
}

void WavefrontRenderer::select(std::uint32_t seed, std::uint32_t begin, std::uint32_t end) {
    impl_->options.params.seed = seed;
    impl_->options.sampleBegin = begin;
    impl_->options.sampleEnd = end;
    impl_->writeFrame();
}

std::vector<FilmSums> WavefrontRenderer::observe(std::uint32_t firstPixel, std::uint32_t pixelCount,
                                                 const StageObserver& observer) {
    Impl& r = *impl_;
    const std::uint32_t samples = r.options.sampleEnd - r.options.sampleBegin;
    const auto holdsAll = [&](const Impl::FilmBand& b) {
        return b.band.firstPixel <= firstPixel && firstPixel + pixelCount <= b.band.firstPixel + b.band.pixelCount;
    };
    const auto band = std::ranges::find_if(r.bands, holdsAll);
    if (band == r.bands.end() || std::uint64_t{pixelCount} * samples > r.capacity)
        throw Error(ExitCode::Usage,
                    fmt::format("{} samples of {} pixels are more than one batch", samples, pixelCount));
    r.clearFilm();
    WavefrontStats stats = zeroStats(r.kernels.layers.has_value());
    const Impl::Watch watch(r, observer);
    r.renderBatch(*band,
                  {.firstPixel = firstPixel,
                   .pixelCount = pixelCount,
                   .firstSample = r.options.sampleBegin,
                   .sampleCount = samples},
                  stats);
    return readStorage<FilmSums>(r.device, band->film, (firstPixel - band->band.firstPixel) * sizeof(FilmSums),
                                 pixelCount);
}

std::string WavefrontRenderer::memoryPlan() const { return impl_->plan.describe(); }

std::uint64_t WavefrontRenderer::validationMessages() const { return impl_->device.validationMessages(); }

}  // namespace vkpt
