// Walks an image in tiles on all cores.
#pragma once
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace vkpt {

/// A part of an image, in pixels.
struct Tile {
    std::uint32_t x, y, width, height;
};

/// Sums what `compute(Tile)` returns over the tiles of a width x height rectangle. Tiles run in parallel, their results
/// are added in a fixed order: the sum is the same every time.
template <class Compute>
double sumOverTiles(std::uint32_t width, std::uint32_t height, const Compute& compute) {
    constexpr std::uint32_t tileWidth = 256, tileHeight = 128;
    const std::uint32_t columns = (width + tileWidth - 1) / tileWidth, rows = (height + tileHeight - 1) / tileHeight;
    std::vector<double> results(std::size_t{columns} * rows);
    oneapi::tbb::parallel_for(std::size_t{0}, results.size(), [&](std::size_t i) {
        const auto x = static_cast<std::uint32_t>(i % columns) * tileWidth;
        const auto y = static_cast<std::uint32_t>(i / columns) * tileHeight;
        results[i] = compute(Tile{x, y, std::min(tileWidth, width - x), std::min(tileHeight, height - y)});
    });
    return std::accumulate(results.begin(), results.end(), 0.0);
}

}  // namespace vkpt
