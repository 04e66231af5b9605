#include "scene/flatten_lights.h"

#include <gtest/gtest.h>

#include <numeric>

#include "base/math.h"
#include "scene/environment.h"
#include "scene/sampling_table.h"
#include "scene/texture_light.h"
#include "scene_builder.h"

namespace vkpt {
namespace {

Scene lamp() {
    Scene scene = sceneOf(trianglePrimitive(), {glm::scale(glm::mat4(1), {2, 3, 1})});  // area 3
    scene.materials[0].emissive = glm::vec3(10);
    return scene;
}

TEST(Lights, AnEmissiveTriangleIsALightThatKnowsItsTriangle) {
    const SceneArrays a = flatten(lamp());
    ASSERT_EQ(a.lights.size(), 1U);
    const LightRecord& light = a.lights[0];
    EXPECT_EQ(light.kind, kLightTriangle);
    EXPECT_EQ(light.a, a.triangles[0].v0);
    EXPECT_EQ(light.b, a.triangles[0].v1);
    EXPECT_EQ(light.c, a.triangles[0].v2);
    EXPECT_EQ(light.color, glm::vec3(10));
    EXPECT_EQ(light.offset, kOffsetScale * 3);
    EXPECT_EQ(light.index, 0U);
    EXPECT_EQ(light.pmf, 1);
    EXPECT_EQ(a.triangles[0].light, 0U);
    EXPECT_FLOAT_EQ(a.lightPower[0], kPi * 3 * 10);
    EXPECT_TRUE(a.features.triangleLights);
    EXPECT_FALSE(a.features.texturedEmission);
}

TEST(Lights, TwoSidedOnesHaveTwiceThePower) {
    Scene scene = lamp();
    scene.materials[0].doubleSided = true;
    const SceneArrays a = flatten(scene);
    EXPECT_EQ(a.lights.at(0).kind, kLightTriangleTwoSided);
    EXPECT_FLOAT_EQ(a.lightPower[0], 2 * kPi * 3 * 10);
}

// Rays meet its back, and find no light there; nor may light samples.
TEST(Lights, GlassIsSeenFromBothSidesAndShinesInFront) {
    Scene scene = lamp();
    scene.materials[0].bsdf = BsdfSpec{.model = BsdfId::Dielectric};
    const SceneArrays a = flatten(scene);
    EXPECT_EQ(a.triangles[0].flags & kTriangleSingleSided, 0U);
    EXPECT_EQ(a.lights.at(0).kind, kLightTriangle);
    EXPECT_FLOAT_EQ(a.lightPower[0], kPi * 3 * 10);
    scene.materials[0].doubleSided = true;
    EXPECT_EQ(flatten(scene).lights.at(0).kind, kLightTriangleTwoSided);
}

TEST(Lights, ThoseThatMayBeTransparentAreLeftToChance) {
    Scene scene = lamp();
    scene.materials[0].alphaMode = AlphaMode::Blend;
    scene.materials[0].baseColor.a = 0.5F;
    const SceneArrays a = flatten(scene);
    EXPECT_TRUE(a.lights.empty());
    EXPECT_EQ(a.triangles[0].light, kNone);
    EXPECT_EQ(a.materials[0].emissive, glm::vec3(10));
}

TEST(Lights, PunctualPowersAndRecords) {
    Scene scene = sceneOf(trianglePrimitive());
    const glm::mat4 down = glm::rotate(glm::mat4(1), -kPi / 2, glm::vec3(1, 0, 0));  // -z turns to -y
    const glm::mat4 place = glm::translate(glm::mat4(1), {1, 2, 3}) * down * glm::scale(glm::mat4(1), glm::vec3(5));
    scene.lights = {{"p", PunctualKind::Point, place, glm::vec3(3), 4, 0, 0},
                    {"s", PunctualKind::Spot, place, glm::vec3(3), 0, 0.2F, 0.6F},
                    {"d", PunctualKind::Directional, place, glm::vec3(3), 0, 0, 0},
                    {"off", PunctualKind::Point, place, glm::vec3(0), 0, 0, 0}};
    const SceneArrays a = flatten(scene);
    ASSERT_EQ(a.lights.size(), 3U);
    const double radius = std::sqrt(2.0) / 2;
    EXPECT_FLOAT_EQ(a.lightPower[0], 4 * kPi * 3);
    EXPECT_FLOAT_EQ(a.lightPower[2], static_cast<float>(M_PI * radius * radius * 3));
    EXPECT_EQ(a.lights[0].a, glm::vec3(1, 2, 3));
    EXPECT_EQ(a.lights[0].c.z, 4);
    EXPECT_LT(glm::distance(a.lights[2].b, glm::vec3(0, -1, 0)), 1e-6F);
    // The cone's falloff is 1 at the inner angle and 0 at the outer one.
    EXPECT_NEAR(std::cos(0.2F) * a.lights[1].c.x + a.lights[1].c.y, 1, 1e-4);
    EXPECT_NEAR(std::cos(0.6F) * a.lights[1].c.x + a.lights[1].c.y, 0, 1e-4);
    EXPECT_TRUE(a.features.punctualLights);
}

TEST(Lights, SpotPowerIsTheFluxOfItsBeam) {
    constexpr float kInner = 0.3F, kOuter = 0.7F;
    Scene scene = sceneOf(trianglePrimitive());
    scene.lights = {{"s", PunctualKind::Spot, glm::mat4(1), glm::vec3(3), 0, kInner, kOuter}};
    double flux = 0;
    constexpr int kSteps = 10000;
    const double inner = std::cos(double{kInner}), outer = std::cos(double{kOuter});
    for (int i = 0; i < kSteps; ++i) {  // rings of equal solid angle, the falloff of KHR_lights_punctual
        const double c = 1 - (1 - outer) * (i + 0.5) / kSteps;
        const double t = std::clamp((c - outer) / (inner - outer), 0.0, 1.0);
        flux += 2 * M_PI * (1 - outer) / kSteps * t * t * 3;
    }
    EXPECT_NEAR(flatten(scene).lightPower.at(0) / flux, 1, 1e-4);
}

TEST(Lights, EnvironmentPowerIsPiRadiusSquaredTimesItsIntegral) {
    SceneArrays a = flatten(lamp());
    addEnvironment(a, constantEnvironment(glm::vec3(2)), 0.5F, 0);
    const float radius = sceneRadius(a);
    EXPECT_FLOAT_EQ(radius, std::sqrt(13.0F) / 2);
    EXPECT_FLOAT_EQ(a.lightPower.at(1), kPi * radius * radius * 4 * kPi);
    EXPECT_EQ(a.envLight, 1U);
}

TEST(Lights, PmfsAreInProportionToPowerAndFollowTheTable) {
    Scene scene = sceneOf(gridPrimitive(10), {glm::mat4(1), glm::scale(glm::mat4(1), glm::vec3(3))});
    scene.materials[0].emissive = {1, 2, 3};
    scene.lights.push_back({"p", PunctualKind::Point, glm::mat4(1), glm::vec3(5), 0, 0, 0});
    SceneArrays a = flatten(scene);
    addEnvironment(a, studioEnvironment(), 1, 0);
    ASSERT_EQ(a.lights.size(), 402U);
    const double total = std::accumulate(a.lightPower.begin(), a.lightPower.end(), 0.0);
    double sum = 0;
    for (std::size_t i = 0; i < a.lights.size(); ++i) {
        EXPECT_NEAR(a.lights[i].pmf, a.lightPower[i] / total, 1e-4 * a.lightPower[i] / total + 1.3e-7);
        EXPECT_EQ(a.lights[i].pmf, cdfStep(a.lightCdf, i));
        sum += double{a.lights[i].pmf};
    }
    EXPECT_EQ(sum, 1.0);
    EXPECT_EQ(a.lightCdf.back(), 1.0F);
}

TEST(Lights, ADimLightBesideAGlaringOneCanStillBeChosen) {
    Scene scene = lamp();
    scene.lights.push_back({"dim", PunctualKind::Point, glm::mat4(1), glm::vec3(1e-30F), 0, 0, 0});
    const SceneArrays a = flatten(scene);
    EXPECT_GT(a.lights.at(1).pmf, 0);
}

TEST(Lights, NoneIsFine) {
    const SceneArrays a = flatten(sceneOf(trianglePrimitive()));
    EXPECT_TRUE(a.lights.empty());
    EXPECT_TRUE(a.lightCdf.empty());
    EXPECT_EQ(a.triangles[0].light, kNone);
}

// ---- textured emission ----------------------------------------------------------------------------------------------

TEST(TexturedLights, BlackTrianglesHaveNoLightAndLitOnesDo) {
    Scene scene = sceneOf(gridPrimitive(8));
    TextureImage image = imageOf(64, 64, 0xff000000U);
    for (std::uint32_t y = 0; y < 8; ++y) {
        for (std::uint32_t x = 0; x < 8; ++x) image.texels[y * 64 + x] = 0xffffffffU;  // the cell of the first quad
    }
    scene.images.push_back(image);
    scene.materials[0].emissive = glm::vec3(2);
    scene.materials[0].emissiveTexture.image = 0;
    scene.materials[0].emissiveTexture.wrapS = scene.materials[0].emissiveTexture.wrapT = Wrap::ClampToEdge;
    const SceneArrays a = flatten(scene);
    EXPECT_TRUE(a.features.texturedEmission);
    EXPECT_NE(a.triangles[0].light, kNone);
    EXPECT_NE(a.triangles[1].light, kNone);
    EXPECT_LE(a.lights.size(), 8U);  // neighbours may reach the lit texels by the filter, no more
    EXPECT_EQ(a.triangles[127].light, kNone);
    const LightRecord& light = a.lights[0];
    const float area = glm::length(glm::cross(light.b - light.a, light.c - light.a)) / 2;
    EXPECT_NEAR(a.lightPower[a.triangles[0].light] / (kPi * area * 2), 1, 0.1);
}

TEST(TexturedLights, MeanDecodesSrgbBeforeAveraging) {
    SceneArrays a;
    a.texels = {0xff000000U, 0xffffffffU, 0xff808080U, 0xff808080U};
    TextureRecord t{};
    t.stride = 1;
    t.size = 4U | 1U << 16U;
    t.flags = kTextureSrgb;
    t.rowU = {1, 0, 0, 0};
    t.rowV = {0, 1, 0, 0};
    // Both halves of the whole square: the mean of all texels.
    const float lower = EmissiveTexture(a, t, glm::vec3(1)).mean({glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1)});
    const float upper = EmissiveTexture(a, t, glm::vec3(1)).mean({glm::vec2(0, 0), glm::vec2(1, 1), glm::vec2(0, 1)});
    EXPECT_NEAR((lower + upper) / 2, (0 + 1 + 2 * srgbToLinear(128 / 255.0F)) / 4, 0.02);
}

TEST(TexturedLights, WrapModesReachTheRightTexel) {
    SceneArrays a;
    a.texels = {0xff000000U, 0xff000000U, 0xff000000U, 0xffffffffU};  // only the last of four is lit
    TextureRecord t{};
    t.stride = 1;
    t.size = 4U | 1U << 16U;
    t.rowU = {1, 0, 0, 0};
    t.rowV = {0, 1, 0, 0};
    const auto lit = [&](float u, std::uint32_t wrap) {
        t.flags = kTextureNearest | wrap << kTextureWrapSShift;
        const glm::vec2 p(u, 0.5F);
        return EmissiveTexture(a, t, glm::vec3(1)).mean({p, p, p}) > 0.9F;
    };
    EXPECT_TRUE(lit(-0.1F, kWrapRepeat));
    EXPECT_FALSE(lit(-0.1F, kWrapClamp));
    EXPECT_FALSE(lit(-0.1F, kWrapMirror));
    EXPECT_FALSE(lit(1.1F, kWrapRepeat));
    EXPECT_TRUE(lit(1.1F, kWrapClamp));
    EXPECT_TRUE(lit(1.1F, kWrapMirror));
    EXPECT_TRUE(lit(2.9F, kWrapRepeat));
    EXPECT_TRUE(lit(2.9F, kWrapMirror));
    EXPECT_FALSE(lit(2.1F, kWrapMirror));
}

}  // namespace
}  // namespace vkpt
