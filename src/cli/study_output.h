// What every command that makes a study ends with.
#pragma once
#include <filesystem>

#include "analysis/studies.h"

namespace vkpt {

/// Before the work: `output` is empty, or a picture that can be written. Throws a usage error, FileError.
void checkPicture(const std::filesystem::path& output);

/// Writes the picture to `output`, unless it is empty, and prints the table or the JSON. Throws FileError.
void showStudy(const Study& study, const std::filesystem::path& output, bool json);

}  // namespace vkpt
