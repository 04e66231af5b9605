#include "cli/scene_setup.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <memory>

#include "cli/clock.h"
#include "cli/command.h"
#include "cli/estimator_check.h"
#include "gltf/import.h"
#include "scene/camera.h"
#include "scene/default_light.h"
#include "scene/environment.h"
#include "scene/flatten.h"
#include "scene/light_groups.h"
#include "scene/material_override.h"

namespace vkpt {
namespace {

using EnvironmentKind = EnvironmentChoice::Kind;

/// Notes how long each step took.
class StepClock {
public:
    explicit StepClock(Json& seconds) : seconds_(seconds) {}
    void done(const char* step) {
        const double now = secondsSinceStart();
        seconds_[step] = now - last_;
        seconds_["total"] = now;
        spdlog::debug("{} took {:.3f} s", step, now - last_);
        last_ = now;
    }

private:
    Json& seconds_;
    double last_ = secondsSinceStart();
};

void setTransport(RenderParams& params, const SamplingOptions& sampling) {
    params.integrator = static_cast<std::uint32_t>(sampling.integrator);
    params.strategy = static_cast<std::uint32_t>(sampling.strategy);
    params.hemisphere = static_cast<std::uint32_t>(sampling.hemisphere);
    params.beta = sampling.beta;
    params.bsdfSamples = sampling.bsdfSamples;
    params.lightSamples = sampling.lightSamples;
    params.aoDistance = sampling.aoDistance;
    params.clampIndirect = sampling.clampIndirect;
    params.pixelFilter = sampling.filter.id;
    params.filterRadius = sampling.filter.radius;
}

/// Layers of light, now that scene and integrator are known.
void setLightLayers(PreparedScene& prepared, const SamplingOptions& sampling) {
    RenderOptions& options = prepared.options;
    const RenderParams& params = options.params;
    const bool background = params.backgroundMode == kBackgroundColor && params.background != glm::vec3(0);
    if (sampling.perBounce) options.light.lengths = lengthLayers(pathDepth(params));
    if (!sampling.lightGroups.on) return;
    groupLights(prepared.arrays, sampling.lightGroups, background, prepared.file.string());
    options.light.groups = prepared.arrays.lightGroups.names;
}

void setSampling(RenderOptions& options, const SamplingOptions& sampling) {
    options.sampler = chooseSampler(sampling.sampler, sampling.scramble);
    options.aovs = sampling.aovs;
    const std::uint32_t spp = roundedCount("--spp", sampling.sampler, sampling.spp);
    const SampleRange range = sampling.samples.value_or(SampleRange{0, spp});
    if (range.end > spp)
        throw usageError("--samples",
                         fmt::format("{}:{} reaches beyond the {} samples of --spp", range.begin, range.end, spp));
    options.sampleBegin = range.begin;
    options.sampleEnd = range.end;
    RenderParams& params = options.params;
    params.spp = spp;
    params.seed = sampling.seed;
    params.maxDepth = sampling.maxDepth;
    params.rrMode = sampling.roulette.mode;
    params.rrFixed = sampling.roulette.survival;
    params.rrDepth = sampling.rrDepth;
    checkEstimator(sampling);
    setTransport(params, sampling);
}

void useFileCamera(RenderParams& params, const Scene& scene, Camera camera, std::optional<float> fov) {
    if (fov && !camera.orthographic) camera.yfov = glm::radians(*fov);
    fromCamera(params, scene, camera);
}

/// The camera of the file that is asked for, else its first; null where the command line or the scene decides.
const Camera* fileCamera(const Scene& scene, const SceneOptions& options) {
    if (options.eye || options.orbit) return nullptr;
    if (options.target) throw usageError("--target", "needs --eye or --orbit");
    if (!options.camera.empty()) return &findCamera(scene, options.camera);
    return scene.cameras.empty() ? nullptr : &scene.cameras.front();
}

/// The size asked for, else the default number of rows in the camera's aspect ratio.
glm::uvec2 frameSize(const SceneOptions& options, const Camera* camera) {
    constexpr float kAspect = 16.0F / 9.0F, kMost = 65535;
    if (options.size) return *options.size;
    const float aspect = camera && camera->aspect ? *camera->aspect : kAspect;
    return {std::clamp(std::round(options.rows * aspect), 1.0F, kMost), options.rows};
}

/// Projection and lens of the command line. `distance`: from the eye to the target, along the view.
void setLens(RenderParams& params, const SceneOptions& options, float distance) {
    const float reach = distance > 0 ? distance : 1;
    const bool fileIsOrthographic = params.projection == kProjectionOrthographic;
    if (options.projection) setProjection(params, static_cast<std::uint32_t>(*options.projection), reach);
    if (options.fov && fileIsOrthographic) {
        if (params.projection == kProjectionOrthographic)
            throw usageError("--fov", "the camera is orthographic: give --ymag, or --projection perspective");
        if (params.projection == kProjectionPerspective)
            setHalfHeight(params, std::tan(glm::radians(*options.fov) / 2));
    }
    if (options.ymag) {
        if (params.projection != kProjectionOrthographic) throw usageError("--ymag", "needs --projection orthographic");
        setHalfHeight(params, *options.ymag);
    }
    if (options.aperture > 0 && params.projection == kProjectionPanorama)
        throw usageError("--aperture", "a panorama has no lens");
    params.lensRadius = options.aperture;
    params.focusDistance = options.focus.value_or(reach);
}

void setCamera(RenderParams& params, const Scene& scene, const SceneArrays& arrays, const SceneOptions& options) {
    const Camera* camera = fileCamera(scene, options);
    const glm::uvec2 size = frameSize(options, camera);
    params.width = size.x;
    params.height = size.y;
    const glm::vec3 target = options.target.value_or((arrays.boundsMin + arrays.boundsMax) / 2.0F);
    const float fov = options.fov.value_or(kDefaultFov);
    if (camera)
        useFileCamera(params, scene, *camera, options.fov);
    else if (options.eye)
        lookAt(params, *options.eye, target, fov);
    else if (options.orbit)
        orbit(params, options.orbit->x, options.orbit->y, options.orbit->z, target, fov);
    else
        frameScene(params, arrays, fov);
    setLens(params, options, glm::dot(target - params.eye, params.forward));
}

/// Resolves Automatic, now that the scene is known, and says what came of it.
EnvironmentKind resolveKind(EnvironmentKind kind, const SceneArrays& arrays) {
    if (kind != EnvironmentKind::Automatic) return kind;
    if (hasOwnLight(arrays)) return EnvironmentKind::None;
    spdlog::info("the scene has no light of its own: the built-in studio lights it (see --env)");
    return EnvironmentKind::Studio;
}

/// What the picture will lack, and options given in vain.
void warnOfEstimator(const PreparedScene& prepared, const SceneOptions& scene, const SamplingOptions& sampling) {
    for (const std::string& line : idleOptions(scene, sampling)) spdlog::warn("{}", line);
    if (prepared.arrays.lights.empty() && !hasOwnLight(prepared.arrays)) spdlog::warn("nothing lights this scene");
    if (const std::string line = unfoundLight(prepared.arrays, prepared.options.params); !line.empty())
        spdlog::warn("{}", line);
}

void setEnvironment(PreparedScene& prepared, EnvironmentChoice choice, std::future<EnvironmentMap> file) {
    choice.kind = resolveKind(choice.kind, prepared.arrays);
    prepared.environment = environmentName(choice);
    if (choice.kind == EnvironmentKind::None) return;
    const EnvironmentMap map = file.valid() ? file.get() : makeEnvironment(choice);
    addEnvironment(prepared.arrays, map, prepared.envStrength, prepared.envRotation);
}

}  // namespace

EnvironmentMap makeEnvironment(const EnvironmentChoice& choice) {
    switch (choice.kind) {
        case EnvironmentKind::File:
            return readEnvironment(choice.file);
        case EnvironmentKind::Color:
            return constantEnvironment(choice.color);
        case EnvironmentKind::Studio:
            return studioEnvironment();
        default:
            return {};
    }
}

std::string environmentName(const EnvironmentChoice& choice) {
    switch (choice.kind) {
        case EnvironmentKind::File:
            return choice.file.filename().string();
        case EnvironmentKind::Color:
            return fmt::format("{},{},{}", choice.color.x, choice.color.y, choice.color.z);
        case EnvironmentKind::Studio:
            return "studio";
        default:
            return "none";
    }
}

PreparedScene prepareScene(const SceneOptions& scene, const SamplingOptions& sampling) {
    PreparedScene prepared;
    prepared.file = scene.file;
    prepared.sceneIndex = scene.sceneIndex;
    prepared.envRotation = scene.envRotation;
    prepared.envStrength = scene.envStrength;
    setSampling(prepared.options, sampling);

    StepClock clock(prepared.seconds);
    std::future<EnvironmentMap> environment;  // a large file is read while the scene is
    if (scene.environment.kind == EnvironmentKind::File)
        environment = std::async(std::launch::async, readEnvironment, scene.environment.file);
    const auto overrideAll = [&](std::vector<Material>& materials) {
        if (!scene.allMaterials.empty()) overrideMaterials(materials, scene.allMaterials);
        for (const std::string& text : scene.materials) overrideMaterial(materials, text);
    };
    const Scene imported = importGltf(scene.file, {scene.sceneIndex, scene.allowExternal, overrideAll});
    for (const std::string& warning : imported.warnings) spdlog::warn("{}", warning);
    clock.done("import");
    prepared.arrays = flatten(imported, {.multiscatter = scene.multiscatter});
    clock.done("flatten");
    setEnvironment(prepared, scene.environment, std::move(environment));
    clock.done("environment");
    RenderParams& params = prepared.options.params;
    setCamera(params, imported, prepared.arrays, scene);
    params.backgroundMode = scene.background.mode;
    params.background = scene.background.color;
    setLightLayers(prepared, sampling);
    warnOfEstimator(prepared, scene, sampling);
    clock.done("camera");
    buildBvh(prepared.arrays, {}, &prepared.bvh);
    clock.done("bvh");
    return prepared;
}

}  // namespace vkpt
