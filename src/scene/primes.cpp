#include "scene/primes.h"

namespace vkpt {
namespace {

bool isPrime(std::uint32_t n) {
    for (std::uint32_t d = 2; d * d <= n; ++d)
        if (n % d == 0) return false;
    return n >= 2;
}

}  // namespace

std::uint32_t primeFrom(std::uint32_t n) {
    while (!isPrime(n)) ++n;
    return n;
}

std::vector<std::uint32_t> firstPrimes(std::size_t count) {
    std::vector<std::uint32_t> primes;
    for (std::uint32_t n = 2; primes.size() < count; ++n)
        if (isPrime(n)) primes.push_back(n);
    return primes;
}

}  // namespace vkpt
