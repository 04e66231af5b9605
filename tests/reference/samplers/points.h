// Point sets of samplers, and which boxes of the unit cube their points lie in.
#pragma once
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "reference/sampler.h"

namespace vkpt::reference::test {

/// Samples [begin, end) of `spp` in one dimension.
inline std::vector<std::uint32_t> coordinates(SamplerChoice sampler, std::uint32_t dim, std::uint32_t begin,
                                              std::uint32_t end, std::uint32_t spp, std::uint32_t seed,
                                              std::uint32_t pixel = 3 | 7U << 16U) {
    const SamplerBits bits = samplerBits(sampler);
    std::vector<std::uint32_t> values;
    for (std::uint32_t i = begin; i < end; ++i) values.push_back(bits({pixel, i, spp, seed}, dim));
    return values;
}

inline std::vector<std::uint32_t> coordinates(SamplerChoice sampler, std::uint32_t dim, std::uint32_t spp,
                                              std::uint32_t seed) {
    return coordinates(sampler, dim, 0, spp, spp, seed);
}

/// Which of n equal parts of [0,1) a fraction of 2^32 lies in. `nudge` 1: fractions were rounded down.
inline std::uint32_t part(std::uint32_t bits, std::uint64_t n, std::uint64_t nudge = 0) {
    return static_cast<std::uint32_t>((bits + nudge) * n >> 32U);
}

/// How many distinct cells of a columns x rows grid the points lie in.
inline std::size_t cellsHit(const std::vector<std::uint32_t>& x, const std::vector<std::uint32_t>& y,
                            std::uint64_t columns, std::uint64_t rows, std::uint64_t nudge = 0) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> cells;
    for (std::size_t i = 0; i < x.size(); ++i) cells.insert({part(x[i], columns, nudge), part(y[i], rows, nudge)});
    return cells.size();
}

/// How many of n equal parts the values lie in.
inline std::size_t partsHit(const std::vector<std::uint32_t>& x, std::uint64_t n, std::uint64_t nudge = 0) {
    return cellsHit(x, x, n, 1, nudge);
}

/// Whether points of any number of dimensions fill the boxes of a grid evenly: each holds as many.
inline bool fillEvenly(const std::vector<std::vector<std::uint32_t>>& points, const std::vector<std::uint64_t>& grid,
                       std::uint64_t nudge = 0) {
    std::map<std::vector<std::uint32_t>, std::size_t> counts;
    std::size_t boxes = 1;
    for (const std::uint64_t n : grid) boxes *= n;
    for (std::size_t i = 0; i < points[0].size(); ++i) {
        std::vector<std::uint32_t> box;
        for (std::size_t d = 0; d < grid.size(); ++d) box.push_back(part(points[d][i], grid[d], nudge));
        ++counts[box];
    }
    if (counts.size() != boxes) return false;
    for (const auto& [box, count] : counts)
        if (count != points[0].size() / boxes) return false;
    return true;
}

}  // namespace vkpt::reference::test
