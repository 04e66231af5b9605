// vkpt: the subcommand table, and the one place where exceptions become exit codes.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <new>

#include "base/log.h"
#include "base/version.h"
#include "cli/command.h"

namespace {

using namespace vkpt;

constexpr std::array kCommands{&kRenderCommand,  &kMergeCommand, &kVerifyCommand,  &kDiffCommand, &kInfoCommand,
                               &kDevicesCommand, &kBenchCommand, &kSamplesCommand, &kBsdfCommand, &kEnvCommand};

int fail(ExitCode code, const std::string& message) {
    std::fprintf(stderr, "vkpt: %s\n", message.c_str());
    return static_cast<int>(code);
}

bool isCommand(const char* word) {
    return std::any_of(kCommands.begin(), kCommands.end(), [&](auto* c) { return std::strcmp(c->name, word) == 0; });
}

/// Names the word at fault, where CLI11 would only say that some command is required.
void checkFirstWord(int argc, char** argv) {
    if (argc < 2 || isCommand(argv[1])) return;
    const std::string word = argv[1];
    if (word == "-h" || word == "--help" || word == "--version") return;
    std::string names;
    for (const Command* command : kCommands) names.append(names.empty() ? "" : ", ").append(command->name);
    throw Error(ExitCode::Usage, fmt::format("'{}' is no command: there are {}", word, names));
}

/// Parses the command line and runs the command it names.
ExitCode run(CLI::App& app, int argc, char** argv) {
    checkFirstWord(argc, argv);
    std::function<ExitCode()> chosen;
    app.require_subcommand(1);
    app.set_version_flag("--version", std::string(kSoftware));
    for (const Command* command : kCommands) {
        CLI::App* sub = app.add_subcommand(command->name, command->summary);
        sub->footer(std::string("Example:\n  ") + command->example);
        sub->callback([&chosen, runner = command->setup(*sub)] { chosen = runner; });
    }
    app.footer("vkpt COMMAND --help shows an example of each.");
    app.parse(argc, argv);
    const ExitCode code = chosen();
    if (!std::cout.flush()) throw FileError("standard output", "cannot write");
    return code;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Path tracer for glTF 2.0 on Vulkan compute, with an independent CPU reference.", "vkpt");
    std::signal(SIGXFSZ, SIG_IGN);  // a file beyond a limit is an error like a full disk, not the end
    try {
        setUpLog(Verbosity::Normal);
        return static_cast<int>(run(app, argc, argv));
    } catch (const CLI::Success& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        const std::string command = argc > 1 && isCommand(argv[1]) ? std::string(argv[1]) + " " : "";
        return fail(ExitCode::Usage, fmt::format("{} (see vkpt {}--help)", error.what(), command));
    } catch (const Error& error) {
        return fail(error.code(), error.what());
    } catch (const std::bad_alloc&) {
        return fail(ExitCode::Internal, "out of memory on the host");
    } catch (const std::exception& error) {
        return fail(ExitCode::Internal, std::string("internal error: ") + error.what());
    }
}
