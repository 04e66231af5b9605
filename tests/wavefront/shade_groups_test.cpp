// Shade groups: hits go to the kernel of their BSDF's group, and only what a scene has is there.
#include <algorithm>

#include "scene/bsdf_spec.h"
#include "verify/inputs/scenes.h"
#include "wavefront/kernels.h"
#include "wavefront/render_helpers.h"

namespace vkpt {
namespace {

std::vector<std::string> shadeStages(const WavefrontStats& stats) {
    std::vector<std::string> names;
    for (const StageStats& stage : stats.stages)
        if (stage.name.starts_with("shade")) names.push_back(stage.name);
    return names;
}

/// The lamps, with `model` on every surface.
SceneArrays lampsOf(BsdfId model) {
    Scene scene = makeLamps();
    for (Material& material : scene.materials)
        if (model != BsdfId::Gltf) material.bsdf = defaultBsdf(model);
    return makeArrays(scene);
}

TEST(ShadeGroups, OfModels) {
    constexpr auto kPath = static_cast<std::uint32_t>(IntegratorId::Path);
    EXPECT_EQ(shadeGroupsOf(1, kPath), 1U << kGroupGltf);
    for (const BsdfModelInfo& model : kBsdfModels)
        EXPECT_EQ(shadeGroupsOf(1U << static_cast<std::uint32_t>(model.id), kPath),
                  1U << static_cast<std::uint32_t>(model.group));
}

TEST(ShadeGroups, LooksHaveOneWhateverTheModels) {
    EXPECT_EQ(shadeGroupsOf(~0U, static_cast<std::uint32_t>(IntegratorId::Albedo)), 1U << kGroupGltf);
    EXPECT_EQ(shadeGroupsOf(~0U, static_cast<std::uint32_t>(IntegratorId::LightProbability)), (1U << kGroups) - 1);
}

TEST(ShadeGroups, ASceneOfOneGroupHasOneKernel) {
    const auto stagesOf = [](BsdfId model) {
        WavefrontStats stats;
        (void)renderWith(lampsOf(model), makeOptions(16, 12, 1), makeConfig(), &stats);
        return shadeStages(stats);
    };
    EXPECT_EQ(stagesOf(BsdfId::Gltf), std::vector<std::string>{"shade"});
    EXPECT_EQ(stagesOf(BsdfId::Lambert), std::vector<std::string>{"shade_classic"});
}

TEST(ShadeGroups, FullFormsOfKernelsDoNotChangeTheFilm) {
    const SceneArrays arrays = makeBsdfPatches(true);
    const RenderOptions options = makeOptions(32, 24, 2);
    WavefrontStats stats;
    const Film film = renderWith(arrays, options, makeConfig(), &stats);
    EXPECT_EQ(shadeStages(stats), (std::vector<std::string>{"shade", "shade_microfacet", "shade_classic"}));
    std::uint64_t hits = 0, misses = 0;
    for (const StageStats& stage : stats.stages) {
        if (stage.name == "miss") misses += stage.items;
        if (!stage.name.starts_with("shade")) continue;
        EXPECT_GT(stage.items, 100U) << stage.name;
        hits += stage.items;
    }
    EXPECT_EQ(hits + misses, stats.pathRays);
    WavefrontConfig config = makeConfig();
    config.ballot = false;
    config.fetch = WavefrontConfig::Fetch::Storage;
    config.pathsInFlight = 500;
    config.timings = true;
    EXPECT_TRUE(isSame(film, renderWith(arrays, options, config)));
}

}  // namespace
}  // namespace vkpt
