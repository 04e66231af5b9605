// vkpt samples: point sets, and what is to be known of them.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "analysis/studies.h"
#include "cli/command.h"
#include "cli/options.h"
#include "cli/study_output.h"
#include "plot/write.h"

namespace vkpt {
namespace {

constexpr std::string_view kPoissonDisk = "poissondisk";
constexpr std::uint32_t kMostPoints = 1U << 20U, kMostPairs = 1U << 14U;  ///< the latter where all pairs are visited

enum class Mode { Points, Projections, Discrepancy, Spectrum, Convergence, RadicalInverse };

using Dimensions = std::vector<std::uint32_t>;

struct SamplesCommand {
    std::string samplers = "sobol";
    std::optional<ScrambleId> scramble;
    std::optional<std::uint32_t> count;
    std::optional<Dimensions> dimensions;
    StudyRequest request;
    Mode mode = Mode::Points;
    std::uint32_t base = 2;
    std::filesystem::path output;
    bool json = false;
};

std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == ',')
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

std::optional<Dimensions> parseDimensions(std::string_view text) {
    Dimensions dimensions;
    for (const std::string& part : split(std::string(text))) {
        const auto dim = parseNumber<std::uint32_t>(part);
        if (!dim) return std::nullopt;
        dimensions.push_back(*dim);
    }
    return dimensions;
}

/// "halton", or "halton/faure" where a scramble was asked for.
StudiedSampler studied(const std::string& name, std::optional<ScrambleId> scramble) {
    if (name == kPoissonDisk) return {name, std::nullopt};
    const auto id = nameIn(kSamplers)(name);
    if (!id)
        throw usageError("--sampler",
                         fmt::format("'{}' is not one of {}|{}|all", name, namesOf(kSamplers), kPoissonDisk));
    if (!scramble || samplerInfo(*id).scrambleCount == 0) return {name, SamplerChoice(*id)};
    return {fmt::format("{}/{}", name, scrambleName(*scramble)), chooseSampler(*id, scramble)};
}

/// `plane`: two dimensions are asked for, all that Poisson disks have.
std::vector<StudiedSampler> studiedSamplers(const SamplesCommand& c, bool plane) {
    std::vector<StudiedSampler> samplers;
    if (c.samplers == "all") {
        for (const SamplerInfo& info : kSamplers) samplers.push_back({std::string(info.name), SamplerChoice(info.id)});
        if (plane) samplers.push_back({std::string(kPoissonDisk), std::nullopt});
        return samplers;
    }
    const auto names = split(c.samplers);
    if (names.size() == 1) {  // one sampler: a scramble that it has not is an error
        if (const auto id = nameIn(kSamplers)(names[0])) (void)chooseSampler(*id, c.scramble);
    }
    for (const std::string& name : names) samplers.push_back(studied(name, c.scramble));
    return samplers;
}

void check(const SamplesCommand& c, const StudyRequest& request) {
    checkPicture(c.output);
    const bool pairs = c.mode == Mode::Discrepancy;
    if (request.count > (pairs ? kMostPairs : kMostPoints))
        throw usageError("--count", fmt::format("at most {}", pairs ? kMostPairs : kMostPoints));
    const bool plane = c.mode == Mode::Projections || c.mode == Mode::Spectrum || !c.output.empty();
    if (plane && request.dimensions.size() < 2) throw usageError("--dims", "two or more are needed");
    if (c.mode == Mode::Discrepancy && !c.output.empty() && request.dimensions.size() != 2)
        throw usageError("--output", "the picture of --discrepancy is of two dimensions: see --dims");
    for (const StudiedSampler& sampler : request.samplers) {
        if (!sampler.choice && request.dimensions.size() != 2 && c.mode != Mode::Convergence)
            throw usageError("--sampler", fmt::format("'{}' has two dimensions only", sampler.name));
        if (sampler.choice) (void)roundedCount("--count", sampler.choice->id, request.count);
    }
}

std::uint32_t defaultCount(Mode mode) {
    switch (mode) {
        case Mode::RadicalInverse:
            return 16;
        case Mode::Spectrum:
        case Mode::Convergence:
            return 1024;
        default:
            return 64;
    }
}

Study makeStudy(const SamplesCommand& c, const StudyRequest& request) {
    switch (c.mode) {
        case Mode::Projections:
            return studyProjections(request);
        case Mode::Discrepancy:
            return studyDiscrepancy(request);
        case Mode::Spectrum:
            return studySpectrum(request);
        case Mode::Convergence:
            return studyConvergence(request);
        case Mode::RadicalInverse:
            return studyRadicalInverse(c.base, request.count);
        default:
            return studyPoints(request);
    }
}

ExitCode runSamples(const SamplesCommand& c) {
    StudyRequest request = c.request;
    request.count = c.count.value_or(defaultCount(c.mode));
    const bool pairs = c.mode == Mode::Projections;
    request.dimensions = c.dimensions.value_or(pairs ? Dimensions{0, 1, 2, 3, 4, 5} : Dimensions{0, 1});
    if (c.mode != Mode::RadicalInverse) request.samplers = studiedSamplers(c, request.dimensions.size() == 2);
    check(c, request);
    const Study study = makeStudy(c, request);
    showStudy(study, c.output, c.json);
    return ExitCode::Ok;
}

std::function<ExitCode()> setUpSamples(CLI::App& app) {
    const auto c = std::make_shared<SamplesCommand>();
    app.add_option("--sampler", c->samplers,
                   fmt::format("of: {}|{}; or all (default: sobol)", namesOf(kSamplers), kPoissonDisk))
        ->type_name("NAME[,NAME...]");
    addParsed(app, "--scramble", c->scramble, nameIn(kScrambles), namesOf(kScrambles),
              "of those that have it; the others are as they are");
    addParsed(app, "--count", c->count, numberWithin(1U), "N", "points, rows of the table, or the most samples",
              kCount);
    addParsed(app, "--dims", c->dimensions, parseDimensions, "I,J[,...]",
              "dimensions (default: 0,1; of --projections 0 to 5)");
    addParsed(app, "--seed", c->request.seed, numberWithin(0U), "N", "another seed, other points (default: 0)", kWhole);
    app.add_flag("--grid", c->request.grid, "draw the strata");
    std::vector<CLI::Option*> modes;
    const auto mode = [&](const char* name, Mode value, const char* help) {
        modes.push_back(app.add_flag_callback(
            name, [c, value] { c->mode = value; }, help));
    };
    mode("--projections", Mode::Projections, "every pair of --dims, in a triangle");
    mode("--discrepancy", Mode::Discrepancy, "star, L2-star, centred and wrap-around L2 discrepancy");
    mode("--spectrum", Mode::Spectrum, "power spectrum and its radial mean");
    mode("--convergence", Mode::Convergence, "variance against samples on test integrands, with slopes");
    modes.push_back(addParsed(
        app, "--radical-inverse", c->base,
        [c](std::string_view text) {
            c->mode = Mode::RadicalInverse;
            return numberWithin(2U, 36U)(text);
        },
        "B", "table of n, its digits and its radical inverse in base B", "a base from 2 to 36"));
    for (std::size_t i = 0; i < modes.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) modes[i]->excludes(modes[k]);
    app.add_option("-o,--output", c->output, fmt::format("picture to write: {}", kDrawingExtensions))
        ->type_name("FILE");
    app.add_flag("--json", c->json, "as JSON");
    return [c] { return runSamples(*c); };
}

}  // namespace

const Command kSamplesCommand{
    "samples", "point sets of samplers: points, projections, discrepancy, spectra, convergence",
    "vkpt samples --sampler random,jittered,cmj --count 64 --grid -o points.svg", setUpSamples};

}  // namespace vkpt
