// vkpt bench: how fast, a stage at a time.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <ctime>
#include <iostream>
#include <memory>

#include "base/interrupt.h"
#include "base/version.h"
#include "cli/backend.h"
#include "cli/clock.h"
#include "cli/command.h"
#include "cli/metadata.h"
#include "cli/scene_setup.h"
#include "cli/thread_limit.h"

namespace vkpt {
namespace {

struct BenchCommand {
    SceneOptions scene;
    SamplingOptions sampling;
    BackendOptions backend;
    std::vector<Backend> backends{Backend::Vulkan, Backend::Cpu};
    unsigned repeat = 3;
    bool json = false;
    Verbosity verbosity = Verbosity::Normal;
};

/// scenes/cornell_box beside the program: in the source tree it was built in, or installed.
std::filesystem::path defaultScene() {
    std::error_code error;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
    for (std::filesystem::path folder = program.parent_path(); folder.has_relative_path();
         folder = folder.parent_path())
        for (const char* place : {"scenes", "share/vkpt/scenes"})
            if (const auto file = folder / place / "cornell_box" / "scene.gltf"; std::filesystem::exists(file, error))
                return file;
    throw Error(ExitCode::Usage, "SCENE is required: scenes/cornell_box is not beside this program");
}

/// CPU time of all threads of this process so far, in seconds.
double cpuSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// One backend: `repeat` runs without timestamps for the rate, of which the best counts; then one with them.
Json benchBackend(const BenchCommand& c, const PreparedScene& prepared, Backend backend) {
    BackendOptions options = c.backend;
    options.backend = backend;
    const double prepareSeconds = prepared.seconds.at("total").get<double>(), begin = secondsSinceStart();
    double firstPass = 0;
    RenderControl control;
    control.stop = &catchInterrupt();
    control.progress = [&](std::uint64_t done, std::uint64_t) {
        if (firstPass == 0 && done > 0) firstPass = prepareSeconds + secondsSinceStart() - begin;
    };
    Json runs = Json::array(), cpuRuns = Json::array();
    RenderReport best;
    const SampleRange range{prepared.options.sampleBegin, prepared.options.sampleEnd};
    const auto renderer = makeRenderer(prepared.arrays, prepared.options, options, false);
    for (unsigned i = 0; i < c.repeat && !control.shouldStop(); ++i) {
        RenderReport report;
        const double cpuBegin = cpuSeconds();
        (void)renderer->render(range, control, report);
        cpuRuns.push_back(cpuSeconds() - cpuBegin);
        runs.push_back(report.renderSeconds);
        if (i == 0 || report.renderSeconds < best.renderSeconds) best = report;
    }
    if (backend == Backend::Vulkan && !control.shouldStop()) {
        RenderReport timed;
        (void)makeRenderer(prepared.arrays, prepared.options, options, true)->render(range, control, timed);
        best.stages = timed.stages;
    }
    if (control.shouldStop()) throw Error(ExitCode::Interrupted, "interrupted: no figures");
    Json result = reportJson(best);
    result["runSeconds"] = runs;
    result["runCpuSeconds"] = cpuRuns;  // less disturbed by other processes, of which a busy machine has some
    result["secondsToFirstPass"] = firstPass;
    return result;
}

void printResult(const Json& r) {
    std::cout << fmt::format("{} on {}\n", r["backend"].get<std::string>(), r["device"].get<std::string>());
    std::cout << fmt::format("  {:.3f} M paths/s, {:.2f} M rays/s; best of {}: {:.3f} s; first pixel after {:.2f} s\n",
                             r["millionPathsPerSecond"].get<double>(), r["millionRaysPerSecond"].get<double>(),
                             r["runSeconds"].size(), r["renderSeconds"].get<double>(),
                             r["secondsToFirstPass"].get<double>());
    for (const Json& stage : r["stages"])
        std::cout << fmt::format("  {:<16} {:9.3f} s {:14} items {:9.2f} M/s\n", stage["name"].get<std::string>(),
                                 stage["seconds"].get<double>(), stage["items"].get<std::uint64_t>(),
                                 stage["millionItemsPerSecond"].get<double>());
}

ExitCode runBench(BenchCommand& c) {
    setUpLog(c.verbosity);
    if (c.scene.file.empty()) c.scene.file = defaultScene();
    const ThreadLimit limit(c.backend.threads);
    const PreparedScene prepared = prepareScene(c.scene, c.sampling);
    Json report{{"version", kVersion},
                {"scene", prepared.file.string()},
                {"settings", renderSettings(prepared)},
                {"triangles", prepared.arrays.triangles.size()},
                {"seconds", prepared.seconds},
                {"results", Json::array()}};
    for (const Backend backend : c.backends) {
        report["results"].push_back(benchBackend(c, prepared, backend));
        if (!c.json) printResult(report["results"].back());
    }
    if (c.json) std::cout << jsonText(report);
    return ExitCode::Ok;
}

std::optional<std::vector<Backend>> parseBackends(std::string_view text) {
    if (text == "both") return std::vector{Backend::Vulkan, Backend::Cpu};
    if (text == "vulkan") return std::vector{Backend::Vulkan};
    if (text == "cpu") return std::vector{Backend::Cpu};
    return std::nullopt;
}

std::function<ExitCode()> setUpBench(CLI::App& app) {
    const auto command = std::make_shared<BenchCommand>();
    command->sampling.spp = 16;
    addSceneFile(app, command->scene, false);
    addSceneOptions(app, command->scene);
    addSamplingOptions(app, command->sampling);
    addAovs(app, command->sampling);
    addParsed(app, "--backend", command->backends, parseBackends, "vulkan|cpu|both", "which to time (default: both)");
    addDeviceOptions(app, command->backend);
    addParsed(app, "--repeat", command->repeat, numberWithin(1U), "N",
              "runs of each, of which the fastest counts (default: 3)", kCount);
    app.add_flag("--json", command->json, "as JSON");
    addVerbosity(app, command->verbosity);
    return [command] { return runBench(*command); };
}

}  // namespace

const Command kBenchCommand{"bench", "million paths and rays a second, a stage at a time",
                            "vkpt bench DamagedHelmet.glb --env royal_esplanade_1k.hdr --size 512x512 --json",
                            setUpBench};

}  // namespace vkpt
