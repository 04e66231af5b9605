// Runs the built program as a user does.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace vkpt {

struct RunResult {
    int code = -1;  ///< exit code; 128 + signal where one killed it
    std::string out, err;
    [[nodiscard]] int errLines() const;
};

struct RunOptions {
    std::filesystem::path folder{};          ///< where it runs
    std::vector<std::string> environment{};  ///< "NAME=value", added to the caller's
    std::string interruptAfter{};            ///< send SIGINT once stderr holds this text
};

[[nodiscard]] RunResult runVkpt(const std::vector<std::string>& arguments, const RunOptions& options);

/// A folder of its own for each test, gone afterwards.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// Writes a file there and returns its path.
    [[nodiscard]] std::filesystem::path write(const std::string& name, const std::string& text) const;
    /// Names of the files there, sorted.
    [[nodiscard]] std::vector<std::string> files() const;

private:
    std::filesystem::path path_;
};

/// A glTF file of one triangle, three vertices in an external buffer `buffer.bin` (see triangleBuffer); no light.
[[nodiscard]] std::string triangleGltf();
[[nodiscard]] std::string triangleBuffer(float size = 1);

[[nodiscard]] std::string readText(const std::filesystem::path& file);

}  // namespace vkpt
