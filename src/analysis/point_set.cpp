#include "analysis/point_set.h"

#include "reference/sampler.h"

namespace vkpt {

PointSet samplePoints(SamplerChoice sampler, std::uint32_t count, const std::vector<std::uint32_t>& dimensions,
                      std::uint32_t seed, std::uint32_t pixel) {
    const auto bits = reference::samplerBits(sampler);
    PointSet points{dimensions.size(), {}};
    points.values.reserve(points.dims * count);
    for (std::uint32_t i = 0; i < count; ++i)
        for (const std::uint32_t dim : dimensions)
            points.values.push_back(bits({pixel, i, count, seed}, dim) * 0x1p-32);
    return points;
}

}  // namespace vkpt
