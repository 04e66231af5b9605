#include "film/film.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/error.h"

namespace vkpt {
namespace {

Film onePixel(uvec4 red, std::uint32_t samples) {
    Film film(1, 1);
    if (samples > 0) film.ranges = {{0, samples}};
    film.sums[0].red = red;
    return film;
}

float redOf(uvec4 red, std::uint32_t samples) { return filmToImage(onePixel(red, samples)).pixels[0]; }

TEST(FilmToImage, FractionBitsAreFortyEight) {
    EXPECT_EQ(redOf({0, 1U << 16U, 0, 0}, 1), 1.0F);
    EXPECT_EQ(redOf({0, 0, 1, 0}, 1), 65536.0F);
    EXPECT_EQ(redOf({1, 0, 0, 0}, 1), std::ldexp(1.0F, -48));
    EXPECT_EQ(redOf({0, 0, 0x40000000U, 0}, 1), std::ldexp(1.0F, 46));
    EXPECT_EQ(redOf({0, 0, 0, 0}, 7), 0.0F);
    EXPECT_EQ(redOf({1, 0, 0, 0}, 0xffffffffU), static_cast<float>(std::ldexp(1.0, -48) / 4294967295.0));
}

TEST(FilmToImage, SumsAreInTwosComplement) {
    EXPECT_EQ(redOf({0xffffffffU, 0xffffffffU, 0xffffffffU, 0}, 1), -std::ldexp(1.0F, -48));
    EXPECT_EQ(redOf({0, 0xfffe8000U, 0xffffffffU, 0}, 3), -0.5F);
    EXPECT_EQ(redOf({0, 0, 0x80000000U, 0}, 1), -std::ldexp(1.0F, 47));
    Film film = onePixel({0, 0xfffe8000U, 0xffffffffU, 0}, 1), other = onePixel({0, 0x20000U, 0, 0}, 1);
    other.ranges = {{1, 2}};
    addFilm(film, other);
    EXPECT_EQ(filmToImage(film).pixels[0], 0.25F);
}

TEST(FilmToImage, QuotientIsRoundedOnce) {
    // 1 + 2^-24 lies halfway between two floats: even wins. One unit more, 72 bits below, decides upwards, and
    // would be lost had the sum gone through a double first.
    EXPECT_EQ(redOf({0x01000000U, 0x00010000U, 0, 0}, 1), 1.0F);
    EXPECT_EQ(redOf({0x01000001U, 0x00010000U, 0, 0}, 1), 1.0F + std::ldexp(1.0F, -23));
    // 2^31 x (1 + 2^-24) + 2^-48 needs 80 bits.
    EXPECT_EQ(redOf({0, 0x00800000U, 0x00008000U, 0}, 1), std::ldexp(1.0F, 31));
    EXPECT_EQ(redOf({1, 0x00800000U, 0x00008000U, 0}, 1), std::ldexp(1.0F, 31) + 256.0F);
}

TEST(FilmToImage, EqualsLongDivisionOfRandomSums) {
    std::mt19937 generator(7);
    for (int i = 0; i < 2000; ++i) {
        // Sums below 2^53 and their division in double are exact enough for a second rounding to be harmless.
        const std::uint32_t low = generator(), high = generator() & 0x1fffffU, samples = 1 + generator() % 4096;
        const double sum = std::ldexp(double(high), 32) + low;
        ASSERT_EQ(redOf({low, high, 0, 0}, samples), static_cast<float>(std::ldexp(sum, -48) / samples))
            << low << ' ' << high << " / " << samples;
    }
}

TEST(FilmToImage, AlphaIsTheShareOfPathsThatMetSomething) {
    const Image image = filmToImage(onePixel({0, 0, 0, 3}, 4));
    ASSERT_EQ(image.channels, 4U);
    EXPECT_EQ(image.pixels[3], 0.75F);
    EXPECT_EQ(filmToImage(onePixel({0, 0, 0, 16777217}, 16777217)).pixels[3], 1.0F);
}

TEST(FilmToImage, NoSamplesIsBlackAndTransparent) {
    const Image image = filmToImage(onePixel({0, 0, 0, 0}, 0));
    EXPECT_EQ(image.pixels, (std::vector<float>{0, 0, 0, 0}));
}

TEST(AddFilm, CarriesThroughAllNinetySixBits) {
    Film a = onePixel({0xffffffffU, 0xffffffffU, 4, 5}, 2);
    Film b = onePixel({1, 0, 8, 6}, 2);
    b.ranges = {{2, 5}};
    b.refused = 3;
    addFilm(a, b);
    EXPECT_EQ(a.sums[0].red, uvec4(0, 0, 13, 11));
    EXPECT_EQ(a.ranges, (SampleRanges{{0, 5}}));
    EXPECT_EQ(a.refused, 3U);
}

TEST(AddFilm, OrderDoesNotMatter) {
    std::mt19937 generator(3);
    const auto random = [&] {
        Film film(4, 4);
        const auto channel = [&] { return uvec4(generator(), generator(), generator() >> 8U, generator() >> 8U); };
        for (FilmSums& sums : film.sums) sums = {channel(), channel(), channel()};
        return film;
    };
    Film parts[3] = {random(), random(), random()};
    for (std::uint32_t i = 0; i < 3; ++i) parts[i].ranges = {{10 * i, 10 * (i + 1)}};
    Film forward = parts[0], backward = parts[2];
    addFilm(forward, parts[1]);
    addFilm(forward, parts[2]);
    addFilm(backward, parts[1]);
    addFilm(backward, parts[0]);
    EXPECT_EQ(forward.ranges, backward.ranges);
    EXPECT_EQ(forward.ranges, (SampleRanges{{0, 30}}));
    for (std::size_t i = 0; i < 16; ++i) {
        EXPECT_EQ(forward.sums[i].red, backward.sums[i].red);
        EXPECT_EQ(forward.sums[i].green, backward.sums[i].green);
        EXPECT_EQ(forward.sums[i].blue, backward.sums[i].blue);
    }
}

TEST(AddFilm, RefusesOtherSizesLayersAndOverlaps) {
    Film a = onePixel({}, 4), overlap = onePixel({}, 8), large(2, 1), layered(1, 1, kAllAovs);
    EXPECT_THROW(addFilm(a, overlap), Error);
    EXPECT_THROW(addFilm(a, large), Error);
    EXPECT_THROW(addFilm(a, layered), Error);
}

TEST(AddFilm, RemembersGaps) {
    Film a = onePixel({1, 0, 0, 1}, 4), later = onePixel({2, 0, 0, 1}, 0);
    later.ranges = {{6, 7}};
    addFilm(a, later);
    EXPECT_EQ(a.ranges, (SampleRanges{{0, 4}, {6, 7}}));
    EXPECT_EQ(a.samples(), 5U);
    EXPECT_EQ(a.sums[0].red, uvec4(3, 0, 0, 2));
}

}  // namespace
}  // namespace vkpt
