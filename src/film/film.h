// The exact film: integer sums of path contributions, and the one place where they become floats.
#pragma once
#include <cstdint>
#include <vector>

#include "base/image.h"
#include "layout.h"

namespace vkpt {

/// Sums over samples [sampleBegin, sampleEnd) of every pixel; row 0 at the top.
/// Integer sums are associative: films of disjoint ranges of one render add up bit for bit in any order.
struct Film {
    std::uint32_t width = 0, height = 0;
    std::uint32_t sampleBegin = 0, sampleEnd = 0;
    std::vector<FilmSums> sums;  ///< width x height
    std::uint64_t refused = 0;   ///< contributions that were NaN, infinite, negative or out of range

    [[nodiscard]] std::uint32_t samples() const { return sampleEnd - sampleBegin; }
};

/// Mean radiance and alpha: RGBA, linear, premultiplied. Each value is the exact quotient of integers, rounded
/// once; a film without samples is black and transparent.
[[nodiscard]] Image filmToImage(const Film& film);

/// Adds `other`, whose sample range must adjoin that of `into`, exactly. Order does not matter.
/// Throws Error: SizeMismatch where the frames differ, Usage where the ranges overlap or leave a gap.
void addFilm(Film& into, const Film& other);

}  // namespace vkpt
