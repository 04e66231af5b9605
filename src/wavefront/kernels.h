// The kernels of one render, specialised for its scene and options.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "film/film_layout.h"
#include "gpu/kernel.h"
#include "gpu/spirv_source.h"
#include "scene/render_options.h"
#include "scene/scene_arrays.h"

namespace vkpt {

/// SPIR-V of shaders/kernels/NAME.comp; empty where there is none. Generated.
std::span<const std::uint32_t> kernelSpirv(std::string_view name);

/// Bindings of every kernel: frame, scene as storage, scene as texels, path state, counters, film, path state as
/// texels.
inline constexpr std::array kKernelBindings = {
    BindingKind::UniformBuffer, BindingKind::StorageBuffer, BindingKind::StorageTexel, BindingKind::StorageBuffer,
    BindingKind::StorageBuffer, BindingKind::StorageBuffer, BindingKind::StorageTexel};

/// What kernels are specialised for, besides the scene.
struct KernelOptions {
    SamplerChoice sampler{};
    std::uint32_t lastIndex = ~0U;  ///< the highest sample index they may meet
    std::uint32_t setSamples = 0;   ///< N, where the sampler's points depend on it; 0: read it when they run
    bool fetchTexel = false, useBallot = false, stateTexel = false;
    std::uint32_t listTriangles = 0;                ///< 0: the tree is walked
    std::uint32_t stackEntries = kMaxStackEntries;  ///< of the tree's walk
    bool inlineShadows = false;                     ///< shade kernels trace light samples themselves
    FilmLayout film{};
    RenderParams params = defaultParams();  ///< integrator, strategy, hemisphere and camera
};

/// Halvings that searchCdf of shaders/math/cdf.glsl needs for a table of `count` entries.
[[nodiscard]] std::uint32_t searchSteps(std::uint32_t count);

/// How many triangles kernels test one after the other; 0 where they walk the tree: of more than kListMax, of alpha or
/// instances, and for integrator cost, which shows the tree.
[[nodiscard]] std::uint32_t listTriangles(const SceneArrays& arrays, std::uint32_t integrator);

/// How many entries the stack of a walk of the tree needs (bvh/wide_node.h). Requires buildBvh.
[[nodiscard]] std::uint32_t stackEntries(const SceneArrays& arrays);

/// Values of the constants of shaders/specialization.glsl, by constant_id.
[[nodiscard]] std::vector<std::uint32_t> specializationOf(const SceneFeatures& features, const SceneHeader& header,
                                                          const KernelOptions& options);

/// Whether an integrator asks nothing of BSDFs: kernel look then shades every hit.
[[nodiscard]] bool needsNoBsdf(std::uint32_t integrator);

/// Shade groups (kGroup*) that hits are sorted into, a bit each: those of a set of BSDF models, or kGroupGltf alone
/// for looks.
[[nodiscard]] std::uint32_t shadeGroupsOf(std::uint32_t bsdfModels, std::uint32_t integrator);

struct WavefrontKernels {
    Kernel generate, intersect, miss, accumulate;
    std::array<std::optional<Kernel>, kGroups> shade;  ///< of the groups that hits are sorted into
    std::optional<Kernel> shadow;                      ///< unless shade traces light samples
    std::optional<Kernel> layers;

    /// Every kernel that the scene and `options` need; with the variants that need no subgroup operations unless
    /// useBallot.
    WavefrontKernels(Device& device, const SpirvSource& spirv, const SceneFeatures& features, const SceneHeader& header,
                     const KernelOptions& options);
};

}  // namespace vkpt
