#include "wavefront/renderer.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "gpu/transfer.h"
#include "wavefront/renderer_impl.h"

namespace vkpt {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kSubmitSeconds = 0.15;  ///< aim on real GPUs, whose watchdogs end long submissions

/// With every stage, in the order of Stage.
WavefrontStats zeroStats() {
    WavefrontStats stats;
    for (const char* name : kStageNames) stats.stages.push_back({name, 0, 0});
    return stats;
}

/// Takes out the stages that have no kernel.
void dropAbsent(WavefrontStats& stats, const WavefrontKernels& kernels) {
    if (!kernels.layers) stats.stages.pop_back();
    if (!kernels.shadow) stats.stages.erase(stats.stages.begin() + static_cast<std::ptrdiff_t>(Stage::Shadow));
    for (std::size_t group = kernels.shade.size(); group-- > 0;)
        if (!kernels.shade[group])
            stats.stages.erase(stats.stages.begin() + static_cast<std::ptrdiff_t>(kShadeStages[group]));
}

}  // namespace

void WavefrontRenderer::Impl::clearFilm() {
    recorder.begin();
    for (const auto& b : bands) recorder.fill(b.film, 0, b.film.size(), 0);
    recorder.fill(counters, kRefusedCounter * 4, 8, 0);
    recorder.submitAndWait();
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
    Film film(options.params.width, options.params.height, options.aovs, options.light);
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
    WavefrontStats stats = zeroStats();
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
    const auto items = [&](Stage stage) -> std::uint64_t& {
        return stats.stages[static_cast<std::size_t>(stage)].items;
    };
    items(Stage::Accumulate) = items(Stage::Layers) = stats.paths;
    stats.pathRays = items(Stage::Intersect);
    stats.shadowRays = items(Stage::Shadow);
    dropAbsent(stats, r.kernels);
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

ObservedFilm WavefrontRenderer::observe(std::uint32_t firstPixel, std::uint32_t pixelCount,
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
    WavefrontStats stats = zeroStats();
    if (r.kernelOptions.inlineShadows && !r.apart) {
        KernelOptions apart = r.kernelOptions;
        apart.inlineShadows = false;
        r.apart.emplace(r.makeKernels(apart));
    }
    const Impl::Watch watch(r, observer);
    r.renderBatch(*band,
                  {.firstPixel = firstPixel,
                   .pixelCount = pixelCount,
                   .firstSample = r.options.sampleBegin,
                   .sampleCount = samples},
                  stats);
    const std::size_t first = firstPixel - band->band.firstPixel, words = r.filmLayout.words();
    ObservedFilm film;
    film.sums = readStorage<FilmSums>(r.device, band->film, first * sizeof(FilmSums), pixelCount);
    if (words > 0)
        film.layers = readStorage<uvec4>(r.device, band->film,
                                         band->band.pixelCount * sizeof(FilmSums) + first * words * sizeof(uvec4),
                                         pixelCount * words);
    return film;
}

std::string WavefrontRenderer::memoryPlan() const { return impl_->plan.describe(); }

std::uint64_t WavefrontRenderer::validationMessages() const { return impl_->device.validationMessages(); }

}  // namespace vkpt
