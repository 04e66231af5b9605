// vkpt: the subcommand table, and the one place where exceptions become exit codes.
#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <iostream>
#include <new>

#include "base/log.h"
#include "base/version.h"
#include "cli/command.h"

namespace {

using namespace vkpt;

constexpr std::array kCommands{&kRenderCommand, &kInfoCommand, &kDevicesCommand, &kBenchCommand};

int fail(ExitCode code, const std::string& message) {
    std::fprintf(stderr, "vkpt: %s\n", message.c_str());
    return static_cast<int>(code);
}

/// Parses the command line and runs the command it names.
ExitCode run(CLI::App& app, int argc, char** argv) {
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
    try {
        setUpLog(Verbosity::Normal);
        return static_cast<int>(run(app, argc, argv));
    } catch (const CLI::Success& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        return fail(ExitCode::Usage, std::string(error.what()) + " (see vkpt --help)");
    } catch (const Error& error) {
        return fail(error.code(), error.what());
    } catch (const std::bad_alloc&) {
        return fail(ExitCode::Internal, "out of memory on the host");
    } catch (const std::exception& error) {
        return fail(ExitCode::Internal, std::string("internal error: ") + error.what());
    }
}
