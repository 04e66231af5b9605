#include "cli/backend.h"

#include "reference/render.h"
#include "wavefront/renderer.h"

namespace vkpt {
namespace {

class VulkanRenderer final : public SceneRenderer {
public:
    VulkanRenderer(const SceneArrays& arrays, const RenderOptions& options, const WavefrontConfig& config)
        : renderer_(arrays, options, config) {}

    Film render(const RenderControl& control, RenderReport& report) override {
        WavefrontStats stats;
        Film film = renderer_.render(control, &stats);
        report = {.backend = "vulkan",
                  .device = stats.device,
                  .driver = stats.driver,
                  .fetch = stats.fetch,
                  .paths = stats.paths,
                  .pathRays = stats.pathRays,
                  .shadowRays = stats.shadowRays,
                  .deviceBytes = stats.deviceBytes,
                  .validationMessages = stats.validationMessages,
                  .uploadSeconds = stats.uploadSeconds,
                  .renderSeconds = stats.renderSeconds,
                  .stages = stats.stages};
        return film;
    }
    std::string memoryPlan() const override { return renderer_.memoryPlan(); }

private:
    WavefrontRenderer renderer_;
};

class CpuRenderer final : public SceneRenderer {
public:
    CpuRenderer(const SceneArrays& arrays, const RenderOptions& options, unsigned threads)
        : arrays_(arrays), options_(options), threads_(threads) {}

    Film render(const RenderControl& control, RenderReport& report) override {
        ReferenceStats stats;
        Film film = renderReference(arrays_, options_, control, ReferenceConfig{threads_}, &stats);
        report = {};
        report.backend = "cpu";
        report.device = "CPU reference";
        report.paths = stats.paths;
        report.pathRays = stats.pathRays;
        report.shadowRays = stats.shadowRays;
        report.renderSeconds = stats.seconds;
        return film;
    }
    std::string memoryPlan() const override { return {}; }

private:
    const SceneArrays& arrays_;
    const RenderOptions& options_;
    unsigned threads_;
};

double perSecond(std::uint64_t count, double seconds) {
    return seconds > 0 ? static_cast<double>(count) / seconds * 1e-6 : 0;
}

}  // namespace

Json reportJson(const RenderReport& report) {
    const std::uint64_t rays = report.pathRays + report.shadowRays;
    Json json{{"backend", report.backend},
              {"device", report.device},
              {"driver", report.driver},
              {"fetch", report.fetch},
              {"deviceBytes", report.deviceBytes},
              {"validationMessages", report.validationMessages},
              {"uploadSeconds", report.uploadSeconds},
              {"renderSeconds", report.renderSeconds},
              {"paths", report.paths},
              {"pathRays", report.pathRays},
              {"shadowRays", report.shadowRays},
              {"millionPathsPerSecond", perSecond(report.paths, report.renderSeconds)},
              {"millionRaysPerSecond", perSecond(rays, report.renderSeconds)},
              {"stages", Json::array()}};
    for (const StageStats& stage : report.stages)
        json["stages"].push_back({{"name", stage.name},
                                  {"seconds", stage.seconds},
                                  {"items", stage.items},
                                  {"millionItemsPerSecond", perSecond(stage.items, stage.seconds)}});
    return json;
}

std::unique_ptr<SceneRenderer> makeRenderer(const SceneArrays& arrays, const RenderOptions& options,
                                            const BackendOptions& backend, bool timings) {
    if (backend.backend == Backend::Cpu) return std::make_unique<CpuRenderer>(arrays, options, backend.threads);
    WavefrontConfig config;
    config.device = backend.device;
    config.validation = backend.validate;
    config.fetch = backend.fetch;
    config.timings = timings;
    return std::make_unique<VulkanRenderer>(arrays, options, config);
}

}  // namespace vkpt
