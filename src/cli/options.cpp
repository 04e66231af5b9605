#include "cli/options.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>

#include "cli/command.h"
#include "scene/light_layers.h"
#include "scene/pixel_filter.h"

namespace vkpt {
namespace {

constexpr auto kBackends = std::to_array<Named<Backend>>({{Backend::Vulkan, "vulkan"}, {Backend::Cpu, "cpu"}});
constexpr auto kFetches = std::to_array<Named<WavefrontConfig::Fetch>>({{WavefrontConfig::Fetch::Auto, "auto"},
                                                                        {WavefrontConfig::Fetch::Texel, "texel"},
                                                                        {WavefrontConfig::Fetch::Storage, "storage"}});

void addCameraOptions(CLI::App& app, SceneOptions& options) {
    const char* group = "Camera";
    auto* camera = app.add_option("--camera", options.camera, "camera of the file, by name or index")
                       ->type_name("NAME|INDEX")
                       ->group(group);
    auto* eye = addParsed(app, "--eye", options.eye, parseVec3, "X,Y,Z", "where the camera stands")->group(group);
    auto* orbit = addParsed(app, "--orbit", options.orbit, parseOrbit, "THETA,PHI,RADIUS",
                            "camera on a sphere about the target: degrees around, degrees from +y, metres")
                      ->group(group);
    auto* target = addParsed(app, "--target", options.target, parseVec3, "X,Y,Z",
                             "what it looks at (default: the middle of the scene)")
                       ->group(group);
    addParsed(app, "--fov", options.fov, numberWithin(0.01F, 179.0F), "DEG", "vertical field of view in degrees",
              "an angle from 0.01 to 179 degrees")
        ->group(group);
    addParsed(app, "--projection", options.projection, nameIn(kProjections), namesOf(kProjections),
              "of the camera; a panorama is the whole sphere, equirectangular (default: perspective, or the file's)")
        ->group(group);
    addParsed(app, "--ymag", options.ymag, numberWithin(1e-6F), "M",
              "half the height of an orthographic view in metres (default: what --fov shows at the target)", kPositive)
        ->group(group);
    addParsed(app, "--aperture", options.aperture, numberWithin(0.0F), "M",
              "radius of the lens in metres (default: 0, a pinhole)", "a number, 0 or above")
        ->group(group);
    addParsed(app, "--focus", options.focus, numberWithin(1e-6F), "M",
              "metres from the lens at which all is sharp (default: to the target)", kPositive)
        ->group(group);
    eye->excludes(camera)->excludes(orbit);
    orbit->excludes(camera);
    target->excludes(camera);
}

void addLightOptions(CLI::App& app, SceneOptions& options) {
    const char* group = "Environment";
    addParsed(app, "--env", options.environment, parseEnvironment, "FILE|R,G,B|studio|none",
              "what surrounds the scene (default: the studio where the scene has no light, else none)",
              "a file, a colour R,G,B of numbers from 0, studio or none")
        ->group(group);
    addParsed(app, "--env-rotation", options.envRotation, parseNumber<float>, "DEG", "turn it about the vertical axis",
              kReal)
        ->group(group);
    addParsed(app, "--env-strength", options.envStrength, numberWithin(0.0F), "X", "multiply its radiance",
              "a number, 0 or above")
        ->group(group);
    addParsed(app, "--background", options.background, parseBackground, "env|transparent|R,G,B",
              "what the camera sees where nothing is (default: env)")
        ->group(group);
    app.add_option("--material", options.materials, "another BSDF for a material (see vkpt bsdf --help); repeatable")
        ->type_name("NAME=SPEC")
        ->allow_extra_args(false)
        ->group(group);
    app.add_option("--material-all", options.allMaterials, "another BSDF for every material")
        ->type_name("SPEC")
        ->group(group);
    addParsed(app, "--multiscatter", options.multiscatter, parseSwitch, "on|off",
              "give back what rough surfaces lose by interreflection between facets (default: on)")
        ->group(group);
}

/// "owen|xor|none", the default first.
std::string scramblesOf(const SamplerInfo& sampler) {
    std::string names;
    for (const ScrambleId id : sampler.scrambles())
        names += fmt::format("{}{}", names.empty() ? "" : "|", scrambleName(id));
    return names;
}

/// "sobol owen|xor|none, ..." of the samplers that have any.
std::string scrambleHelp() {
    std::string text;
    for (const SamplerInfo& sampler : kSamplers)
        if (sampler.scrambleCount > 0)
            text += fmt::format("{}{} {}", text.empty() ? "" : ", ", sampler.name, scramblesOf(sampler));
    return text;
}

void addIntegratorOptions(CLI::App& app, SamplingOptions& options) {
    const char* group = "Light transport";
    addParsed(app, "--integrator", options.integrator, nameIn(kIntegrators), namesOf(kIntegrators),
              fmt::format("what is computed (default: path). {}", helpOf(kIntegrators)))
        ->group(group);
    addParsed(app, "--strategy", options.strategy, nameIn(kStrategies), namesOf(kStrategies),
              "how light is found: both ways, weighted, or one of them alone (default: mis-power)")
        ->group(group);
    addParsed(app, "--beta", options.beta, numberWithin(0.0F, 64.0F), "X", "exponent of mis-power (default: 2)",
              "a number from 0 to 64")
        ->group(group);
    addParsed(app, "--hemisphere", options.hemisphere, nameIn(kHemispheres), namesOf(kHemispheres),
              "how directions are drawn where nothing is a mirror or glass (default: bsdf; of ao: cosine)")
        ->group(group);
    addParsed(app, "--bsdf-samples", options.bsdfSamples, numberWithin(0U, 1024U), "N",
              "of --integrator direct, a camera ray (default: 1)", "a whole number from 0 to 1024")
        ->group(group);
    addParsed(app, "--light-samples", options.lightSamples, numberWithin(0U, 1024U), "N",
              "of --integrator direct, a camera ray (default: 1)", "a whole number from 0 to 1024")
        ->group(group);
    addParsed(app, "--ao-distance", options.aoDistance, numberWithin(1e-6F), "M",
              "how far --integrator ao looks, in metres (default: everywhere)", kPositive)
        ->group(group);
    addParsed(app, "--clamp-indirect", options.clampIndirect, numberWithin(0.0F), "X",
              "most nits of a contribution that was scattered twice or more; takes light away (default: 0, off)",
              "a number, 0 or above")
        ->group(group);
    addParsed(app, "--filter", options.filter, parseFilter, "NAME[:RADIUS]",
              fmt::format("pixel filter, with its radius in pixels (default: box). {}", helpOf(kFilters)),
              fmt::format("one of {}, with a radius above 0 to 16", namesOf(kFilters)))
        ->group(group);
}

}  // namespace

SamplerChoice chooseSampler(SamplerId sampler, std::optional<ScrambleId> scramble) {
    if (!scramble) return sampler;
    const SamplerInfo& info = samplerInfo(sampler);
    if (info.scrambleCount == 0) throw usageError("--scramble", fmt::format("'{}' has none to choose from", info.name));
    if (std::ranges::count(info.scrambles(), *scramble) == 0)
        throw usageError("--scramble", fmt::format("'{}' is not one of '{}': {}", scrambleName(*scramble), info.name,
                                                   scramblesOf(info)));
    return {sampler, *scramble};
}

std::uint32_t roundedCount(const char* option, SamplerId sampler, std::uint32_t count) {
    const std::uint32_t rounded = sampleCount(sampler, count);
    const SamplerInfo& info = samplerInfo(sampler);
    if (rounded != count)
        spdlog::info("{} {}: '{}' takes {}, so {}", option, count, info.name, countsText(info.counts), rounded);
    return rounded;
}

void addSceneFile(CLI::App& app, SceneOptions& options, bool required) {
    app.add_option("SCENE", options.file, "glTF 2.0 file, .gltf or .glb")->required(required)->type_name("FILE");
    addParsed(app, "--scene", options.sceneIndex, numberWithin(0), "INDEX",
              "which scene of the file (default: the one it names)", "an index, 0 or above");
    app.add_flag("--allow-external", options.allowExternal, "let the scene refer to files outside its folder");
}

void addSceneOptions(CLI::App& app, SceneOptions& options) {
    addParsed(app, "--size", options.size, parseSize, "WxH",
              fmt::format("size of the picture in pixels (default: {0}x{1}, or {1} rows of the aspect ratio that the "
                          "file's camera states)",
                          options.rows * 16 / 9, options.rows));
    addCameraOptions(app, options);
    addLightOptions(app, options);
}

void addSamplingOptions(CLI::App& app, SamplingOptions& options) {
    const char* group = "Sampling";
    addParsed(app, "--spp", options.spp, numberWithin(1U), "N",
              fmt::format("samples a pixel (default: {})", options.spp), kCount)
        ->group(group);
    addParsed(app, "--samples", options.samples, parseSampleRange, "A:B",
              "render samples A to B-1 of the --spp ones only")
        ->group(group);
    addParsed(app, "--seed", options.seed, numberWithin(0U), "N", "another seed gives other noise (default: 0)", kWhole)
        ->group(group);
    addParsed(app, "--sampler", options.sampler, nameIn(kSamplers), namesOf(kSamplers),
              fmt::format("where random numbers come from (default: sobol). {}", helpOf(kSamplers)))
        ->group(group);
    addParsed(app, "--scramble", options.scramble, nameIn(kScrambles), namesOf(kScrambles),
              "how its numbers are scrambled, the default first: " + scrambleHelp())
        ->group(group);
    addParsed(app, "--max-depth", options.maxDepth, numberWithin(0U), "N",
              "0: emission, 1: direct light too, 2: one bounce, ... (default: 8)", kWhole)
        ->group(group);
    addParsed(app, "--rr", options.roulette, parseRoulette, "off|throughput|fixed:P",
              "Russian roulette (default: throughput); P: the probability to go on",
              fmt::format("off, throughput or fixed:P with P from {} to 1", kLeastSurvival))
        ->group(group);
    addParsed(app, "--rr-depth", options.rrDepth, numberWithin(0U), "N", "scatterings before it begins (default: 5)",
              kWhole)
        ->group(group);
    addIntegratorOptions(app, options);
}

void addAovs(CLI::App& app, SamplingOptions& options) {
    addParsed(app, "--aov", options.aovs, parseAovs, "LIST|all|none",
              fmt::format("layers beside the picture, with commas between (default: none). {}", helpOf(kAovs)),
              "a list of layers, see --help")
        ->group("Sampling");
}

void addLightLayers(CLI::App& app, SamplingOptions& options) {
    const char* group = "Sampling";
    app.add_flag(
           "--per-bounce", options.perBounce,
           fmt::format("layers of light by how often it was scattered: emission, direct, bounce1, ... ({} at most, "
                       "the last takes the rest), which add up to the picture; NAME_bounces.png beside the first "
                       "output NAME shows them all",
                       kMostLengthLayers))
        ->group(group);
    addParsed(
        app, "--light-groups", options.lightGroups, parseLightGroups, "all|none|NAME,NAME,...",
        fmt::format(
            "layers of light by where it comes from: name of the light or of the emissive mesh's node, '{}' "
            "({} at most); with names only these, and '{}' for the rest; NAME_lights.png shows them (default: none)",
            kEnvironmentGroup, kMostLightGroups, kOtherLights),
        "all, none, or names with commas between")
        ->group(group);
}

void addBackend(CLI::App& app, BackendOptions& options) {
    addParsed(app, "--backend", options.backend, nameIn(kBackends), namesOf(kBackends),
              "Vulkan, or the CPU reference (default: vulkan)")
        ->group("Device");
}

void addDeviceOptions(CLI::App& app, BackendOptions& options) {
    const char* group = "Device";
    app.add_option("--device", options.device, "Vulkan device, by index or part of its name: see vkpt devices")
        ->type_name("INDEX|NAME")
        ->group(group);
    addParsed(app, "--fetch", options.fetch, nameIn(kFetches), namesOf(kFetches),
              "how kernels read the scene (default: auto)")
        ->group(group);
    app.add_flag("--validate", options.validate, "turn Vulkan's validation layers on")->group(group);
    addParsed(app, "--nthreads", options.threads, numberWithin(1U), "N",
              "threads of the host, and of lavapipe (default: all, and of lavapipe three a core)", kCount)
        ->group(group);
}

void addVerbosity(CLI::App& app, Verbosity& verbosity) {
    auto* quiet = app.add_flag_callback(
        "-q,--quiet", [&verbosity] { verbosity = Verbosity::Quiet; }, "warnings and errors only, no progress bar");
    app.add_flag_callback(
           "-v,--verbose", [&verbosity] { verbosity = Verbosity::Verbose; }, "say what is done")
        ->excludes(quiet);
}

}  // namespace vkpt
