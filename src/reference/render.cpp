#include "reference/render.h"

#include <tbb/blocked_range2d.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <span>

#include "base/error.h"
#include "reference/accumulate.h"
#include "reference/layers.h"
#include "reference/path.h"

namespace vkpt {

namespace {

using reference::addSums;
using reference::LayerTally;
using reference::PathTally;
using reference::PathTracer;

constexpr std::uint32_t kTile = 16;
/// Of a pass, after which a stop is heard: some tenths of a second. A frame of more pixels has one sample a pass.
constexpr std::uint64_t kPathsPerPass = 1U << 18U;

void check(const RenderOptions& options) {
    const RenderParams& params = options.params;
    if (params.width == 0 || params.height == 0 || params.width > 65536 || params.height > 65536) {
        throw Error(ExitCode::Usage, "the frame must have 1 to 65536 pixels a side");
    }
    if (options.sampleBegin >= options.sampleEnd) throw Error(ExitCode::Usage, "the range of samples is empty");
}

struct Counts {
    std::uint64_t refused = 0, refusedInLayers = 0, pathRays = 0, shadowRays = 0;

    void add(const PathTally& tally) {
        refused += tally.refused;
        pathRays += tally.pathRays;
        shadowRays += tally.shadowRays;
    }
};

void renderPixel(const PathTracer& tracer, std::uint32_t x, std::uint32_t y, const SampleRange& samples,
                 FilmSums& pixel, Counts& counts) {
    PathTally tally;
    tally.sums = pixel;
    for (std::uint32_t index = samples.begin; index < samples.end; ++index) tracer.trace(x, y, index, tally);
    pixel = tally.sums;
    counts.add(tally);
}

/// The same with layers, which look at each path alone.
void renderPixel(const PathTracer& tracer, std::uint32_t x, std::uint32_t y, const SampleRange& samples,
                 FilmSums& pixel, LayerTally& layers, Counts& counts) {
    for (std::uint32_t index = samples.begin; index < samples.end; ++index) {
        PathTally path;
        path.layers = &layers;
        tracer.trace(x, y, index, path);
        layers.addPath(path.sums);
        addSums(pixel, path.sums);
        counts.add(path);
    }
    counts.refusedInLayers += layers.refused();
}

/// Adds `samples` of every pixel to the film.
void renderPass(const SceneArrays& scene, const RenderOptions& options, const PathTracer& tracer,
                const SampleRange& samples, Film& film, tbb::combinable<Counts>& counts) {
    const tbb::blocked_range2d<std::uint32_t> pixels(0, film.height, kTile, 0, film.width, kTile);
    tbb::parallel_for(pixels, [&](const tbb::blocked_range2d<std::uint32_t>& tile) {
        Counts& mine = counts.local();
        for (std::uint32_t y = tile.rows().begin(); y < tile.rows().end(); ++y) {
            for (std::uint32_t x = tile.cols().begin(); x < tile.cols().end(); ++x) {
                const std::size_t pixel = std::size_t{y} * film.width + x, words = film.layout.words();
                if (words == 0) {
                    renderPixel(tracer, x, y, samples, film.sums[pixel], mine);
                } else {
                    LayerTally layers(scene, options.params, film.layout,
                                      std::span(film.layers).subspan(pixel * words, words));
                    renderPixel(tracer, x, y, samples, film.sums[pixel], layers, mine);
                }
            }
        }
    });
}

}  // namespace

Film renderReference(const SceneArrays& scene, const RenderOptions& options, const RenderControl& control,
                     const ReferenceConfig& config, ReferenceStats* stats) {
    check(options);
    const RenderParams& params = options.params;
    Film film(params.width, params.height, options.aovs, options.light);
    const std::uint64_t pixels = std::uint64_t{params.width} * params.height;
    const std::uint64_t total = pixels * (options.sampleEnd - options.sampleBegin);
    const auto perPass = static_cast<std::uint32_t>(std::max<std::uint64_t>(1, kPathsPerPass / pixels));

    const auto started = std::chrono::steady_clock::now();
    const PathTracer tracer(scene, options);
    tbb::combinable<Counts> counts;
    tbb::task_arena arena(config.threads == 0 ? tbb::task_arena::automatic : static_cast<int>(config.threads));
    std::uint32_t passes = 0, done = options.sampleBegin;
    do {
        const SampleRange pass{done, done + std::min(perPass, options.sampleEnd - done)};
        arena.execute([&] { renderPass(scene, options, tracer, pass, film, counts); });
        done = pass.end;
        ++passes;
        film.ranges = {{options.sampleBegin, done}};
        if (control.progress) control.progress(pixels * film.samples(), total);
    } while (done < options.sampleEnd && !control.shouldStop());

    Counts sum;
    counts.combine_each([&sum](const Counts& c) {
        sum.refused += c.refused;
        sum.refusedInLayers += c.refusedInLayers;
        sum.pathRays += c.pathRays;
        sum.shadowRays += c.shadowRays;
    });
    film.refused = sum.refused;
    film.refusedInLayers = sum.refusedInLayers;
    if (stats) {
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - started;
        *stats = {pixels * film.samples(), sum.pathRays, sum.shadowRays, passes, seconds.count()};
    }
    return film;
}

}  // namespace vkpt
