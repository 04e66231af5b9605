#include "scene/sampler_choice.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

#include "base/error.h"
#include "scene/primes.h"

namespace vkpt {
namespace {

constexpr std::uint64_t kMostSamples = 1ULL << 31U;

std::uint64_t roundUp(std::uint64_t n, std::uint64_t step) { return (n + step - 1) / step * step; }

std::uint64_t integerRoot(std::uint64_t n) {
    auto root = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(n)));
    while (root * root > n) --root;
    while ((root + 1) * (root + 1) <= n) ++root;
    return root;
}

std::uint64_t primeSquare(std::uint64_t n) {
    const std::uint64_t root = integerRoot(n);
    const std::uint32_t p = primeFrom(static_cast<std::uint32_t>(root * root < n ? root + 1 : root));
    return std::uint64_t{p} * p;
}

std::uint64_t roundedCount(SampleCounts counts, std::uint64_t spp) {
    switch (counts) {
        case SampleCounts::Any:
        case SampleCounts::Set:
            return spp;
        case SampleCounts::Grid:
            return spp <= kLargestSet ? roundUp(spp, integerRoot(spp)) : roundUp(spp, kLargestSet);
        case SampleCounts::Prime2:
            return spp <= kLargestPrimeSet ? primeSquare(spp) : roundUp(spp, kLargestPrimeSet);
        case SampleCounts::Power2:
            return std::bit_ceil(spp);
    }
    throw std::logic_error("sample counts of no known kind");
}

}  // namespace

const SamplerInfo& samplerInfo(SamplerId sampler) {
    const auto found = std::ranges::find(kSamplers, sampler, &SamplerInfo::id);
    if (found == kSamplers.end()) throw std::logic_error("sampler is not in the registry");
    return *found;
}

SamplerChoice::SamplerChoice(SamplerId sampler) : id(sampler) {
    const auto scrambles = samplerInfo(sampler).scrambles();
    scramble = scrambles.empty() ? ScrambleId::None : scrambles.front();
}

bool SamplerChoice::isRandomised() const {
    return samplerInfo(id).scrambleCount == 0 || (scramble != ScrambleId::None && scramble != ScrambleId::Faure);
}

std::vector<SamplerChoice> allSamplerChoices() {
    std::vector<SamplerChoice> choices;
    for (const SamplerInfo& sampler : kSamplers) {
        if (sampler.scrambleCount == 0) choices.emplace_back(sampler.id);
        for (const ScrambleId scramble : sampler.scrambles()) choices.emplace_back(sampler.id, scramble);
    }
    return choices;
}

std::string_view samplerName(SamplerId sampler) { return samplerInfo(sampler).name; }

std::string_view scrambleName(ScrambleId scramble) {
    return std::ranges::find(kScrambles, scramble, &ScrambleName::id)->name;
}

std::uint32_t sampleCount(SamplerId sampler, std::uint32_t spp) {
    const std::uint64_t count = roundedCount(samplerInfo(sampler).counts, spp);
    if (count > kMostSamples) throw Error(ExitCode::Usage, "--spp: at most 2147483648");
    return static_cast<std::uint32_t>(count);
}

std::string_view countsText(SampleCounts counts) {
    switch (counts) {
        case SampleCounts::Any:
        case SampleCounts::Set:
            return "";
        case SampleCounts::Grid:
            return "a grid of strata";
        case SampleCounts::Prime2:
            return "the square of a prime";
        case SampleCounts::Power2:
            return "a power of two";
    }
    return "";
}

}  // namespace vkpt
