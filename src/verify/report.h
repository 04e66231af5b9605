// A folder that shows what a verification found: pictures, and one page that needs nothing else.
#pragma once
#include <filesystem>
#include <string>

#include "base/json.h"
#include "film/encode.h"
#include "verify/ladder.h"

namespace vkpt {

struct ReportInput {
    std::filesystem::path folder;  ///< see makeReportFolder
    std::string title;             ///< of the scene
    Json settings;                 ///< name and value: shown as a table
    const LadderResult& ladder;
    ImageMetadata deviceMetadata, referenceMetadata;
};

/// Makes the folder where it is missing: before the work, so that a bad name is told at once. Throws FileError.
void makeReportFolder(const std::filesystem::path& folder);

/// Writes gpu.exr and cpu.exr (the same random numbers on both sides), diff.png (where they differ) and index.html, in
/// which all pictures are embedded. Renders what the climb did not come to. Throws FileError.
void writeReport(VerifyContext& context, const ReportInput& input);

}  // namespace vkpt
