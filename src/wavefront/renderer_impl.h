// What a WavefrontRenderer owns. Its parts: renderer_setup.cpp makes it, record_batch.cpp runs one batch of paths,
// renderer.cpp renders with it.
#pragma once
#include <chrono>

#include "gpu/device.h"
#include "gpu/memory_plan.h"
#include "gpu/recorder.h"
#include "wavefront/batches.h"
#include "wavefront/kernels.h"
#include "wavefront/renderer.h"
#include "wavefront/scene_upload.h"

namespace vkpt {

inline constexpr std::uint32_t kBouncesPerSubmit = 16;

[[nodiscard]] inline double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

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
    SceneFeatures features;
    KernelOptions kernelOptions;
    WavefrontKernels kernels;
    std::optional<WavefrontKernels> apart;  ///< the same with a stage for shadow rays, once an observer asked for it
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
    [[nodiscard]] std::size_t usedCounterBytes() const { return queueCounterOffset(counterBlocks(), Queue::Ray); }

    void recordStart(const FilmBand& band, const BatchParams& batch);
    void recordBounces(const FilmBand& band, BatchParams batch, std::uint32_t begin, std::uint32_t end);
    void recordLayers(const FilmBand& band, const BatchParams& batch);
    void recordEnd(const FilmBand& band, const BatchParams& batch);
    [[nodiscard]] KernelOptions chooseKernels(const SceneArrays& arrays) const;
    [[nodiscard]] WavefrontKernels makeKernels(const KernelOptions& o);
    [[nodiscard]] const WavefrontKernels& active() const { return observer != nullptr && apart ? *apart : kernels; }
    [[nodiscard]] bool meetsBeyond(std::uint32_t bounce) const;
    void finish(Stage stage, const BatchParams& batch);
    void show(Stage stage, const BatchParams& batch);
    void submit(WavefrontStats& stats);
    void renderBatch(const FilmBand& band, BatchParams batch, WavefrontStats& stats);
    void renderRound(const FilmBand& band, const BatchParams& batch, bool last, WavefrontStats& stats);
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

}  // namespace vkpt
