// Written once: a new line of registry.def is covered with no edit here.
#include "reference/sampler.h"
#include "wavefront/probe_scene.h"

namespace vkpt {
namespace {

using EverySampler = GpuTest;

struct In {
    reference::SampleId id;
    glm::uvec4 dim;
};
struct Out {
    std::uint32_t bits;
    float unit;
    glm::uvec2 unused;
};

/// Pixels, indices, dimensions and seeds at the ends and in the middle of their ranges; dimensions go beyond those
/// that a table of direction numbers or of primes holds.
std::vector<In> sampleGrid() {
    std::vector<In> grid;
    for (const std::uint32_t pixel : {0U, 1U, 7U, 1U << 16U, 31U | 17U << 16U, 0xffffU, 0xffffffffU})
        for (const std::uint32_t index : {0U, 1U, 2U, 3U, 13U, 64U, 1023U, 1024U, 65535U, 0x12345678U, 0xffffffffU})
            for (const std::uint32_t dim :
                 {0U, 1U, 2U, 7U, 8U, 9U, 24U, 130U, 1000U, 3665U, 3666U, 3667U, 3668U, 7333U, 7334U, 65544U})
                for (const std::uint32_t seed : {0U, 1U, 42U, 0xffffffffU})
                    grid.push_back({{pixel, index, 1024, seed}, {dim, 0, 0, 0}});
    for (std::uint32_t index = 0; index < 64; ++index)
        for (std::uint32_t dim = 0; dim < 40; ++dim) grid.push_back({{5U | 9U << 16U, index, 64, 3}, {dim, 0, 0, 0}});
    return grid;
}

TEST_F(EverySampler, ShaderBitsEqualReferenceBits) {
    const std::vector<In> grid = sampleGrid();
    const ProbeScene scene{SceneArrays{}};
    for (const SamplerInfo& sampler : kSamplers) {
        SCOPED_TRACE(sampler.name);
        const auto bits = reference::samplerBits(sampler.id);
        const auto out = scene.evaluate<Out>("samplers", grid, sampler.id);
        for (std::size_t i = 0; i < grid.size(); ++i) {
            const std::uint32_t expected = bits(grid[i].id, grid[i].dim.x);
            ASSERT_EQ(out[i].bits, expected) << "pixel " << grid[i].id.pixel << " index " << grid[i].id.index
                                             << " seed " << grid[i].id.seed << " dimension " << grid[i].dim.x;
            ASSERT_EQ(out[i].unit, reference::toUnit(expected));
        }
    }
}

}  // namespace
}  // namespace vkpt
