#include "base/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <fmt/format.h>
#include <cerrno>
#include <cstring>
#include <utility>

#include "base/error.h"

namespace vkpt {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
    throw FileError(path.string(), fmt::format("cannot write: {}", std::strerror(error)));
}

/// An open file descriptor. Closing it says whether the bytes arrived, so it is done by hand on success.
class Descriptor {
public:
    Descriptor(const std::filesystem::path& path, int flags) : fd_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (fd_ >= 0) ::close(fd_);
    }
    [[nodiscard]] bool isOpen() const { return fd_ >= 0; }

    /// 0, or the errno of the failure.
    int writeAndClose(std::span<const std::byte> bytes) {
        while (!bytes.empty()) {
            const ssize_t written = ::write(fd_, bytes.data(), bytes.size());
            if (written < 0 && errno == EINTR) continue;
            if (written < 0) return errno;
            bytes = bytes.subspan(static_cast<std::size_t>(written));
        }
        return ::close(std::exchange(fd_, -1)) == 0 ? 0 : errno;
    }

private:
    int fd_;
};

void writeDirectly(const std::filesystem::path& path, std::span<const std::byte> bytes) {
    Descriptor file(path, O_WRONLY);
    if (!file.isOpen()) fail(path, errno);
    if (const int error = file.writeAndClose(bytes)) fail(path, error);
}

/// Where the bytes really go: the target of a link, else the path itself.
std::filesystem::path resolveLink(const std::filesystem::path& path) {
    std::error_code error;
    const std::filesystem::path target = std::filesystem::canonical(path, error);
    return error ? path : target;
}

/// A pipe, a terminal, a device: renaming a file over it would destroy it.
bool isSpecial(const std::filesystem::path& path) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
           !std::filesystem::is_directory(status);
}

}  // namespace

void checkWritable(const std::filesystem::path& path) {
    const std::filesystem::path target = resolveLink(path);
    std::error_code error;
    if (std::filesystem::is_directory(target, error)) fail(path, EISDIR);
    if (::access(target.c_str(), F_OK) == 0 && ::access(target.c_str(), W_OK) != 0) fail(path, errno);
    if (isSpecial(target)) return;
    const std::filesystem::path folder = target.has_parent_path() ? target.parent_path() : ".";
    if (::access(folder.c_str(), W_OK | X_OK) != 0) fail(path, errno);
    if (!std::filesystem::is_directory(folder, error)) fail(path, ENOTDIR);
}

void writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> bytes) {
    checkWritable(path);
    const std::filesystem::path target = resolveLink(path);
    if (isSpecial(target)) return writeDirectly(path, bytes);
    std::filesystem::path temporary = target;
    temporary += fmt::format(".{}.tmp", ::getpid());
    int error = 0;
    {
        Descriptor file(temporary, O_WRONLY | O_CREAT | O_TRUNC);
        if (!file.isOpen()) fail(path, errno);
        error = file.writeAndClose(bytes);
    }
    if (error == 0 && ::rename(temporary.c_str(), target.c_str()) != 0) error = errno;
    if (error != 0) {
        ::unlink(temporary.c_str());
        fail(path, error);
    }
}

}  // namespace vkpt
