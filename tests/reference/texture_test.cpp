// Wrapping, decoding, filtering and transforms of textures.
#include "reference/texture.h"

#include <gtest/gtest.h>

namespace vkpt::reference {
namespace {

/// 4 x 2 texels with red = 10 x column + 100 x row, alpha 128; one record.
SceneArrays fourByTwo(std::uint32_t flags) {
    SceneArrays scene;
    for (std::uint32_t y = 0; y < 2; ++y) {
        for (std::uint32_t x = 0; x < 4; ++x) scene.texels.push_back(128U << 24U | (10 * x + 100 * y));
    }
    TextureRecord record{};
    record.size = 4U | 2U << 16U;
    record.flags = flags;
    record.stride = 1;
    record.rowU = {1, 0, 0, 0};
    record.rowV = {0, 1, 0, 0};
    scene.textures.push_back(record);
    return scene;
}

float redAt(const SceneArrays& scene, float u, float v) { return sampleTexture(scene, 0, {{u, v}, {}}).r * 255; }

std::uint32_t wraps(std::uint32_t s, std::uint32_t t) { return s << kTextureWrapSShift | t << kTextureWrapTShift; }

TEST(WrapTexel, FollowsTheThreeModes) {
    const std::int64_t in[] = {-5, -4, -1, 0, 3, 4, 7, 8};
    const std::uint32_t repeat[] = {3, 0, 3, 0, 3, 0, 3, 0}, clamp[] = {0, 0, 0, 0, 3, 3, 3, 3},
                        mirror[] = {3, 3, 0, 0, 3, 3, 0, 0};
    for (std::size_t i = 0; i < std::size(in); ++i) {
        EXPECT_EQ(wrapTexel(in[i], 4, kWrapRepeat), repeat[i]) << in[i];
        EXPECT_EQ(wrapTexel(in[i], 4, kWrapClamp), clamp[i]) << in[i];
        EXPECT_EQ(wrapTexel(in[i], 4, kWrapMirror), mirror[i]) << in[i];
    }
    EXPECT_EQ(wrapTexel(-3, 1, kWrapMirror), 0U);
}

TEST(SampleTexture, ReadsTexelCentresExactly) {
    for (const std::uint32_t nearest : {0U, kTextureNearest}) {
        const SceneArrays scene = fourByTwo(nearest);
        EXPECT_FLOAT_EQ(redAt(scene, 0.125F, 0.25F), 0);
        EXPECT_FLOAT_EQ(redAt(scene, 0.625F, 0.75F), 120);
        EXPECT_FLOAT_EQ(sampleTexture(scene, 0, {{0.4F, 0.3F}, {}}).a, 128.0F / 255);
    }
}

TEST(SampleTexture, InterpolatesBetweenCentresAndAcrossTheSeam) {
    const SceneArrays repeat = fourByTwo(0);
    EXPECT_NEAR(redAt(repeat, 0.25F, 0.25F), 5, 1e-4);
    EXPECT_NEAR(redAt(repeat, 0.125F, 0.5F), 50, 1e-4);
    EXPECT_NEAR(redAt(repeat, 0.3125F, 0.375F), 7.5 + 25, 1e-4);
    EXPECT_NEAR(redAt(repeat, 0.0F, 0.25F), 15, 1e-4);  // between columns 3 and 0
    const SceneArrays clamped = fourByTwo(wraps(kWrapClamp, kWrapClamp));
    EXPECT_NEAR(redAt(clamped, 0.0F, 0.25F), 0, 1e-4);
    EXPECT_NEAR(redAt(clamped, 5.0F, -3.0F), 30, 1e-4);
    const SceneArrays mirrored = fourByTwo(wraps(kWrapMirror, kWrapRepeat));
    EXPECT_NEAR(redAt(mirrored, 1.125F, 0.25F), 30, 1e-4);
    EXPECT_NEAR(redAt(mirrored, -0.375F, 0.25F), 10, 1e-4);
}

TEST(SampleTexture, NearestTakesTheTexelThatHoldsThePoint) {
    const SceneArrays scene = fourByTwo(kTextureNearest);
    EXPECT_FLOAT_EQ(redAt(scene, 0.2499F, 0.25F), 0);
    EXPECT_FLOAT_EQ(redAt(scene, 0.25F, 0.25F), 10);
    EXPECT_FLOAT_EQ(redAt(scene, -0.001F, 0.25F), 30);
}

TEST(SampleTexture, DecodesSrgbBeforeFilteringButNotAlpha) {
    SceneArrays scene = fourByTwo(kTextureSrgb);
    const float mean = (decodeSrgb(0) + decodeSrgb(10)) / 2;
    EXPECT_NEAR(redAt(scene, 0.25F, 0.25F) / 255, mean, 1e-6);
    EXPECT_FLOAT_EQ(sampleTexture(scene, 0, {{0.25F, 0.25F}, {}}).a, 128.0F / 255);
}

TEST(DecodeSrgb, EqualsTheStandard) {
    EXPECT_EQ(decodeSrgb(0), 0.0F);
    EXPECT_FLOAT_EQ(decodeSrgb(255), 1.0F);
    EXPECT_NEAR(decodeSrgb(10), 10 / 255.0 / 12.92, 1e-8);  // linear piece
    EXPECT_NEAR(decodeSrgb(128), 0.2158605001, 1e-7);
}

TEST(SampleTexture, AppliesTheTransformToItsOwnUvSet) {
    SceneArrays scene = fourByTwo(kTextureUv1 | kTextureNearest);
    scene.textures[0].rowU = {0, 1, 0.25F, 0};  // u' = v + 1/4
    scene.textures[0].rowV = {0.5F, 0, 0, 0};   // v' = u / 2
    const TexCoords coords{{0.9F, 0.9F}, {1.2F, 0.3F}};
    EXPECT_FLOAT_EQ(sampleTexture(scene, 0, coords).r * 255, 120);
}

TEST(SampleTexture, SurvivesAbsurdCoordinates) {
    const SceneArrays scene = fourByTwo(0);
    for (const float u : {1e30F, -1e30F, INFINITY, NAN}) {
        const float red = sampleTexture(scene, 0, {{u, 0.25F}, {}}).a;
        EXPECT_TRUE(std::isnan(red) || red > 0);
    }
}

}  // namespace
}  // namespace vkpt::reference
