// A sampler, its scramble, and the numbers of samples that its construction takes.
#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

#include "registry.h"

namespace vkpt {

/// The registry's line. Throws std::logic_error for an id it does not hold.
[[nodiscard]] const SamplerInfo& samplerInfo(SamplerId sampler);

/// A sampler and how it is scrambled; ScrambleId::None where it has no scrambles.
struct SamplerChoice {
    SamplerId id = SamplerId::Sobol;
    ScrambleId scramble = ScrambleId::Owen;

    SamplerChoice() = default;
    SamplerChoice(SamplerId sampler);  ///< with its default scramble; implicit: a name alone is a choice
    SamplerChoice(SamplerId sampler, ScrambleId how) : id(sampler), scramble(how) {}

    bool operator==(const SamplerChoice&) const = default;

    /// Whether the seed matters: else every pixel of every render has the same points.
    [[nodiscard]] bool isRandomised() const;
};

/// Every sampler with every scramble it has.
[[nodiscard]] std::vector<SamplerChoice> allSamplerChoices();

/// As registry.def and --scramble name them.
[[nodiscard]] std::string_view samplerName(SamplerId sampler);
[[nodiscard]] std::string_view scrambleName(ScrambleId scramble);

/// The least number of samples, `spp` or more, that the sampler's sets have. Throws Error(Usage) beyond 2^31.
[[nodiscard]] std::uint32_t sampleCount(SamplerId sampler, std::uint32_t spp);

/// "a power of two": what sampleCount rounds to; empty where any number will do.
[[nodiscard]] std::string_view countsText(SampleCounts counts);

struct ScrambleName {
    ScrambleId id;
    std::string_view name;
};
inline constexpr auto kScrambles = std::to_array<ScrambleName>({{ScrambleId::None, "none"},
                                                                {ScrambleId::Xor, "xor"},
                                                                {ScrambleId::Digit, "digit"},
                                                                {ScrambleId::Faure, "faure"},
                                                                {ScrambleId::Owen, "owen"}});

}  // namespace vkpt
