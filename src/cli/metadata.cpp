#include "cli/metadata.h"

#include <fmt/format.h>

#include "base/version.h"
#include "cli/options.h"
#include "scene/content_hash.h"
#include "scene/pixel_filter.h"

namespace vkpt {
namespace {

/// Shortest text that reads back as the same floats; -0 is 0.
std::string text(const glm::vec3& v) { return fmt::format("{},{},{}", v.x + 0.0F, v.y + 0.0F, v.z + 0.0F); }

/// The name of an id in a table with fields `name` and `id`.
template <class Table>
std::string nameOf(const Table& table, std::uint32_t id) {
    for (const auto& entry : table)
        if (static_cast<std::uint32_t>(entry.id) == id) return std::string(entry.name);
    return {};
}

std::string backgroundText(const RenderParams& params) {
    switch (params.backgroundMode) {
        case kBackgroundTransparent:
            return "transparent";
        case kBackgroundColor:
            return text(params.background);
        default:
            return "env";
    }
}

std::string rouletteText(const RenderParams& params) {
    switch (params.rrMode) {
        case kRouletteOff:
            return "off";
        case kRouletteFixed:
            return fmt::format("fixed:{}", params.rrFixed);
        default:
            return "throughput";
    }
}

/// A setting as text, "" where the film is not ours.
std::string settingText(const Json& settings, const char* key) {
    const auto at = settings.find(key);
    if (at == settings.end()) return {};
    return at->is_string() ? at->get<std::string>() : at->dump();
}

}  // namespace

Json renderSettings(const PreparedScene& prepared) {
    const RenderParams& p = prepared.options.params;
    const SceneHashes hashes = hashScene(prepared.arrays);
    return {{"version", kVersion},
            {"scene", prepared.file.filename().string()},
            {"sceneIndex", prepared.sceneIndex},
            {"size", fmt::format("{}x{}", p.width, p.height)},
            {"spp", p.spp},
            {"seed", p.seed},
            {"sampler", samplerName(prepared.options.sampler.id)},
            {"scramble", scrambleName(prepared.options.sampler.scramble)},
            {"projection", nameOf(kProjections, p.projection)},
            {"eye", text(p.eye)},
            {"forward", text(p.forward)},
            {"right", text(p.right)},
            {"up", text(p.up)},
            {"env", prepared.environment},
            {"envRotation", fmt::format("{}", prepared.envRotation)},
            {"envStrength", fmt::format("{}", prepared.envStrength)},
            {"background", backgroundText(p)},
            {"multiscatter", prepared.arrays.features.multiscatter ? "on" : "off"},
            {"maxDepth", p.maxDepth},
            {"rr", rouletteText(p)},
            {"rrDepth", p.rrDepth},
            {"integrator", nameOf(kIntegrators, p.integrator)},
            {"strategy", nameOf(kStrategies, p.strategy)},
            {"beta", fmt::format("{}", p.beta)},
            {"hemisphere", nameOf(kHemispheres, p.hemisphere)},
            {"bsdfSamples", p.bsdfSamples},
            {"lightSamples", p.lightSamples},
            {"aoDistance", fmt::format("{}", p.aoDistance)},
            {"clampIndirect", fmt::format("{}", p.clampIndirect)},
            {"filter", fmt::format("{}:{}", nameOf(kFilters, p.pixelFilter), p.filterRadius)},
            {"aperture", fmt::format("{}", p.lensRadius)},
            {"focus", fmt::format("{}", p.focusDistance)},
            {"aov", aovsText(prepared.options.aovs)},
            {"perBounce", prepared.options.light.lengths},
            {"lightGroups", prepared.options.light.groups},
            {"geometry", hashes.geometry},
            {"materials", hashes.materials},
            {"lights", hashes.lights},
            {"environment", hashes.environment},
            {"options", hashOptions(prepared.options)}};
}

ImageMetadata imageMetadata(const FilmRecord& record) {
    const Json& settings = record.settings;
    return {{"software", std::string(kSoftware)},
            {"vkpt:version", std::string(kVersion)},
            {"vkpt:scene", settingText(settings, "scene")},
            {"vkpt:settings", jsonText(settings, -1)},
            {"vkpt:settingsHash", settingsHash(settings)},
            {"vkpt:spp", std::to_string(record.film.samples())},
            {"vkpt:samples", rangesText(record.film.ranges)},
            {"vkpt:seed", settingText(settings, "seed")},
            {"vkpt:sampler", settingText(settings, "sampler")},
            {"vkpt:backend", backendsOf(record)},
            {"vkpt:device", devicesOf(record)}};
}

}  // namespace vkpt
