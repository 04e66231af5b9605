// What the processor is good at, where libraries and drivers do not ask for it themselves.
#pragma once

namespace vkpt {

/// Whether vectors of 512 bits are known to be faster than those of 256: AVX-512 on AMD's processors from family 26
/// (Zen 5) on. Earlier ones take two steps; those of other makers have not been measured.
[[nodiscard]] bool computes512Bits();

}  // namespace vkpt
