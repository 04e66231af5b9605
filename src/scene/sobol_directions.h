// Direction numbers of the Sobol' sequence.
#pragma once
#include <cstdint>
#include <vector>

namespace vkpt {

/// kSobolDimensions x 32 direction numbers: [32 d + k] is what bit k of the index contributes to dimension d, bit 31
/// being 1/2. Dimension 0 is the van der Corput sequence; the others are those of [Joe 08] (new-joe-kuo-6).
[[nodiscard]] std::vector<std::uint32_t> sobolDirections();

}  // namespace vkpt
