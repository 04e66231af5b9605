// The exact film: integer sums of path contributions and layers, and how those of disjoint samples add up.
#pragma once
#include <cstdint>
#include <vector>

#include "base/image.h"
#include "film/film_layout.h"
#include "layout.h"
#include "scene/sample_ranges.h"

namespace vkpt {

/// Sums over the samples of `ranges` of every pixel, in two's complement; row 0 at the top.
/// Integer sums are associative: films of disjoint ranges of one render add up bit for bit in any order.
struct Film {
    std::uint32_t width = 0, height = 0;
    SampleRanges ranges;
    std::vector<FilmSums> sums;         ///< width x height
    FilmLayout layout;                  ///< of `layers`
    std::vector<uvec4> layers;          ///< width x height x layout.words(), pixel by pixel
    std::uint64_t refused = 0;          ///< contributions that were NaN, infinite, out of range or wrongly below 0
    std::uint64_t refusedInLayers = 0;  ///< values of layers that were NaN, infinite or out of range

    Film() = default;
    /// A film of no samples, all zero.
    Film(std::uint32_t filmWidth, std::uint32_t filmHeight, AovSet aovs = {}, LightLayers light = {});

    [[nodiscard]] std::uint32_t samples() const { return countSamples(ranges); }
    [[nodiscard]] std::uint32_t sampleBegin() const { return ranges.empty() ? 0 : ranges.front().begin; }
    [[nodiscard]] std::uint32_t sampleEnd() const { return ranges.empty() ? 0 : ranges.back().end; }
};

/// Adds `other`, of samples that `into` does not hold, exactly. Order does not matter.
/// Throws Error: SizeMismatch where the frames differ, Usage where samples overlap or layers differ.
void addFilm(Film& into, const Film& other);

/// Mean radiance, below 0 where a pixel filter makes it so, and alpha: RGBA, linear, premultiplied. Each value is the
/// exact quotient of integers, rounded once; a film without samples is black and transparent.
[[nodiscard]] Image filmToImage(const Film& film);

}  // namespace vkpt
