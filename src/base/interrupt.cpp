#include "base/interrupt.h"

#include <csignal>

namespace vkpt {
namespace {

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may touch lock-free atomics only");

extern "C" void onInterrupt(int) { interrupted.store(true); }

}  // namespace

const std::atomic<bool>& catchInterrupt() {
    struct sigaction action {};
    action.sa_handler = onInterrupt;
    // SA_RESETHAND gives the second signal its default, deadly meaning; SA_RESTART keeps file writes whole.
    action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
    sigemptyset(&action.sa_mask);
    ::sigaction(SIGINT, &action, nullptr);
    ::sigaction(SIGTERM, &action, nullptr);
    return interrupted;
}

}  // namespace vkpt
