// The one exception type, and the exit codes every command shares.
#pragma once
#include <stdexcept>
#include <string>
#include <utility>

#include "base/printable.h"

namespace vkpt {

/// Process exit codes, the same for every command.
enum class ExitCode : int {
    Ok = 0,
    Warning = 1,       ///< images differ by a warning
    Disagree = 2,      ///< images or renderers disagree
    SizeMismatch = 3,  ///< image sizes differ
    File = 4,          ///< a file is missing, malformed, unsupported or cannot be written
    Device = 5,        ///< no Vulkan device, device lost or out of memory
    Usage = 64,
    Internal = 70,
    Interrupted = 130,
};

/// A problem to tell the user about in one line. Only main catches it.
class Error : public std::runtime_error {
public:
    Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
    [[nodiscard]] ExitCode code() const { return code_; }

private:
    ExitCode code_;
};

/// `file: what is wrong and how to mend it`; exit 4.
class FileError : public Error {
public:
    FileError(const std::string& file, const std::string& fault)
        : Error(ExitCode::File, printable(file + ": " + fault)) {}
};

/// Vulkan is absent, lost or out of memory; exit 5.
class DeviceError : public Error {
public:
    explicit DeviceError(const std::string& message) : Error(ExitCode::Device, message) {}
};

}  // namespace vkpt
