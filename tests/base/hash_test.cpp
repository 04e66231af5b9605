#include "base/hash.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "base/error.h"

namespace vkpt {
namespace {

std::span<const std::byte> bytes(std::string_view text) { return std::as_bytes(std::span(text)); }

// Test vectors of the draft, draft-eastlake-fnv.
TEST(ContentHash, PublishedValuesOfFnv1a) {
    EXPECT_EQ(ContentHash().value(), 0xcbf29ce484222325U);
    EXPECT_EQ(ContentHash().add(bytes("a")).value(), 0xaf63dc4c8601ec8cU);
    EXPECT_EQ(ContentHash().add(bytes("foobar")).value(), 0x85944171f73967e8U);
    EXPECT_EQ(ContentHash().add(bytes("foobar")).hex(), "85944171f73967e8");
}

TEST(ContentHash, TextsHaveAnEnd) {
    EXPECT_NE(ContentHash().add("ab").add("c").value(), ContentHash().add("a").add("bc").value());
}

TEST(ContentHash, FileIsItsBytes) {
    const auto path = std::filesystem::temp_directory_path() / ("vkpt_hash_" + std::to_string(::getpid()));
    const std::string text(200000, 'q');
    std::ofstream(path, std::ios::binary) << text;
    EXPECT_EQ(ContentHash().addFile(path).value(), ContentHash().add(bytes(text)).value());
    std::filesystem::remove(path);
    EXPECT_THROW(ContentHash().addFile(path), FileError);
}

}  // namespace
}  // namespace vkpt
