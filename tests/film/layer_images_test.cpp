// From the integers of a film's layers to the values of a file.
#include "film/layer_images.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "film/wide_integer.h"

namespace vkpt {
namespace {

Film onePixel(const char* aovs, std::uint32_t samples) {
    Film film(1, 1, *parseAovs(aovs));
    film.ranges = {{0, samples}};
    return film;
}

uvec4 word(U128 value, std::uint32_t w = 0) {
    return {static_cast<std::uint32_t>(value), static_cast<std::uint32_t>(value >> 32U),
            static_cast<std::uint32_t>(value >> 64U), w};
}

/// value x 2^48 in two's complement; `value` times 2^48 must be whole.
uvec4 signedWord(double value) {
    const U128 magnitude = static_cast<U128>(std::abs(value) * 0x1p48);
    return word(value < 0 ? -magnitude & ((U128{1} << 96U) - 1) : magnitude);
}

TEST(LayerImages, MeansOfSignedSums) {
    Film film = onePixel("position", 5);
    film.sums[0].green.w = 4;
    film.layers = {signedWord(-6), signedWord(0x1p-47), signedWord(-0x1p33 - 0x1p-48)};
    const Image image = layerImages(film).front().image;
    EXPECT_EQ(image.pixels[0], -1.5F);
    EXPECT_EQ(image.pixels[1], 0x1p-49F);
    EXPECT_EQ(image.pixels[2], -0x1p31F);
}

// Sums of two's complement carry through zero: -a + b is b - a.
TEST(LayerImages, SignsCancelExactly) {
    std::mt19937 random(11);
    for (int i = 0; i < 500; ++i) {
        const double a = std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 40) - 60),
                     b = std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 40) - 60);
        Film negative = onePixel("depth", 2), positive = onePixel("depth", 2);
        positive.ranges = {{2, 4}};
        negative.sums[0].green.w = positive.sums[0].green.w = 1;
        negative.layers = {signedWord(-std::floor(a * 0x1p48) * 0x1p-48)};
        positive.layers = {signedWord(std::floor(b * 0x1p48) * 0x1p-48)};
        addFilm(negative, positive);
        const double expected = (std::floor(b * 0x1p48) - std::floor(a * 0x1p48)) * 0x1p-48 / 2;
        ASSERT_EQ(layerImages(negative).front().image.pixels[0], static_cast<float>(expected)) << a << ' ' << b;
    }
}

TEST(LayerImages, VarianceOfKnownLuminances) {
    // 1, 2, 3 and 10: variance 50 / 3.
    Film film = onePixel("variance", 4);
    const auto square = [](double l) { return static_cast<U128>(l * l) << 48U; };
    const U128 squares = square(1) + square(2) + square(3) + square(10);
    film.layers = {word(U128{16} << 24U), word(squares)};
    film.layers[1].w = static_cast<std::uint32_t>(squares >> 96U);
    EXPECT_FLOAT_EQ(layerImages(film).front().image.pixels[0], 50.0F / 3);
}

TEST(LayerImages, VarianceOfEqualPathsIsZeroHoweverBright) {
    const std::uint64_t luminance = (std::uint64_t{1} << 56U) - 1;  // just below 2^32 nits
    const std::uint32_t n = 65535;
    Film film = onePixel("variance", n);
    const U128 squares = U128{luminance} * luminance * n;
    film.layers = {word(U128{luminance} * n), word(squares)};
    film.layers[1].w = static_cast<std::uint32_t>(squares >> 96U);
    EXPECT_EQ(layerImages(film).front().image.pixels[0], 0);
}

TEST(LayerImages, PathsLeftOutDoNotCountInTheVariance) {
    Film film = onePixel("variance", 5);
    const U128 squares = U128{1 + 9} << 48U;  // 1 and 3: variance 2
    film.layers = {word(U128{4} << 24U, 3), word(squares)};
    EXPECT_FLOAT_EQ(layerImages(film).front().image.pixels[0], 2);
    EXPECT_EQ(pathsWithoutVariance(film), 3U);
    film.layers[0].w = 4;  // one path alone has none
    EXPECT_EQ(layerImages(film).front().image.pixels[0], 0);
}

TEST(LayerImages, NoSamplesAreZero) {
    Film film(2, 1, kAllAovs);
    for (const LayerImage& layer : layerImages(film))
        for (const float value : layer.image.pixels) EXPECT_EQ(value, 0) << layer.aov.name;
}

TEST(AddFilmLayers, IdsAreThoseOfTheLowestSampleInEitherOrder) {
    Film low = onePixel("primitive", 2), high = onePixel("primitive", 2);
    low.ranges = {{4, 6}};
    high.ranges = {{8, 9}};
    low.layers = {uvec4(1, 2, 3, 1)};
    high.layers = {uvec4(7, 8, 9, 1)};
    Film a = low, b = high, none(1, 1, low.layout.aovs());
    addFilm(a, high);
    addFilm(b, low);
    addFilm(none, high);
    EXPECT_EQ(a.layers[0], low.layers[0]);
    EXPECT_EQ(b.layers[0], low.layers[0]);
    EXPECT_EQ(none.layers[0], high.layers[0]);
}

TEST(AddFilmLayers, SquaresCarryThroughAllWords) {
    Film a = onePixel("variance", 1), b = onePixel("variance", 1);
    b.ranges = {{1, 2}};
    a.layers = {uvec4(0xffffffffU, 0xffffffffU, 0, 2), uvec4(0xffffffffU, 0xffffffffU, 0xffffffffU, 4)};
    b.layers = {uvec4(1, 0, 0, 3), uvec4(1, 0, 0, 5)};
    addFilm(a, b);
    EXPECT_EQ(a.layers[0], uvec4(0, 0, 1, 5));
    EXPECT_EQ(a.layers[1], uvec4(0, 0, 0, 10));
}

}  // namespace
}  // namespace vkpt
