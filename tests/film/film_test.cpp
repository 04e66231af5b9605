#include "film/film.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/error.h"

namespace vkpt {
namespace {

Film onePixel(uvec4 red, std::uint32_t samples) {
    Film film{1, 1, 0, samples, {}, 0};
    film.sums.push_back({red, uvec4(0), uvec4(0)});
    return film;
}

float redOf(uvec4 red, std::uint32_t samples) { return filmToImage(onePixel(red, samples)).pixels[0]; }

TEST(FilmToImage, FractionBitsAreFortyEight) {
    EXPECT_EQ(redOf({0, 1U << 16U, 0, 0}, 1), 1.0F);
    EXPECT_EQ(redOf({0, 0, 1, 0}, 1), 65536.0F);
    EXPECT_EQ(redOf({1, 0, 0, 0}, 1), std::ldexp(1.0F, -48));
    EXPECT_EQ(redOf({0, 0, 0x80000000U, 0}, 1), std::ldexp(1.0F, 47));
    EXPECT_EQ(redOf({0, 0, 0, 0}, 7), 0.0F);
    EXPECT_EQ(redOf({1, 0, 0, 0}, 0xffffffffU), static_cast<float>(std::ldexp(1.0, -48) / 4294967295.0));
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
    b.sampleBegin = 2;
    b.sampleEnd = 5;
    b.refused = 3;
    addFilm(a, b);
    EXPECT_EQ(a.sums[0].red, uvec4(0, 0, 13, 11));
    EXPECT_EQ(a.sampleBegin, 0U);
    EXPECT_EQ(a.sampleEnd, 5U);
    EXPECT_EQ(a.refused, 3U);
}

TEST(AddFilm, OrderDoesNotMatter) {
    std::mt19937 generator(3);
    const auto random = [&] {
        Film film{4, 4, 0, 0, {}, 0};
        for (int i = 0; i < 16; ++i) {
            const auto channel = [&] { return uvec4(generator(), generator(), generator() >> 8U, generator() >> 8U); };
            film.sums.push_back({channel(), channel(), channel()});
        }
        return film;
    };
    Film parts[3] = {random(), random(), random()};
    for (std::uint32_t i = 0; i < 3; ++i) parts[i].sampleBegin = 10 * i, parts[i].sampleEnd = 10 * (i + 1);
    Film forward = parts[0], backward = parts[2];
    addFilm(forward, parts[1]);
    addFilm(forward, parts[2]);
    addFilm(backward, parts[1]);
    addFilm(backward, parts[0]);
    EXPECT_EQ(forward.sampleBegin, backward.sampleBegin);
    EXPECT_EQ(forward.sampleEnd, 30U);
    for (std::size_t i = 0; i < 16; ++i) {
        EXPECT_EQ(forward.sums[i].red, backward.sums[i].red);
        EXPECT_EQ(forward.sums[i].green, backward.sums[i].green);
        EXPECT_EQ(forward.sums[i].blue, backward.sums[i].blue);
    }
}

TEST(AddFilm, RefusesOtherSizesGapsAndOverlaps) {
    Film a = onePixel({}, 4), gap = onePixel({}, 0), overlap = onePixel({}, 8), large{2, 1, 4, 8, {}, 0};
    gap.sampleBegin = 5, gap.sampleEnd = 6;
    EXPECT_THROW(addFilm(a, gap), Error);
    EXPECT_THROW(addFilm(a, overlap), Error);
    EXPECT_THROW(addFilm(a, large), Error);
}

}  // namespace
}  // namespace vkpt
