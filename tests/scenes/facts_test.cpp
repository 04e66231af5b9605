// Every fact of every expect.json on both backends; and that facts can fail.
#include "facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene_files.h"

namespace vkpt {
namespace {

constexpr std::uint32_t kReferenceSeeds = 8;
constexpr std::uint32_t kDeviceSeeds = 2, kDeviceTimes = 4;

class Facts : public testing::TestWithParam<std::string> {};

/// The noise of one render is taken from the reference's seeds; the device estimates the same integrals with the same
/// samples (parity_test.cpp), so that few of its renders do. Four times the samples have half the noise at most.
TEST_P(Facts, HoldOnBothBackends) {
    const Json expect = expectations(GetParam());
    for (const Json& render : expect.at("renders")) {
        const PreparedScene prepared = prepare(GetParam(), render.at("options").get<std::vector<std::string>>());
        std::vector<Image> reference, device;
        for (std::uint32_t seed = 0; seed < kReferenceSeeds; ++seed)
            reference.push_back(renderSeed(prepared, Backend::Cpu, seed));
        for (std::uint32_t seed = 0; seed < kDeviceSeeds; ++seed)
            device.push_back(renderSeed(prepared, Backend::Vulkan, 100 + seed, kDeviceTimes));
        for (const Json& fact : render.at("facts")) {
            const auto spread = spreadOf(fact, reference);
            auto half = spread;
            for (double& s : half) s /= std::sqrt(kDeviceTimes);
            const auto where = [&](const char* backend) {
                return fmt::format("{}, {}: {} {}: {}", backend, render.at("name").get<std::string>(),
                                   fact.at("type").get<std::string>(), fact.contains("rect") ? fact["rect"].dump() : "",
                                   fact.at("why").get<std::string>());
            };
            EXPECT_TRUE(holds(fact, reference, spread)) << where("cpu");
            EXPECT_TRUE(holds(fact, device, half)) << where("vulkan");
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Facts, testing::ValuesIn(sceneNames()), [](const auto& test) { return test.param; });

Image uniform(float value) {
    Image image(16, 8, 4);
    std::fill(image.pixels.begin(), image.pixels.end(), value);
    return image;
}

/// Judges one fact on images of even grey, whose spread is that of the values.
testing::AssertionResult judge(const char* fact, const std::vector<float>& greys) {
    std::vector<Image> images;
    for (const float grey : greys) images.push_back(uniform(grey));
    const Json json = Json::parse(fact);
    return holds(json, images, spreadOf(json, images));
}

TEST(FactTypes, RegionMeanRejectsAWrongMeanAndTooMuchNoise) {
    const char* fact = R"({"type": "region_mean", "rect": [0, 0.5, 0, 1], "value": [1, 1, 1], "tolerance": 0.005})";
    EXPECT_TRUE(judge(fact, {1.004F, 1.004F}));
    EXPECT_FALSE(judge(fact, {1.006F, 1.006F}));
    EXPECT_TRUE(judge(fact, {0.99F, 1.01F, 0.99F, 1.01F, 1.0F, 1.0F, 1.0F, 1.0F}));
    EXPECT_FALSE(judge(fact, {0.7F, 1.3F, 0.7F, 1.3F, 1.0F, 1.0F, 1.0F, 1.0F}));
}

TEST(FactTypes, AlphaMeanReadsTheFourthChannel) {
    EXPECT_TRUE(
        judge(R"({"type": "alpha_mean", "rect": [0, 1, 0, 1], "value": 0.75, "tolerance": 1e-4})", {0.75F, 0.75F}));
    EXPECT_FALSE(
        judge(R"({"type": "alpha_mean", "rect": [0, 1, 0, 1], "value": 0.5, "tolerance": 1e-4})", {0.75F, 0.75F}));
}

TEST(FactTypes, BoundsLookAtEveryPixel) {
    Image image = uniform(0.5F);
    image.at(7, 3)[1] = 2;
    const std::vector<Image> images{image, image};
    const auto check = [&](const char* fact) {
        const Json json = Json::parse(fact);
        return holds(json, images, spreadOf(json, images));
    };
    EXPECT_FALSE(check(R"({"type": "max_below", "rect": [0, 1, 0, 1], "value": 1})"));
    EXPECT_TRUE(check(R"({"type": "max_below", "rect": [0.5, 1, 0, 1], "value": 1})"));
    EXPECT_TRUE(check(R"({"type": "min_above", "rect": [0, 1, 0, 1], "value": 0.4})"));
    EXPECT_FALSE(check(R"({"type": "min_above", "rect": [0, 1, 0, 1], "value": 0.6})"));
    EXPECT_FALSE(check(R"({"type": "region_uniform", "rect": [0, 1, 0, 1], "tolerance": 0.1})"));
    EXPECT_TRUE(check(R"({"type": "region_uniform", "rect": [0.5, 1, 0, 1], "tolerance": 0.1})"));
    EXPECT_FALSE(check(R"({"type": "mirror_symmetry", "axis": "x", "tiles": [4, 2], "tolerance": 0.01})"));
    EXPECT_FALSE(check(R"({"type": "increasing", "rects": [[0, 0.5, 0, 1], [0.5, 1, 0, 1]]})"));
    EXPECT_TRUE(check(R"({"type": "increasing", "rects": [[0.5, 1, 0, 1], [0, 0.5, 0, 1]]})"));
}

TEST(FactTypes, UnknownOnesAreNotPassedOver) {
    EXPECT_THROW((void)judge(R"({"type": "pretty", "rect": [0, 1, 0, 1]})", {1, 1}), std::invalid_argument);
    EXPECT_THROW((void)judge(R"({"type": "max_below", "rect": [0, 0.01, 0, 1], "value": 1})", {1, 1}),
                 std::invalid_argument);
}

}  // namespace
}  // namespace vkpt
