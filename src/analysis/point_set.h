// Points of the unit cube, to be studied.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "scene/sampler_choice.h"

namespace vkpt {

/// N points of `dims` coordinates in [0,1), one after the other.
struct PointSet {
    std::size_t dims = 2;
    std::vector<double> values;

    [[nodiscard]] std::size_t size() const { return values.size() / dims; }
    [[nodiscard]] const double* point(std::size_t i) const { return values.data() + i * dims; }
    [[nodiscard]] double at(std::size_t i, std::size_t d) const { return values[i * dims + d]; }
};

/// The `count` samples of one pixel in the given dimensions, to the 32 bits the sampler makes. `pixel` is x | y << 16.
[[nodiscard]] PointSet samplePoints(SamplerChoice sampler, std::uint32_t count,
                                    const std::vector<std::uint32_t>& dimensions, std::uint32_t seed,
                                    std::uint32_t pixel = 0);

/// A maximal Poisson disk set on the unit torus, of about `count` points: no two nearer than a radius. [Bridson 07]
/// It is a set of the plane; it has no counterpart in the many dimensions of a path, hence no sampler.
[[nodiscard]] PointSet poissonDisk(std::uint32_t count, std::uint32_t seed);

/// The radius that poissonDisk keeps for `count` points.
[[nodiscard]] double poissonDiskRadius(std::uint32_t count);

}  // namespace vkpt
