// Outputs that cannot be written to their end: exit code 4, one line that names the file, older files untouched.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/atomic_file.h"
#include "cli/run_vkpt.h"
#include "film/encode.h"
#include "temporary_folder.h"

namespace vkpt {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Words = std::vector<std::string>;

constexpr const char* kOlder = "an older file";

Words renderTo(const std::string& option, const std::string& file) {
    return {"render",    VKPT_SCENES "/cornell_box/scene.gltf",
            "--backend", "cpu",
            "--size",    "24x16",
            "--spp",     "1",
            "-q",        option,
            file};
}

void expectUntouched(const Words& words, const std::string& file, const TemporaryFolder& folder,
                     const RunOptions& options, const char* reason) {
    (void)folder.write(file, kOlder);
    const RunResult r = runVkpt(words, options);
    EXPECT_EQ(r.code, 4) << file;
    EXPECT_THAT(r.err, testing::StartsWith("vkpt: " + file + ": cannot write: "));
    EXPECT_THAT(r.err, HasSubstr(reason));
    EXPECT_EQ(r.errLines(), 1) << r.err;
    EXPECT_EQ(readText(folder / file), kOlder) << file;
}

// A limit on the size of files meets the same calls as a disk that fills up while a file is being written.
TEST(FullDisk, LeavesOlderFilesUntouched) {
    const TemporaryFolder folder;
    const RunOptions options{.folder = folder.path(), .mostFileBytes = 200};
    for (const char* file : {"a.png", "a.exr", "a.hdr", "a.pfm"})
        expectUntouched(renderTo("-o", file), file, folder, options, "File too large");
    std::filesystem::create_symlink("/dev/null", folder / "null.png");  // takes the picture whatever the limit
    Words withStats = renderTo("-o", "null.png");
    withStats.insert(withStats.end(), {"--stats", "s.json"});
    expectUntouched(withStats, "s.json", folder, options, "File too large");
    EXPECT_THAT(folder.files(), testing::Not(testing::Contains(HasSubstr("tmp")))) << "nor are halves left behind";
}

TEST(FullDisk, LeavesAnOlderHeatMapUntouched) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "b.exr", encodeExr(Image(30, 20, 3), {}));
    expectUntouched({"diff", "b.exr", "b.exr", "-o", "h.png"}, "h.png", folder,
                    {.folder = folder.path(), .mostFileBytes = 200}, "File too large");
    EXPECT_THAT(folder.files(), ElementsAre("b.exr", "h.png"));
}

TEST(FullDisk, IsReportedOfDevicesToo) {
    ASSERT_TRUE(std::ofstream("/dev/full")) << "Linux has this device everywhere";
    const TemporaryFolder folder;
    std::filesystem::create_symlink("/dev/full", folder / "a.exr");
    const RunResult r = runVkpt(renderTo("-o", "a.exr"), {.folder = folder.path()});
    EXPECT_EQ(r.code, 4);
    EXPECT_THAT(r.err, HasSubstr("a.exr: cannot write: No space left on device"));
    EXPECT_EQ(r.errLines(), 1) << r.err;
}

}  // namespace
}  // namespace vkpt
