// Written once: a new line of registry.def is covered with no edit here.
#include <fmt/format.h>

#include "reference/sampler.h"
#include "verify/context.h"
#include "verify/probes.h"

namespace vkpt {
namespace {

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
    for (const std::uint32_t spp : {1U, 2U, 3U, 5U, 8U, 48U, 97U, 2048U, 63001U, 65535U, 65536U, 100000U, 1U << 31U})
        for (const std::uint32_t index : {0U, 1U, 4U, 40U, 2047U, 70000U, 0x7fffffffU})
            for (const std::uint32_t dim : {0U, 1U, 2U, 3U, 10U, 11U, 30U, 143U})
                grid.push_back({{11U | 300U << 16U, index, spp, 8}, {dim, 0, 0, 0}});
    for (std::uint32_t index = 0; index < 64; ++index)
        for (std::uint32_t dim = 0; dim < 40; ++dim) grid.push_back({{5U | 9U << 16U, index, 64, 3}, {dim, 0, 0, 0}});
    return grid;
}

/// Those of sampleGrid's inputs whose index is `lastIndex` at most.
std::vector<In> sampleGridUpTo(std::uint32_t lastIndex) {
    std::vector<In> grid = sampleGrid();
    std::erase_if(grid, [&](const In& in) { return in.id.index > lastIndex; });
    return grid;
}

/// Bits of kernels made for the indices up to `lastIndex`, which may leave out the digits that none of them has.
void checkSampler(VerifyContext& context, Findings& findings, SamplerChoice sampler, std::uint32_t lastIndex) {
    const std::vector<In> grid = sampleGridUpTo(lastIndex);
    const auto scope = findings.inputs([&](std::size_t i) {
        const auto& [id, dim] = grid[i];
        return fmt::format(
            "{}, scramble {}, made for indices up to {}: pixel {}, index {} of {}, seed {}, dimension {}",
            samplerName(sampler.id), scrambleName(sampler.scramble), lastIndex, id.pixel, id.index, id.spp, id.seed,
            dim.x);
    });
    const auto bits = reference::samplerBits(sampler);
    const ProbeScene scene(context.prober(), SceneArrays{}, {}, sampler, lastIndex);
    const auto out = scene.evaluate<Out>(findings, "samplers", grid);
    for (std::size_t i = 0; i < grid.size(); ++i) {
        findings.at(i);
        const std::uint32_t expected = bits(grid[i].id, grid[i].dim.x);
        findings.equal(samplerName(sampler.id), out[i].bits, expected);
        findings.equal("toUnit", out[i].unit, reference::toUnit(expected));
    }
}

}  // namespace

void checkSamplers(VerifyContext& context, Findings& findings) {
    for (const SamplerChoice& sampler : allSamplerChoices()) {
        checkSampler(context, findings, sampler, ~0U);
        if (sampler.scramble != ScrambleId::None) checkSampler(context, findings, sampler, 64);
    }
}

}  // namespace vkpt
