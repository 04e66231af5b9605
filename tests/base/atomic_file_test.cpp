#include "base/atomic_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <string>
#include <thread>

#include "base/error.h"
#include "temporary_folder.h"

namespace vkpt {
namespace {

namespace fs = std::filesystem;

class AtomicFile : public testing::Test {
protected:
    static void write(const fs::path& path, const std::string& text) {
        writeFileAtomically(path, std::as_bytes(std::span(text)));
    }
    TemporaryFolder folder_;
};

TEST_F(AtomicFile, WritesAndReplaces) {
    write(folder_ / "a", "one");
    write(folder_ / "a", "two, longer");
    write(folder_ / "a", "3");
    EXPECT_EQ(readText(folder_ / "a"), "3");
    EXPECT_EQ(folder_.files().size(), 1U);
}

// A write that fails half-way, as on a full disk: the limit on file sizes makes one. The child is a process of its
// own because the limit cannot be raised again by an ordinary user.
TEST_F(AtomicFile, FailureHalfWayLeavesTheOldFileAndNoTemporary) {
    write(folder_ / "a", "old");
    const auto attempt = [&] {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{4096, 4096};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        try {
            write(folder_ / "a", std::string(100000, 'x'));
        } catch (const FileError& error) {
            const bool reasonNamed = std::string(error.what()).ends_with("/a: cannot write: File too large");
            std::_Exit(reasonNamed ? 4 : 1);
        }
        std::_Exit(0);
    };
    EXPECT_EXIT(attempt(), testing::ExitedWithCode(4), "");
    EXPECT_EQ(readText(folder_ / "a"), "old");
    EXPECT_EQ(folder_.files().size(), 1U);
}

TEST_F(AtomicFile, FolderAsTargetIsRefused) {
    EXPECT_THROW(write(folder_.path(), "x"), FileError);
    EXPECT_THROW(checkWritable(folder_.path()), FileError);
}

TEST_F(AtomicFile, MissingFolderIsFoundBeforehand) {
    EXPECT_THROW(checkWritable(folder_ / "absent" / "a"), FileError);
    EXPECT_NO_THROW(checkWritable(folder_ / "a"));
    EXPECT_EQ(folder_.files().size(), 0U) << "a check leaves no trace";
}

TEST_F(AtomicFile, SymbolicLinkStaysALink) {
    write(folder_ / "target", "old");
    fs::create_symlink("target", folder_ / "link");
    write(folder_ / "link", "new");
    EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
    EXPECT_EQ(readText(folder_ / "target"), "new");
}

TEST_F(AtomicFile, PipeIsWrittenToNotReplaced) {
    const fs::path pipe = folder_ / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    std::string received;
    std::thread reader([&] { received = readText(pipe); });
    write(pipe, "through");
    reader.join();
    EXPECT_EQ(received, "through");
    EXPECT_TRUE(fs::is_fifo(pipe));
}

}  // namespace
}  // namespace vkpt
