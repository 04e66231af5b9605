#include "cli/backend.h"

#include "reference/render.h"
#include "wavefront/renderer.h"

namespace vkpt {
namespace {

class VulkanRenderer final : public SceneRenderer {
public:
    VulkanRenderer(const SceneArrays& arrays, const RenderOptions& options, const WavefrontConfig& config)
        : renderer_(arrays, options, config), seed_(options.params.seed) {}

    Film render(const SampleRange& range, const RenderControl& control, RenderReport& report) override {
        renderer_.select(seed_, range.begin, range.end);
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
    std::uint32_t seed_;
};

class CpuRenderer final : public SceneRenderer {
public:
    CpuRenderer(const SceneArrays& arrays, const RenderOptions& options, unsigned threads)
        : arrays_(arrays), options_(options), threads_(threads) {}

    Film render(const SampleRange& range, const RenderControl& control, RenderReport& report) override {
        options_.sampleBegin = range.begin;
        options_.sampleEnd = range.end;
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
    RenderOptions options_;
    unsigned threads_;
};

double perSecond(std::uint64_t count, double seconds) {
    return seconds > 0 ? static_cast<double>(count) / seconds * 1e-6 : 0;
}

}  // namespace

void addReport(RenderReport& into, const RenderReport& later) {
    if (into.backend.empty()) {
        into = later;
        return;
    }
    into.paths += later.paths;
    into.pathRays += later.pathRays;
    into.shadowRays += later.shadowRays;
    into.renderSeconds += later.renderSeconds;
    into.validationMessages = later.validationMessages;  // the device counts them from its beginning
    for (std::size_t i = 0; i < into.stages.size(); ++i) {
        into.stages[i].seconds += later.stages[i].seconds;
        into.stages[i].items += later.stages[i].items;
    }
}

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
