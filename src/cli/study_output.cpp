#include "cli/study_output.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <iostream>

#include "base/atomic_file.h"
#include "cli/command.h"
#include "plot/write.h"

namespace vkpt {

void checkPicture(const std::filesystem::path& output) {
    if (output.empty()) return;
    if (!isDrawingFile(output))
        throw usageError("--output", fmt::format("'{}' is none of {}", output.string(), kDrawingExtensions));
    checkWritable(output);
}

void showStudy(const Study& study, const std::filesystem::path& output, bool json) {
    if (!output.empty()) {
        writeDrawing(output, study.drawing);
        spdlog::info("wrote {}", output.string());
    }
    std::cout << (json ? jsonText(study.json) + "\n" : study.table);
}

}  // namespace vkpt
