#include "base/hash.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace vkpt {
namespace {

std::span<const std::byte> bytes(std::string_view text) { return std::as_bytes(std::span(text)); }

// Vectors of xxHash's own sanity test: XXH3_128bits of nothing, and of no seed over its first pseudo-random byte.
TEST(ContentHash, PublishedValues) {
    EXPECT_EQ(ContentHash().hex(), "99aa06d3014798d86001c324468d497f");
    EXPECT_EQ(ContentHash().add(std::span<const std::byte>()).hex(), "99aa06d3014798d86001c324468d497f");
    constexpr std::byte first{0};
    EXPECT_EQ(ContentHash().add(std::span(&first, 1)).hex(), "a6cd5e9392000f6ac44bdff4074eecdb");
}

TEST(ContentHash, PiecesAreTheWhole) {
    const std::string text(200000, 'q');
    ContentHash pieces;
    for (std::size_t at = 0; at < text.size(); at += 777) pieces.add(bytes(std::string_view(text).substr(at, 777)));
    EXPECT_EQ(pieces.hex(), ContentHash().add(bytes(text)).hex());
}

TEST(ContentHash, TextsHaveAnEnd) {
    EXPECT_NE(ContentHash().add("ab").add("c").hex(), ContentHash().add("a").add("bc").hex());
}

TEST(ContentHash, ArraysHaveALength) {
    const std::vector<std::uint32_t> one{1}, two{1, 2}, rest{2}, none;
    EXPECT_NE(ContentHash().add(one).add(rest).hex(), ContentHash().add(two).hex());
    EXPECT_NE(ContentHash().add(two).add(none).hex(), ContentHash().add(none).add(two).hex());
}

}  // namespace
}  // namespace vkpt
