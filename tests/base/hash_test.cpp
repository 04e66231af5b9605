#include "base/hash.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "temporary_folder.h"

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
    const TemporaryFolder folder;
    const std::string text(200000, 'q');
    EXPECT_EQ(ContentHash().addFile(folder.write("a", text)).value(), ContentHash().add(bytes(text)).value());
    EXPECT_THROW(ContentHash().addFile(folder / "absent"), FileError);
}

}  // namespace
}  // namespace vkpt
