#include "scene/sobol_directions.h"

#include <bit>
#include <boost/random/detail/sobol_table.hpp>
#include <span>

#include "constants.h"

namespace vkpt {
namespace {

using SobolTable = boost::random::detail::qrng_tables::sobol;
static_assert(SobolTable::max_dimension == kSobolDimensions);
constexpr unsigned kBits = 32;

/// Extends the initial numbers of one dimension by its primitive polynomial's recurrence. [Joe 08, eq. 2]
void fillDimension(std::size_t polynomialIndex, std::span<std::uint32_t> v) {
    const unsigned polynomial = SobolTable::polynomial(polynomialIndex);
    const unsigned degree = static_cast<unsigned>(std::bit_width(polynomial)) - 1;
    for (unsigned k = 0; k < degree; ++k) {
        v[k] = std::uint32_t{SobolTable::minit(polynomialIndex, k)} << (kBits - 1 - k);
    }
    for (unsigned k = degree; k < kBits; ++k) {
        v[k] = v[k - degree] >> degree;
        for (unsigned i = 0; i < degree; ++i) {
            if ((polynomial >> i & 1U) != 0) v[k] ^= v[k - (degree - i)];
        }
    }
}

}  // namespace

std::vector<std::uint32_t> sobolDirections() {
    std::vector<std::uint32_t> directions(std::size_t{kSobolDimensions} * kBits);
    for (unsigned k = 0; k < kBits; ++k) directions[k] = 1U << (kBits - 1 - k);
    for (std::size_t d = 1; d < kSobolDimensions; ++d) {
        fillDimension(d - 1, std::span(directions).subspan(d * kBits, kBits));
    }
    return directions;
}

}  // namespace vkpt
