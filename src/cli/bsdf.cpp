// vkpt bsdf: what a BSDF reflects, how well it is sampled, and how it looks.
#include <fmt/format.h>

#include <memory>
#include <stdexcept>

#include "analysis/bsdf_study.h"
#include "cli/command.h"
#include "cli/options.h"
#include "cli/study_output.h"
#include "plot/write.h"

namespace vkpt {
namespace {

constexpr std::uint32_t kFewestDraws = 1000, kMostDraws = 10'000'000;

struct BsdfCommand {
    std::string spec, other;
    BsdfStudyRequest request;
    std::filesystem::path output;
    bool json = false;
};

void addSpec(BsdfStudyRequest& request, const std::string& option, const std::string& text) {
    try {
        request.specs.push_back(parseBsdfSpec(text));
        request.names.push_back(text);
    } catch (const std::invalid_argument& fault) {
        throw usageError(option, fmt::format("'{}': {}", text, fault.what()));
    }
}

ExitCode runBsdf(const BsdfCommand& c) {
    BsdfStudyRequest request = c.request;
    addSpec(request, "SPEC", c.spec);
    if (!c.other.empty()) addSpec(request, "--compare", c.other);
    checkPicture(c.output);
    request.picture = !c.output.empty();
    const Study study = studyBsdf(request);
    showStudy(study, c.output, c.json);
    return ExitCode::Ok;
}

std::function<ExitCode()> setUpBsdf(CLI::App& app) {
    const auto c = std::make_shared<BsdfCommand>();
    app.add_option("SPEC", c->spec, "model[:key=value,...], JSON, or @FILE; the keys of VKPT_materials_bsdf")
        ->required();
    app.add_option("--compare", c->other, "another, in the same table and plots")->type_name("SPEC");
    addParsed(app, "--multiscatter", c->request.multiscatter, parseSwitch, "on|off",
              "of the picture: interreflection between facets; the table has both (default: on)");
    addParsed(app, "--draws", c->request.draws, numberWithin(kFewestDraws, kMostDraws), "N",
              "directions drawn an angle (default: 20000)", fmt::format("{} to {}", kFewestDraws, kMostDraws));
    addParsed(app, "--seed", c->request.seed, numberWithin(0U), "N", "other draws (default: 0)", kWhole);
    app.add_option("-o,--output", c->output, fmt::format("picture to write: {}", kDrawingExtensions))
        ->type_name("FILE");
    const auto json = app.add_flag("--json", c->json, "as JSON");
    app.add_flag("--facets", c->request.facets, "in the JSON D, G1 and G2 of the microfacets, a degree at a time")
        ->needs(json);
    app.footer(app.get_footer() + "\n\nModels and their keys:\n" + bsdfHelp());
    return [c] { return runBsdf(*c); };
}

}  // namespace

const Command kBsdfCommand{"bsdf", "a BSDF: albedo, energy, reciprocity, sampling, lobes, a sphere",
                           "vkpt bsdf conductor:metal=Au,alpha=0.2 -o gold.png", setUpBsdf};

}  // namespace vkpt
