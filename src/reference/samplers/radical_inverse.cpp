#include "reference/samplers/radical_inverse.h"

#include <vector>

#include "reference/samplers/bits.h"
#include "scene/primes.h"

namespace vkpt::reference {

namespace {

/// Replaces digits one after the other; remembers what it has seen as far as the scramble depends on it.
class DigitScrambler {
public:
    DigitScrambler(ScrambleId scramble, std::uint32_t base, std::uint32_t key)
        : scramble_(scramble), base_(base), key_(key) {}

    std::uint32_t operator()(std::uint32_t digit) {
        switch (scramble_) {
            case ScrambleId::Faure:
                return faureDigit(digit, base_);
            case ScrambleId::Digit: {
                const std::uint32_t result = permuted(digit);
                key_ *= base_;
                return result;
            }
            case ScrambleId::Owen: {
                const std::uint32_t result = permuted(digit);
                key_ = digit == 0 ? key_ * base_ : mixBits(key_ ^ digit);  // the permutations below are the digit's own
                return result;
            }
            default:
                return digit;
        }
    }

private:
    /// A random affine map modulo the base: any two digits go to any two others alike. [Owen 03]
    [[nodiscard]] std::uint32_t permuted(std::uint32_t digit) const {
        const std::uint32_t factor = 1 + (key_ & 0xffffU) * (base_ - 1) / 65536;
        return (factor * digit + scaled(key_, base_)) % base_;
    }

    ScrambleId scramble_;
    std::uint32_t base_, key_;
};

}  // namespace

std::uint32_t faureDigit(std::uint32_t digit, std::uint32_t base) {
    if (base == 1) return 0;
    if (base % 2 == 0) {
        const std::uint32_t half = base / 2;
        return 2 * faureDigit(digit % half, half) + digit / half;
    }
    const std::uint32_t middle = (base - 1) / 2;
    if (digit == middle) return middle;
    const std::uint32_t element = faureDigit(digit < middle ? digit : digit - 1, base - 1);
    return element < middle ? element : element + 1;
}

std::uint32_t radicalInverse(std::uint32_t index, std::uint32_t base, ScrambleId scramble, std::uint32_t key) {
    DigitScrambler scrambled(scramble, base, key);
    std::uint64_t value = 0, power = 1;
    for (; power < 1U << 24U; power *= base, index /= base) value = value * base + scrambled(index % base);
    const std::uint64_t reciprocal = ~0ULL / power + 1;  // ceil(2^64 / power); times value it is below 2^64
    return static_cast<std::uint32_t>(value * reciprocal >> 32U);
}

std::uint32_t haltonDimension(SampleId id, std::uint32_t dim, ScrambleId scramble) {
    static const std::vector<std::uint32_t> primes = firstPrimes(kHaltonDimensions);
    const std::uint32_t key = samplerKey(id.pixel, dim, id.seed).x;
    const std::uint32_t bits = radicalInverse(id.index, primes[dim % kHaltonDimensions], scramble, key);
    const bool random = scramble == ScrambleId::Owen || scramble == ScrambleId::Digit;
    return random || dim < kHaltonDimensions ? bits : bits + samplerKey(0, dim, 0).x;
}

}  // namespace vkpt::reference
