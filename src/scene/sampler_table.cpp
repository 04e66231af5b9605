#include "scene/sampler_table.h"

#include "scene/primes.h"
#include "scene/sampler_data.h"
#include "scene/sobol_directions.h"

namespace vkpt {
namespace {

/// Packs small numbers, the first in the lowest bits.
template <class Numbers>
std::vector<std::uint32_t> packed(const Numbers& numbers, unsigned bitsEach) {
    const std::size_t perWord = 32 / bitsEach;
    std::vector<std::uint32_t> words((numbers.size() + perWord - 1) / perWord);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        words[i / perWord] |= std::uint32_t{numbers[i]} << (i % perWord * bitsEach);
    return words;
}

/// b | D << 11 | upper half of M << 16, floor((2^32 - 1) / b), lower half of M, b^(K - D): K digits are 24 bits or
/// more, M = ceil(2^64 / b^K), D of them may be other than 0.
void appendBase(std::vector<std::uint32_t>& table, std::uint32_t base, std::uint32_t lastIndex) {
    std::uint32_t digits = 0, zeros = 1;
    std::uint64_t power = 1;
    for (; power < 1U << 24U; power *= base) {
        if (digits == 0 || power <= lastIndex)
            ++digits;
        else
            zeros *= base;
    }
    const std::uint64_t multiplier = ~0ULL / power + 1;  // ceil(2^64 / power)
    table.push_back(base | digits << 11U | static_cast<std::uint32_t>(multiplier >> 32U) << 16U);
    table.push_back(~0U / base);
    table.push_back(static_cast<std::uint32_t>(multiplier));
    table.push_back(zeros);
}

/// Where Faure's permutation of every base begins, in elements of 16 bits; then the permutations, two elements a word.
void appendFaure(std::vector<std::uint32_t>& table, const std::vector<std::uint32_t>& bases) {
    std::vector<std::uint32_t> permutations;
    const std::size_t begin = 2 * (table.size() + bases.size());
    for (const std::uint32_t base : bases) {
        table.push_back(static_cast<std::uint32_t>(begin + permutations.size()));
        const auto permutation = faurePermutation(base);
        permutations.insert(permutations.end(), permutation.begin(), permutation.end());
    }
    const auto words = packed(permutations, 16);
    table.insert(table.end(), words.begin(), words.end());
}

std::vector<std::uint32_t> radicalInverseTable(ScrambleId scramble, std::uint32_t lastIndex) {
    std::vector<std::uint32_t> table;
    const std::vector<std::uint32_t> bases = firstPrimes(kHaltonDimensions);
    for (const std::uint32_t base : bases) appendBase(table, base, lastIndex);
    if (scramble == ScrambleId::Faure) appendFaure(table, bases);
    return table;
}

}  // namespace

std::vector<std::uint32_t> faurePermutation(std::uint32_t base) {
    if (base == 1) return {0};
    std::vector<std::uint32_t> permutation;
    if (base % 2 == 0) {
        for (const std::uint32_t half : faurePermutation(base / 2)) permutation.push_back(2 * half);
        for (std::uint32_t i = 0; i < base / 2; ++i) permutation.push_back(permutation[i] + 1);
        return permutation;
    }
    const std::uint32_t middle = (base - 1) / 2;
    permutation = faurePermutation(base - 1);
    for (std::uint32_t& element : permutation) element += element >= middle ? 1 : 0;
    permutation.insert(permutation.begin() + middle, middle);
    return permutation;
}

std::vector<std::uint32_t> samplerTable(SamplerChoice sampler, std::uint32_t lastIndex) {
    switch (sampler.id) {
        case SamplerId::Sobol:
            return sobolDirections();
        case SamplerId::Halton:
        case SamplerId::Hammersley:
            return radicalInverseTable(sampler.scramble, lastIndex);
        case SamplerId::Pmj02:
            return {pmj02Tables().begin(), pmj02Tables().end()};
        case SamplerId::Rank1:
            return {kRank1Generator.begin(), kRank1Generator.end()};
        case SamplerId::Bluenoise:
            return packed(blueNoiseMask(), 16);
        default:
            return {};
    }
}

}  // namespace vkpt
