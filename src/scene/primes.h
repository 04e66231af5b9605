// Prime numbers: bases of radical inverses, levels of orthogonal arrays.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vkpt {

/// The smallest prime that is not below n.
[[nodiscard]] std::uint32_t primeFrom(std::uint32_t n);

/// The first `count` primes.
[[nodiscard]] std::vector<std::uint32_t> firstPrimes(std::size_t count);

}  // namespace vkpt
