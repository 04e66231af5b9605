// Runs the built program as a user does.
#pragma once
#include <chrono>
#include <csignal>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "temporary_folder.h"

namespace vkpt {

struct RunResult {
    int code = -1;  ///< exit code; 128 + signal where one killed it
    std::string out, err;
    [[nodiscard]] int errLines() const;
};

struct RunOptions {
    std::filesystem::path folder{};                    ///< where it runs
    std::vector<std::string> environment{};            ///< "NAME=value", added to the caller's
    std::string interruptAfter{};                      ///< send `signal` once stderr holds this text
    std::optional<std::chrono::milliseconds> delay{};  ///< before the signal; without a text since the start
    int signal = SIGINT;
    std::size_t mostFileBytes = 0;                     ///< the largest file it may write; 0: any
};

[[nodiscard]] RunResult runVkpt(const std::vector<std::string>& arguments, const RunOptions& options);

/// A glTF file of one triangle, three vertices in an external buffer `buffer.bin` (see triangleBuffer); no light.
[[nodiscard]] std::string triangleGltf();
[[nodiscard]] std::string triangleBuffer(float size = 1);

}  // namespace vkpt
