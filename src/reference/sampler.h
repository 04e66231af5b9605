// Stateless samplers: the bits of one dimension of one sample. A new one is a .cpp in samplers/ and a registry line.
#pragma once
#include <cstdint>

#include "constants.h"
#include "reference/hash.h"
#include "reference/real.h"
#include "scene/sampler_choice.h"

namespace vkpt::reference {

/// Which sample of which pixel. `pixel` is x | y << 16 in full-frame coordinates.
struct SampleId {
    std::uint32_t pixel = 0, index = 0, spp = 0, seed = 0;
};

#define VKPT_SAMPLER(Name, stem) std::uint32_t stem##Bits(SampleId id, std::uint32_t dim);
#define VKPT_SCRAMBLED_SAMPLER(Name, stem) \
    std::uint32_t stem##Bits(SampleId id, std::uint32_t dim, ScrambleId scramble);
#include "reference_samplers.inc"
#undef VKPT_SAMPLER
#undef VKPT_SCRAMBLED_SAMPLER

/// The function of a sampler and its scramble.
struct SamplerBits {
    std::uint32_t (*function)(SampleId id, std::uint32_t dim, ScrambleId scramble) = nullptr;
    ScrambleId scramble = ScrambleId::None;

    std::uint32_t operator()(SampleId id, std::uint32_t dim) const { return function(id, dim, scramble); }
};

/// The function of a registered sampler. Throws std::logic_error for an id the registry does not hold.
[[nodiscard]] SamplerBits samplerBits(SamplerChoice sampler);

/// One sample of one path: every random number it uses, by dimension.
struct PathSample {
    SamplerBits bits;
    SampleId id;

    [[nodiscard]] glm::uvec2 bits2D(std::uint32_t dim) const { return {bits(id, dim), bits(id, dim + 1)}; }
    [[nodiscard]] float get1D(std::uint32_t dim) const { return toUnit(bits(id, dim)); }
    [[nodiscard]] Vec2<float> get2D(std::uint32_t dim) const { return {get1D(dim), get1D(dim + 1)}; }
};

}  // namespace vkpt::reference
