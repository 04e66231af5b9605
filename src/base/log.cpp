#include "base/log.h"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <memory>

namespace vkpt {

void setUpLog(Verbosity verbosity) {
    auto logger = std::make_shared<spdlog::logger>("vkpt", std::make_shared<spdlog::sinks::stderr_sink_mt>());
    logger->set_pattern("%n: %l: %v");
    logger->set_level(verbosity == Verbosity::Quiet    ? spdlog::level::warn
                      : verbosity == Verbosity::Normal ? spdlog::level::info
                                                       : spdlog::level::debug);
    spdlog::set_default_logger(std::move(logger));
}

}  // namespace vkpt
