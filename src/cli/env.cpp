// vkpt env: an environment map as a light: its importance, where samples fall, and what that gains.
#include <fmt/format.h>

#include <memory>

#include "analysis/environment_study.h"
#include "base/progress.h"
#include "cli/command.h"
#include "cli/options.h"
#include "cli/scene_setup.h"
#include "cli/study_output.h"
#include "plot/write.h"

namespace vkpt {
namespace {

constexpr std::uint32_t kMostSamples = 1U << 20U;

struct EnvCommand {
    std::string map;
    SamplerId sampler = SamplerId::Sobol;
    std::optional<ScrambleId> scramble;
    EnvironmentStudyRequest request;
    std::filesystem::path output;
    bool json = false;
};

/// With a progress bar, which stands at 0 while the map is read and its tables are built.
Study studyMap(EnvironmentStudyRequest& request, const EnvironmentChoice& choice) {
    ProgressBar bar(true, "texels");
    bar.update(0, 1);
    request.map = makeEnvironment(choice);
    request.progress = [&](std::uint64_t done, std::uint64_t total) {
        if (done == 0) bar.restart();
        bar.update(done, total);
    };
    return studyEnvironment(request);
}

ExitCode runEnv(EnvCommand& c) {
    const auto choice = parseEnvironment(c.map);
    if (!choice || choice->kind == EnvironmentChoice::Kind::None)
        throw usageError("FILE", fmt::format("'{}' is no map, no colour R,G,B and not studio", c.map));
    checkPicture(c.output);
    c.request.sampler = chooseSampler(c.sampler, c.scramble);
    c.request.count = roundedCount("--count", c.sampler, c.request.count);
    c.request.name = environmentName(*choice);
    c.request.picture = !c.output.empty();
    showStudy(studyMap(c.request, *choice), c.output, c.json);
    return ExitCode::Ok;
}

std::function<ExitCode()> setUpEnv(CLI::App& app) {
    const auto c = std::make_shared<EnvCommand>();
    app.add_option("FILE", c->map, "equirectangular .hdr, .exr, .pfm or .png; or studio, or R,G,B")->required();
    addParsed(app, "--count", c->request.count, numberWithin(1U, kMostSamples), "N", "samples drawn (default: 256)",
              fmt::format("1 to {}", kMostSamples));
    addParsed(app, "--sampler", c->sampler, nameIn(kSamplers), namesOf(kSamplers), "of the samples (default: sobol)");
    addParsed(app, "--scramble", c->scramble, nameIn(kScrambles), namesOf(kScrambles), "as of render");
    addParsed(app, "--seed", c->request.seed, numberWithin(0U), "N", "other samples (default: 0)", kWhole);
    app.add_option("-o,--output", c->output, fmt::format("picture to write: {}", kDrawingExtensions))
        ->type_name("FILE");
    app.add_flag("--json", c->json, "as JSON, with the samples and the marginal");
    return [c] { return runEnv(*c); };
}

}  // namespace

const Command kEnvCommand{"env", "an environment map: importance, where samples fall, variance",
                          "vkpt env royal_esplanade_1k.hdr --count 256 -o env.png", setUpEnv};

}  // namespace vkpt
