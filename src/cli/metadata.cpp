#include "cli/metadata.h"

#include <fmt/format.h>

#include "base/hash.h"
#include "base/version.h"

namespace vkpt {
namespace {

/// Shortest text that reads back as the same floats; -0 is 0.
std::string text(const glm::vec3& v) { return fmt::format("{},{},{}", v.x + 0.0F, v.y + 0.0F, v.z + 0.0F); }

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

}  // namespace

Json renderSettings(const PreparedScene& prepared) {
    const RenderParams& p = prepared.options.params;
    return {{"sceneIndex", prepared.sceneIndex},
            {"size", fmt::format("{}x{}", p.width, p.height)},
            {"spp", p.spp},
            {"seed", p.seed},
            {"sampler", samplerName(prepared.options.sampler.id)},
            {"scramble", scrambleName(prepared.options.sampler.scramble)},
            {"projection", p.projection == kProjectionOrthographic ? "orthographic" : "perspective"},
            {"eye", text(p.eye)},
            {"forward", text(p.forward)},
            {"right", text(p.right)},
            {"up", text(p.up)},
            {"env", prepared.environment},
            {"envRotation", fmt::format("{}", prepared.envRotation)},
            {"envStrength", fmt::format("{}", prepared.envStrength)},
            {"background", backgroundText(p)},
            {"maxDepth", p.maxDepth},
            {"rr", rouletteText(p)},
            {"rrDepth", p.rrDepth}};
}

std::string settingsHash(const PreparedScene& prepared) {
    ContentHash hash;
    hash.addFile(prepared.file);
    for (const std::filesystem::path& file : prepared.sceneFiles) hash.addFile(file);
    if (!prepared.envFile.empty()) hash.addFile(prepared.envFile);
    return hash.add(jsonText(renderSettings(prepared), -1)).hex();
}

ImageMetadata imageMetadata(const PreparedScene& prepared, const RenderReport& report, const Film& film) {
    const RenderParams& params = prepared.options.params;
    return {{"software", std::string(kSoftware)},
            {"vkpt:version", std::string(kVersion)},
            {"vkpt:scene", prepared.file.filename().string()},
            {"vkpt:settings", jsonText(renderSettings(prepared), -1)},
            {"vkpt:settingsHash", settingsHash(prepared)},
            {"vkpt:spp", std::to_string(film.samples())},
            {"vkpt:samples", rangesText(film.ranges)},
            {"vkpt:seed", std::to_string(params.seed)},
            {"vkpt:sampler", std::string(samplerName(prepared.options.sampler.id))},
            {"vkpt:backend", report.backend},
            {"vkpt:device", report.device}};
}

}  // namespace vkpt
