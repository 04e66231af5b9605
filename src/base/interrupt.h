// Ctrl-C: the first asks for a tidy end, the second ends at once.
#pragma once
#include <atomic>

namespace vkpt {

/// From now on the first SIGINT (or SIGTERM) sets the flag returned, and the next one kills the process as if no
/// handler were there. May be called again; the flag is the process's and is never cleared.
const std::atomic<bool>& catchInterrupt();

}  // namespace vkpt
