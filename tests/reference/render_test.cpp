// Renders with known answers: transport in closed form or by quadrature of the textbook BRDF.
#include "reference/render.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "bsdf_oracle.h"
#include "test_scene.h"

namespace vkpt {
namespace {

using namespace test;

Material withAlpha(const glm::vec3& nits, float alpha) {
    Material m = emitter(nits);
    m.unlit = true;
    m.baseColor = glm::vec4(nits, alpha);
    m.alphaMode = AlphaMode::Blend;
    m.doubleSided = true;
    return m;
}

/// A large plane z = 0 facing +z.
SceneBuilder plane(const Material& material) {
    SceneBuilder builder;
    builder.quad(builder.material(material), {-9, -9, 0}, {18, 0, 0}, {0, 18, 0});
    return builder;
}

TEST(Render, AnEmptySceneShowsItsBackground) {
    const SceneArrays scene = SceneBuilder().build(glm::vec3(0.25F, 0.5F, 2));
    RenderOptions options = viewAlongZ(4, 1, 2, 3);
    EXPECT_LT(glm::distance(meanOf(renderReference(scene, options)), glm::dvec4(0.25, 0.5, 2, 1)), 1e-9);
    options.params.backgroundMode = kBackgroundTransparent;
    EXPECT_EQ(meanOf(renderReference(scene, options)), glm::dvec4(0));
    options.params.backgroundMode = kBackgroundColor;
    options.params.background = {3, 2, 1};
    EXPECT_EQ(meanOf(renderReference(scene, options)), glm::dvec4(3, 2, 1, 1));
}

// Furnace: under uniform light every surface shows its albedo. NEE and MIS take part.
TEST(Render, FurnaceShowsTheAlbedo) {
    for (const Material& material : {matte({0.8F, 0.4F, 0.1F}), metal({1, 0.7F, 0.3F}, 0.6F), metal(glm::vec3(1), 1)}) {
        for (const float cosine : {0.35F, 0.95F}) {
            const SceneArrays scene = plane(material).build(glm::vec3(1));
            const glm::dvec4 mean = meanOf(renderReference(scene, viewAtAngle(cosine, 0.5F, 4096, 3)));
            const glm::dvec3 truth = gltfAlbedo(glm::dvec3(glm::vec3(material.baseColor)), double{material.metallic},
                                                double{material.roughness}, double{cosine});
            for (int i = 0; i < 3; ++i) EXPECT_NEAR(mean[i], truth[i], 0.004 * truth[i]) << cosine;
            EXPECT_EQ(mean.a, 1);
        }
    }
}

TEST(Render, WhiteMirrorVanishesInTheFurnace) {
    const SceneArrays scene = plane(metal(glm::vec3(1), 0)).build(glm::vec3(1));
    EXPECT_LT(glm::distance(meanOf(renderReference(scene, viewAtAngle(0.4F, 0.5F, 4, 2))), glm::dvec4(1)), 1e-6);
}

TEST(Render, MirrorShowsSchlick) {
    const SceneArrays scene = plane(metal({0.5F, 0.2F, 0}, 0)).build(glm::vec3(1));
    const double weight = std::pow(1 - 0.4, 5);
    const glm::dvec4 mean = meanOf(renderReference(scene, viewAtAngle(0.4F, 0.5F, 4, 1)));
    EXPECT_NEAR(mean.r, 0.5 + 0.5 * weight, 1e-5);
    EXPECT_NEAR(mean.g, 0.2 + 0.8 * weight, 1e-5);
    EXPECT_NEAR(mean.b, weight, 1e-5);
}

// A closed room of white mirrors that glow: each of the depth + 1 segments adds exactly one nit.
TEST(Render, ClosedMirrorRoomCountsItsBounces) {
    Material glowing = metal(glm::vec3(1), 0);
    glowing.emissive = glm::vec3(1);
    SceneBuilder builder;
    const SceneArrays scene = builder.roomAround(builder.material(glowing), glm::vec3(0), 3).build();
    for (const std::uint32_t depth : {0U, 1U, 5U, 20U}) {
        RenderOptions options = viewAlongZ(8, 1, 4, depth, 1);
        options.params.projection = kProjectionPerspective;
        EXPECT_NEAR(meanOf(renderReference(scene, options)).g, depth + 1, 1e-4 * (depth + 1)) << depth;
    }
}

TEST(Render, DirectionalLightGivesFTimesCosine) {
    SceneBuilder builder = plane(metal({0.9F, 0.6F, 0.3F}, 0.5F));
    PunctualLight sun;
    sun.kind = PunctualKind::Directional;
    sun.intensity = {2, 3, 4};
    sun.worldFromLight = glm::rotate(glm::mat4(1), 0.6F, {0, 1, 0});  // shines along -z, turned about y
    builder.light(sun);
    const glm::dvec3 wi(std::sin(0.6), 0, std::cos(0.6)), wo(-0.8, 0, 0.6);
    RenderOptions options = viewAtAngle(0.6F, 0.5F, 4, 1);
    options.params.forward.x = -options.params.forward.x;  // seen from -x: near the mirror direction
    options.params.eye = -5.0F * options.params.forward;
    options.params.right.z = -options.params.right.z;
    const glm::dvec4 mean = meanOf(renderReference(builder.build(), options));
    const glm::dvec3 truth = gltfOracle({0.9, 0.6, 0.3}, 1, 0.5, wo, wi) * wi.z * glm::dvec3(2, 3, 4);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(mean[i], truth[i], 1e-4 * truth[i]);
}

TEST(Render, PointAndSpotFallOffWithTheSquareOfDistance) {
    for (const PunctualKind kind : {PunctualKind::Point, PunctualKind::Spot}) {
        SceneBuilder builder = plane(matte(glm::vec3(0.5F)));
        PunctualLight lamp;
        lamp.kind = kind;
        lamp.intensity = glm::vec3(10);
        lamp.range = 4;
        lamp.innerConeAngle = 0.2F;
        lamp.worldFromLight = glm::translate(glm::mat4(1), glm::vec3(0, 0, 2));
        const Film film = renderReference(builder.light(lamp).build(), viewAlongZ(1, 0.001F, 4, 1, 1));
        const double f = gltfOracle(glm::dvec3(0.5), 0, 1, {0, 0, 1}, {0, 0, 1}).x;
        EXPECT_NEAR(meanOf(film).r, f * 10 / 4 * (1 - std::pow(0.5, 4)), 1e-4);
    }
}

TEST(Render, SpotIsDarkOutsideItsCone) {
    SceneBuilder builder = plane(matte(glm::vec3(0.5F)));
    PunctualLight lamp;
    lamp.kind = PunctualKind::Spot;
    lamp.outerConeAngle = 0.3F;
    lamp.worldFromLight = glm::translate(glm::mat4(1), glm::vec3(3, 0, 2));
    EXPECT_EQ(meanOf(renderReference(builder.light(lamp).build(), viewAlongZ(1, 0.001F, 4, 1, 1))).r, 0);
}

TEST(Render, ABlockerCastsAShadow) {
    SceneBuilder builder = plane(matte(glm::vec3(0.5F)));
    PunctualLight lamp;
    lamp.worldFromLight = glm::translate(glm::mat4(1), glm::vec3(0, 4, 2));
    Material twoSided = matte(glm::vec3(0.5F));
    twoSided.doubleSided = true;
    builder.quad(builder.material(twoSided), {-1, 1, 1}, {2, 0, 0}, {0, 2, 0});
    const SceneArrays scene = builder.light(lamp).build();
    RenderOptions options = viewAlongZ(1, 0.001F, 4, 1, 9);
    EXPECT_EQ(meanOf(renderReference(scene, options)).r, 0);
    options.params.eye.x = 3;  // beside the blocker's shadow
    EXPECT_GT(meanOf(renderReference(scene, options)).r, 0);
}

/// Radiance towards +z from the origin of z = 0 lit by the quad at height 1, by quadrature over its area.
double litByQuad(double roughness, double metallic, double half) {
    constexpr int kSteps = 400;
    double sum = 0;
    for (int i = 0; i < kSteps * kSteps; ++i) {
        const glm::dvec3 point(half * (2 * (i % kSteps + 0.5) / kSteps - 1) + 1,
                               half * (2 * (i / kSteps + 0.5) / kSteps - 1), 1);
        const double distance2 = glm::dot(point, point);
        const glm::dvec3 wi = point / std::sqrt(distance2);
        sum += gltfOracle(glm::dvec3(0.7), metallic, roughness, {0, 0, 1}, wi).x * wi.z * wi.z / distance2;
    }
    return sum * 4 * half * half / kSteps / kSteps;
}

// Both strategies meet here: the light is small for the rough surface and found by the BSDF on the smooth one.
TEST(Render, AreaLightEqualsQuadrature) {
    for (const float roughness : {0.3F, 1.0F}) {
        for (const float metallic : {0.0F, 1.0F}) {
            Material m = matte(glm::vec3(0.7F));
            m.roughness = roughness;
            m.metallic = metallic;
            SceneBuilder builder = plane(m);
            builder.quad(builder.material(emitter(glm::vec3(1))), {0.5F, 0.5F, 1}, {1, 0, 0}, {0, -1, 0});
            const Film film = renderReference(builder.build(), viewAlongZ(1, 0.001F, 16384, 1, 0.5F));
            const double truth = litByQuad(double{roughness}, double{metallic}, 0.5);
            EXPECT_NEAR(meanOf(film).r, truth, 0.006 * truth) << roughness << " " << metallic;
        }
    }
}

// Emission only by chance (a light the table does not hold) and by NEE must agree: alpha triangles have no light.
TEST(Render, EmissionWithoutALightRecordIsFoundByPathsAlone) {
    Material glow = emitter(glm::vec3(1));
    SceneBuilder listed = plane(matte(glm::vec3(0.7F))), unlisted = listed;
    listed.quad(listed.material(glow), {-1, 1, 1}, {2, 0, 0}, {0, -2, 0});
    glow.alphaMode = AlphaMode::Mask;
    unlisted.quad(unlisted.material(glow), {-1, 1, 1}, {2, 0, 0}, {0, -2, 0});
    const RenderOptions options = viewAlongZ(1, 0.001F, 16384, 1, 0.5F);
    const double a = meanOf(renderReference(listed.build(), options)).r;
    const double b = meanOf(renderReference(unlisted.build(), options)).r;
    EXPECT_NEAR(a, b, 0.01 * a);
}

TEST(Render, TexturedEmissionLightsAsItShows) {
    Material screen = emitter(glm::vec3(4));
    screen.emissiveTexture.image = 0;
    screen.emissiveTexture.nearest = true;
    SceneBuilder textured = plane(matte(glm::vec3(0.7F))), half = textured;
    textured.scene().images.push_back({"black and white", 2, 1, {0xff000000U, 0xffffffffU}});
    textured.quad(textured.material(screen), {-1, 1, 1}, {2, 0, 0}, {0, -2, 0});  // u along x: its right half shines
    half.quad(half.material(emitter(glm::vec3(4))), {0, 1, 1}, {1, 0, 0}, {0, -2, 0});
    RenderOptions options = viewAlongZ(1, 0.001F, 16384, 1, 0.5F);
    options.params.eye.x = 0.7F;
    const double a = meanOf(renderReference(textured.build(), options)).r;
    const double b = meanOf(renderReference(half.build(), options)).r;
    EXPECT_GT(a, 0.1);
    EXPECT_NEAR(a, b, 0.01 * b);
}

// ---- alpha

TEST(RenderAlpha, TwoHalfSheetsCompose) {
    SceneBuilder builder;
    builder.quad(builder.material(withAlpha({1, 0, 0}, 0.5F)), {-9, -9, 1}, {18, 0, 0}, {0, 18, 0});
    builder.quad(builder.material(withAlpha({0, 1, 0}, 0.5F)), {-9, -9, 0}, {18, 0, 0}, {0, 18, 0});
    RenderOptions options = viewAlongZ(32, 1, 64, 2);
    options.params.backgroundMode = kBackgroundTransparent;
    const glm::dvec4 mean = meanOf(renderReference(builder.build(glm::vec3(0, 0, 1)), options));
    const double tolerance = 4 * 0.5 / std::sqrt(32 * 32 * 64);
    EXPECT_NEAR(mean.r, 0.5, tolerance);
    EXPECT_NEAR(mean.g, 0.25, tolerance);
    EXPECT_EQ(mean.b, 0);
    EXPECT_NEAR(mean.a, 0.75, tolerance);
}

// One 50 % sheet crossed by the camera ray, and again by the ray from the mirror behind it, or by the shadow ray:
// the segments of a path decide independently, so a quarter comes through.
TEST(RenderAlpha, OneSheetCrossedTwiceDecidesTwice) {
    const double tolerance = 4 * 0.5 / std::sqrt(32 * 32 * 64);
    SceneBuilder mirror = plane(metal(glm::vec3(1), 0));
    mirror.quad(mirror.material(withAlpha(glm::vec3(0), 0.5F)), {-9, -9, 1}, {18, 0, 0}, {0, 18, 0});
    EXPECT_NEAR(meanOf(renderReference(mirror.build(glm::vec3(1)), viewAlongZ(32, 1, 64, 2))).r, 0.25, tolerance);

    SceneBuilder lit = plane(matte(glm::vec3(0.5F)));
    PunctualLight sun;
    sun.kind = PunctualKind::Directional;
    lit.light(sun);
    const double open = meanOf(renderReference(lit.build(), viewAlongZ(32, 1, 64, 1))).r;
    lit.quad(lit.material(withAlpha(glm::vec3(0), 0.5F)), {-9, -9, 1}, {18, 0, 0}, {0, 18, 0});
    const double through = meanOf(renderReference(lit.build(), viewAlongZ(32, 1, 64, 1))).r;
    EXPECT_NEAR(through / open, 0.25, tolerance);
}

TEST(RenderAlpha, BackOfASingleSidedSurfaceIsAbsent) {
    SceneBuilder builder;
    builder.quad(builder.material(emitter(glm::vec3(5))), {-9, -9, 0}, {0, 18, 0}, {18, 0, 0});  // faces -z
    const glm::dvec4 mean = meanOf(renderReference(builder.build(glm::vec3(0.5F)), viewAlongZ(4, 1, 4, 2)));
    EXPECT_LT(glm::distance(mean, glm::dvec4(0.5, 0.5, 0.5, 1)), 1e-6);
}

TEST(RenderAlpha, UnlitShowsItsColourWhateverLightsIt) {
    Material m = matte({0.2F, 0.4F, 0.6F});
    m.unlit = true;
    const glm::dvec4 mean = meanOf(renderReference(plane(m).build(glm::vec3(7)), viewAlongZ(4, 1, 4, 5)));
    EXPECT_LT(glm::distance(mean, glm::dvec4(0.2, 0.4, 0.6, 1)), 1e-6);
}

}  // namespace
}  // namespace vkpt
