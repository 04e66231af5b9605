#include "cli/run_vkpt.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

namespace vkpt {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void becomeVkpt(const std::vector<std::string>& arguments, const RunOptions& options, const fs::path& out,
                             const fs::path& err) {
    if (::chdir(options.folder.c_str()) != 0) std::_Exit(126);
    ::dup2(::open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
    ::dup2(::open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
    std::vector<std::string> environment = options.environment;
    for (std::string& variable : environment) ::putenv(variable.data());
    if (options.mostFileBytes > 0) {
        const rlimit limit{options.mostFileBytes, options.mostFileBytes};
        if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) std::_Exit(126);
    }
    std::vector<char*> argv{const_cast<char*>(VKPT_BINARY)};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    ::execv(VKPT_BINARY, argv.data());
    std::_Exit(127);
}

/// Waits for the text, at most 20 s, and the delay, then sends the signal.
void sendSignal(pid_t child, const fs::path& err, const RunOptions& options) {
    for (int i = 0; i < 2000 && readText(err).find(options.interruptAfter) == std::string::npos; ++i) {
        siginfo_t ended{};
        if (::waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 && ended.si_pid != 0)
            return;  // it ended by itself
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    std::this_thread::sleep_for(options.delay.value_or(std::chrono::milliseconds(200)));
    ::kill(child, options.signal);
}

}  // namespace

int RunResult::errLines() const { return static_cast<int>(std::count(err.begin(), err.end(), '\n')); }

RunResult runVkpt(const std::vector<std::string>& arguments, const RunOptions& options) {
    const TemporaryFolder logs;
    const fs::path out = logs.path() / "out", err = logs.path() / "err";
    const pid_t child = ::fork();
    if (child == 0) becomeVkpt(arguments, options, out, err);
    if (!options.interruptAfter.empty() || options.delay) sendSignal(child, err, options);
    int status = 0;
    ::waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), readText(out), readText(err)};
}

std::string triangleGltf() {
    return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                       "min": [0, 0, 0], "max": [1, 1, 0]}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"uri": "buffer.bin", "byteLength": 36}]})";
}

std::string triangleBuffer(float size) {
    const float corners[9] = {0, 0, 0, size, 0, 0, 0, size, 0};
    return {reinterpret_cast<const char*>(corners), sizeof corners};
}

}  // namespace vkpt
