// What a sampler's kernels read: the samplerTable section of the scene buffer.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "scene/sampler_choice.h"

namespace vkpt {

/// The words that shaders/samplers/STEM.glsl documents; empty where the sampler reads none. Below 1 MiB.
/// `lastIndex`: the highest sample index that kernels may meet.
[[nodiscard]] std::vector<std::uint32_t> samplerTable(SamplerChoice sampler, std::uint32_t lastIndex = ~0U);

/// Faure's permutation of 0 … base - 1. [Faure 92]
[[nodiscard]] std::vector<std::uint32_t> faurePermutation(std::uint32_t base);

}  // namespace vkpt
