// The options that several commands share, in groups. Each struct's initial values are the documented defaults.
#pragma once
#include <fmt/format.h>

#include <CLI/App.hpp>
#include <array>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/log.h"
#include "cli/parse.h"
#include "scene/sampler_choice.h"
#include "wavefront/renderer.h"

namespace vkpt {

/// Of the camera; else the file's own.
enum class Projection : std::uint32_t {
    Perspective = kProjectionPerspective,
    Orthographic = kProjectionOrthographic,
    Panorama = kProjectionPanorama,
};

/// Which scene, seen how, lit by what.
struct SceneOptions {
    std::filesystem::path file;
    int sceneIndex = -1;             ///< -1: the file's default scene
    bool allowExternal = false;      ///< the scene may refer to files outside its folder
    std::optional<glm::uvec2> size;  ///< else `rows` rows: as wide as the camera of the file states, or 16:9
    float rows = 540;
    std::string camera;  ///< name or index; empty: the file's first, else framed
    std::optional<glm::vec3> eye, target, orbit;
    std::optional<float> fov;  ///< degrees, vertical
    std::optional<Projection> projection;
    std::optional<float> ymag;   ///< metres, half the height of an orthographic view
    float aperture = 0;          ///< metres, radius of the lens
    std::optional<float> focus;  ///< metres; else to the target
    EnvironmentChoice environment;
    float envRotation = 0;  ///< degrees about +y
    float envStrength = 1;
    Background background;
    std::vector<std::string> materials;  ///< NAME=SPEC
    std::string allMaterials;            ///< SPEC; empty: none
    bool multiscatter = true;            ///< compensate the interreflection between facets
};

enum class Strategy : std::uint32_t {
    MisPower = kStrategyMisPower,
    MisBalance = kStrategyMisBalance,
    Bsdf = kStrategyBsdf,
    Light = kStrategyLight,
};

enum class Hemisphere : std::uint32_t {
    Bsdf = kHemisphereBsdf,
    Uniform = kHemisphereUniform,
    Cosine = kHemisphereCosine,
};

template <class Id>
struct Named {
    Id id;
    std::string_view name;
};

inline constexpr auto kProjections = std::to_array<Named<Projection>>({{Projection::Perspective, "perspective"},
                                                                       {Projection::Orthographic, "orthographic"},
                                                                       {Projection::Panorama, "panorama"}});
inline constexpr auto kStrategies = std::to_array<Named<Strategy>>({{Strategy::MisPower, "mis-power"},
                                                                    {Strategy::MisBalance, "mis-balance"},
                                                                    {Strategy::Bsdf, "bsdf"},
                                                                    {Strategy::Light, "light"}});
inline constexpr auto kHemispheres = std::to_array<Named<Hemisphere>>(
    {{Hemisphere::Bsdf, "bsdf"}, {Hemisphere::Uniform, "uniform"}, {Hemisphere::Cosine, "cosine"}});

/// How it is sampled.
struct SamplingOptions {
    std::uint32_t spp = 64, seed = 0;
    std::optional<SampleRange> samples;
    SamplerId sampler = SamplerId::Sobol;
    std::optional<ScrambleId> scramble;  ///< else the sampler's default
    std::uint32_t maxDepth = 8;
    Roulette roulette;
    std::uint32_t rrDepth = 5;
    IntegratorId integrator = IntegratorId::Path;
    Strategy strategy = Strategy::MisPower;
    float beta = 2;
    Hemisphere hemisphere = Hemisphere::Bsdf;
    std::uint32_t bsdfSamples = 1, lightSamples = 1;
    float aoDistance = std::numeric_limits<float>::infinity();  ///< metres
    float clampIndirect = 0;                                    ///< nits; 0: off
    PixelFilter filter;
    AovSet aovs;
    bool perBounce = false;
    LightGroupChoice lightGroups;
};

enum class Backend { Vulkan, Cpu };

/// The sampler with the scramble that is asked for, or its default. Throws a usage error where it has no such one.
[[nodiscard]] SamplerChoice chooseSampler(SamplerId sampler, std::optional<ScrambleId> scramble);
/// The number of samples that `option` asks for, or the next that the sampler's sets have, with a notice.
[[nodiscard]] std::uint32_t roundedCount(const char* option, SamplerId sampler, std::uint32_t count);

/// What computes it.
struct BackendOptions {
    Backend backend = Backend::Vulkan;
    std::string device;
    WavefrontConfig::Fetch fetch = WavefrontConfig::Fetch::Auto;
    bool validate = false;
    unsigned threads = 0;  ///< of the host; 0: all
};

/// `file` becomes the positional SCENE, required or not.
void addSceneFile(CLI::App& app, SceneOptions& options, bool required);
void addSceneOptions(CLI::App& app, SceneOptions& options);
void addSamplingOptions(CLI::App& app, SamplingOptions& options);
void addAovs(CLI::App& app, SamplingOptions& options);
void addLightLayers(CLI::App& app, SamplingOptions& options);
void addBackend(CLI::App& app, BackendOptions& options);
void addDeviceOptions(CLI::App& app, BackendOptions& options);
inline constexpr const char* kCount = "a whole number from 1 to 4294967295";
inline constexpr const char* kWhole = "a whole number from 0 to 4294967295";
inline constexpr const char* kReal = "a number";
inline constexpr const char* kPositive = "a number above 0";

void addVerbosity(CLI::App& app, Verbosity& verbosity);

/// Adds an option whose text `parse` turns into a value. A text it refuses is a usage error: "--size: 'big' is not
/// WxH", or `expected` instead of the form where that says more.
template <class T, class Parse>
CLI::Option* addParsed(CLI::App& app, const std::string& name, T& target, Parse parse, const std::string& form,
                       const std::string& help, const std::string& expected = {}) {
    return app
        .add_option_function<std::string>(
            name,
            [&target, parse, name, wanted = expected.empty() ? form : expected](const std::string& text) {
                const auto value = parse(text);
                if (!value) throw CLI::ValidationError(name, fmt::format("'{}' is not {}", text, wanted));
                target = *value;
            },
            help)
        ->type_name(form);
}

/// A parser for addParsed that finds a name in a registry-like table (fields `name` and `id`).
template <class Table>
auto nameIn(const Table& table) {
    return [&table](std::string_view text) {
        std::optional<decltype(table[0].id)> found;
        for (const auto& entry : table)
            if (entry.name == text) found = entry.id;
        return found;
    };
}

/// "random|sobol"
template <class Table>
std::string namesOf(const Table& table) {
    std::string names;
    for (const auto& entry : table) names += fmt::format("{}{}", names.empty() ? "" : "|", entry.name);
    return names;
}

/// "path: path tracing; direct: ...": of a table with fields `name` and `help`.
template <class Table>
std::string helpOf(const Table& table) {
    std::string text;
    for (const auto& entry : table) text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", entry.name, entry.help);
    return text;
}

}  // namespace vkpt
