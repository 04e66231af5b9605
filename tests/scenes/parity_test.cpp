// The two renderers take the same decisions: at one sample a pixel they agree but for few pixels, and without bias.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "registry.h"
#include "scene_files.h"

namespace vkpt {
namespace {

constexpr double kRelative = 1e-3;  ///< a pixel that is off by more has parted
constexpr double kRounding = 1e-5;  ///< of the mean: what rounding alone may shift
constexpr std::uint32_t kSeeds = 1;

struct Differences {
    std::size_t pixels = 0, parted = 0;
    double sum[3] = {}, squares[3] = {}, reference[3] = {};

    void add(const Image& device, const Image& cpu) {
        for (std::uint32_t y = 0; y < cpu.height; ++y)
            for (std::uint32_t x = 0; x < cpu.width; ++x) {
                bool off = false;
                for (int c = 0; c < 3; ++c) {
                    const double a = double{device.at(x, y)[c]}, b = double{cpu.at(x, y)[c]};
                    off |= !(std::abs(a - b) <= kRelative * std::max(std::abs(a), std::abs(b)));
                    sum[c] += a - b;
                    squares[c] += (a - b) * (a - b);
                    reference[c] += b;
                }
                parted += off ? 1 : 0;
                ++pixels;
            }
    }
    [[nodiscard]] double share() const { return static_cast<double>(parted) / static_cast<double>(pixels); }
};

using Case = std::tuple<std::string, std::string>;  // scene, sampler
std::vector<std::string> samplerNames() {
    std::vector<std::string> names;
    for (const SamplerInfo& sampler : kSamplers) names.emplace_back(sampler.name);
    return names;
}

class Parity : public testing::TestWithParam<Case> {};

TEST_P(Parity, FewPixelsPartAndTheMeanDoesNot) {
    const auto& [scene, sampler] = GetParam();
    const Json parity = expectations(scene).at("parity");
    auto options = parity.at("options").get<std::vector<std::string>>();
    for (const char* more : {"--size", "128x96", "--spp", "1", "--sampler"}) options.emplace_back(more);
    options.push_back(sampler);
    const PreparedScene prepared = prepare(scene, options);

    Differences d;
    for (std::uint32_t seed = 0; seed < kSeeds; ++seed)
        d.add(renderSeed(prepared, Backend::Vulkan, seed), renderSeed(prepared, Backend::Cpu, seed));

    const double limit = parity.at("kind") == "diffuse" ? 0.001 : 0.01;
    fmt::print("{}, {}: {:.3f} % of {} pixels parted (limit {} %)\n", scene, sampler, 100 * d.share(), d.pixels,
               100 * limit);
    EXPECT_LE(d.share(), limit);
    const auto n = static_cast<double>(d.pixels);
    for (int c = 0; c < 3; ++c) {
        const double mean = d.sum[c] / n;
        const double error = std::sqrt(std::max(0.0, d.squares[c] / n - mean * mean) / n);
        EXPECT_GT(d.reference[c], 0) << "the image is black: nothing is compared";
        EXPECT_LE(std::abs(mean), 3 * error + kRounding * d.reference[c] / n) << "channel " << c;
    }
}

INSTANTIATE_TEST_SUITE_P(EverySceneAndSampler, Parity,
                         testing::Combine(testing::ValuesIn(sceneNames()), testing::ValuesIn(samplerNames())),
                         [](const auto& test) { return std::get<0>(test.param) + "_" + std::get<1>(test.param); });

}  // namespace
}  // namespace vkpt
