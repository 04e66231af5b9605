#include "base/log.h"

#include <unistd.h>

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <memory>
#include <string>

#include "base/progress.h"

namespace vkpt {

void setUpLog(Verbosity verbosity) {
    auto logger = std::make_shared<spdlog::logger>("vkpt", std::make_shared<spdlog::sinks::stderr_sink_mt>());
    // A message takes the place of a progress bar, which the next update draws anew.
    logger->set_pattern(std::string(::isatty(STDERR_FILENO) == 1 ? kWipeLine : "") + "%n: %l: %v");
    logger->set_level(verbosity == Verbosity::Quiet    ? spdlog::level::warn
                      : verbosity == Verbosity::Normal ? spdlog::level::info
                                                       : spdlog::level::debug);
    spdlog::set_default_logger(std::move(logger));
}

}  // namespace vkpt
