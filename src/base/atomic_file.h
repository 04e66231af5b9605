// Files that appear whole or not at all.
#pragma once
#include <cstddef>
#include <filesystem>
#include <span>

namespace vkpt {

/// Replaces `path` by `bytes`: they go to a temporary file beside it, which is then renamed, so a reader never
/// sees half a file and a failure leaves the old one untouched. A symbolic link keeps pointing to its target; what
/// is no regular file (a pipe, /dev/stdout) is written to directly. Throws FileError with the system's reason.
void writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// Throws the FileError that writeFileAtomically would meet for want of a folder or a permission. For finding out
/// before the work is done, not after.
void checkWritable(const std::filesystem::path& path);

}  // namespace vkpt
