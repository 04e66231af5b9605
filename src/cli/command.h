// What a subcommand is, and the table of all of them.
#pragma once
#include <CLI/App.hpp>
#include <functional>
#include <span>

#include "base/error.h"

namespace vkpt {

/// One subcommand. `setup` adds its options to `app`, bound to a state of its own, and returns what runs once they
/// are parsed. Both throw Error; usage faults are CLI11's or Error(ExitCode::Usage), naming the option.
struct Command {
    const char* name;
    const char* summary;
    const char* example;  ///< shown under --help
    std::function<ExitCode()> (*setup)(CLI::App& app);
};

extern const Command kRenderCommand, kMergeCommand, kVerifyCommand, kDiffCommand, kInfoCommand, kDevicesCommand,
    kBenchCommand, kSamplesCommand, kBsdfCommand, kEnvCommand;

/// A usage error of `option`, exit 64.
inline Error usageError(const std::string& option, const std::string& fault) {
    return Error(ExitCode::Usage, option + ": " + fault);
}

}  // namespace vkpt
