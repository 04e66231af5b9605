#include "film/film.h"

#include <fmt/format.h>

#include <cassert>

#include "base/error.h"
#include "film/exact_ratio.h"

namespace vkpt {
namespace {

std::size_t pixelCount(const Film& film) { return std::size_t{film.width} * film.height; }

/// Adds the three low words with carry; w is a plain count of its own.
void addSum(uvec4& into, const uvec4& other) {
    const U128 sum = sumOf(into) + sumOf(other);
    into = uvec4(static_cast<std::uint32_t>(sum), static_cast<std::uint32_t>(sum >> 32U),
                 static_cast<std::uint32_t>(sum >> 64U), into.w + other.w);
}

void addWideSum(uvec4& into, const uvec4& other) {
    const U128 sum = wideSumOf(into) + wideSumOf(other);
    into = uvec4(static_cast<std::uint32_t>(sum), static_cast<std::uint32_t>(sum >> 32U),
                 static_cast<std::uint32_t>(sum >> 64U), static_cast<std::uint32_t>(sum >> 96U));
}

/// `word` counts from the first word of a pixel's layers. `otherIsFirst`: it holds the lowest sample index.
void addWord(Film& into, const Film& other, std::uint32_t word, WordRule rule, bool otherIsFirst) {
    const std::size_t stride = into.layout.words();
    for (std::size_t i = word; i < into.layers.size(); i += stride) {
        if (rule == WordRule::Sum) addSum(into.layers[i], other.layers[i]);
        if (rule == WordRule::WideSum) addWideSum(into.layers[i], other.layers[i]);
        if (rule == WordRule::First && otherIsFirst) into.layers[i] = other.layers[i];
    }
}

void check(const Film& into, const Film& other) {
    if (into.width != other.width || into.height != other.height)
        throw Error(ExitCode::SizeMismatch, fmt::format("films of {}x{} and {}x{} cannot be added", into.width,
                                                        into.height, other.width, other.height));
    if (const auto both = overlapOf(into.ranges, other.ranges))
        throw Error(ExitCode::Usage, fmt::format("both films hold samples {}:{}", both->begin, both->end));
    if (into.layout.aovs() != other.layout.aovs() || into.layout.light() != other.layout.light())
        throw Error(ExitCode::Usage, "the films have other layers");
}

}  // namespace

Film::Film(std::uint32_t filmWidth, std::uint32_t filmHeight, AovSet aovs, LightLayers light)
    : width(filmWidth), height(filmHeight), layout(aovs, std::move(light)) {
    sums.resize(pixelCount(*this));
    layers.resize(pixelCount(*this) * layout.words());
}

void addFilm(Film& into, const Film& other) {
    check(into, other);
    for (std::size_t i = 0; i < into.sums.size(); ++i) {
        addSum(into.sums[i].red, other.sums[i].red);
        addSum(into.sums[i].green, other.sums[i].green);
        addSum(into.sums[i].blue, other.sums[i].blue);
    }
    const bool otherIsFirst =
        !other.ranges.empty() && (into.ranges.empty() || other.sampleBegin() < into.sampleBegin());
    for (const FilmBlock& block : into.layout.blocks())
        for (std::uint32_t w = 0; w < block.words.size(); ++w)
            addWord(into, other, block.firstWord + w, block.words[w].rule, otherIsFirst);
    into.ranges = unite(into.ranges, other.ranges);
    into.refused += other.refused;
    into.refusedInLayers += other.refusedInLayers;
}

Image filmToImage(const Film& film) {
    assert(film.sums.size() == pixelCount(film));
    Image image(film.width, film.height, 4);
    const std::uint32_t samples = film.samples();
    if (samples == 0) return image;
    float* pixel = image.pixels.data();
    for (const FilmSums& sums : film.sums) {
        pixel[0] = exactRatio(signedSumOf(sums.red), samples, kFilmFractionBits);
        pixel[1] = exactRatio(signedSumOf(sums.green), samples, kFilmFractionBits);
        pixel[2] = exactRatio(signedSumOf(sums.blue), samples, kFilmFractionBits);
        pixel[3] = exactRatio(sums.red.w, samples, 0);
        pixel += 4;
    }
    return image;
}

}  // namespace vkpt
