// Time since the process began.
#pragma once

namespace vkpt {

/// Seconds since the program was loaded.
[[nodiscard]] double secondsSinceStart();

/// Most memory the process has had in use so far, in bytes.
[[nodiscard]] unsigned long peakHostBytes();

}  // namespace vkpt
