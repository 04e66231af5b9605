#include "gpu/pipeline_cache.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <fstream>
#include <optional>

#include "gpu/kernel.h"
#include "temporary_folder.h"
#include "test_device.h"

namespace vkpt {

std::span<const std::uint32_t> probeSpirv(std::string_view name);

namespace {

namespace fs = std::filesystem;

/// A cache folder of its own, removed afterwards.
class PipelineCacheTest : public testing::Test {
protected:
    void SetUp() override {
        if (const char* old = getenv("XDG_CACHE_HOME")) old_ = old;
        setenv("XDG_CACHE_HOME", folder_.c_str(), 1);
    }
    void TearDown() override { old_ ? setenv("XDG_CACHE_HOME", old_->c_str(), 1) : unsetenv("XDG_CACHE_HOME"); }
    /// Opens a device, compiles a kernel, closes it; the cache's file.
    static fs::path run() {
        Device device({.select = testDevice().info().name, .validation = true});
        const std::vector kinds{BindingKind::StorageBuffer, BindingKind::StorageBuffer};
        const Kernel kernel(device, probeSpirv("echo"), kinds, 8, {}, "echo");
        EXPECT_EQ(device.validationMessages(), 0U);
        return device.pipelineCache().file();
    }

    TemporaryFolder temporary_;
    fs::path folder_ = temporary_ / "cache";
    std::optional<std::string> old_;
};

TEST_F(PipelineCacheTest, IsWrittenWholeAndAlone) {
    const fs::path file = run();
    EXPECT_EQ(file.parent_path(), folder_ / "vkpt");
    EXPECT_TRUE(fs::is_regular_file(file));
    const auto entries = std::distance(fs::directory_iterator(folder_ / "vkpt"), fs::directory_iterator());
    EXPECT_EQ(entries, 1) << "a partial file was left behind";
}

TEST_F(PipelineCacheTest, DamagedFilesAreReplaced) {
    const fs::path file = run();
    const std::string good = readText(file);
    ASSERT_GT(good.size(), 40U);
    std::string flipped = good;
    flipped[good.size() - 3] = static_cast<char>(flipped[good.size() - 3] ^ 1);
    for (const std::string& bad : {std::string(), good.substr(0, good.size() / 2), flipped, std::string(1000, 'x')}) {
        std::ofstream(file, std::ios::binary | std::ios::trunc) << bad;
        run();
        EXPECT_EQ(readText(file).size(), good.size());
        EXPECT_NE(readText(file), bad);
    }
}

TEST_F(PipelineCacheTest, AnUnwritableFolderIsNoError) {
    std::ofstream(folder_) << "a file where the folder should be";
    EXPECT_NO_THROW(run());
}

TEST_F(PipelineCacheTest, NoHomeMeansNoFile) {
    const std::string home = getenv("HOME") ? getenv("HOME") : "";
    unsetenv("XDG_CACHE_HOME");
    unsetenv("HOME");
    EXPECT_EQ(run(), fs::path());
    if (!home.empty()) setenv("HOME", home.c_str(), 1);
}

}  // namespace
}  // namespace vkpt
