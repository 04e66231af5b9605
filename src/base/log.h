// The log: one line a message on stderr. Use spdlog::debug, info, warn and error.
#pragma once

namespace vkpt {

enum class Verbosity { Quiet, Normal, Verbose };

/// Sends spdlog's default logger to stderr as "vkpt: warning: ...". Quiet keeps warnings and errors, Normal adds
/// what the user should know, Verbose all.
void setUpLog(Verbosity verbosity);

}  // namespace vkpt
