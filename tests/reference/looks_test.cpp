// Ambient occlusion and the looks for debugging, where the answer is known.
#include "reference/looks.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "estimate.h"

namespace vkpt {
namespace {

using namespace test;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

RenderOptions lookAlongZ(IntegratorId integrator, std::uint32_t side, float half, std::uint32_t spp) {
    RenderOptions options = viewAlongZ(side, half, spp, 0);
    options.params.integrator = static_cast<std::uint32_t>(integrator);
    return options;
}

SceneBuilder ground(const Material& material) {
    SceneBuilder builder;
    builder.quad(builder.material(material), {-400, -400, 0}, {800, 0, 0}, {0, 800, 0});
    return builder;
}

TEST(AmbientOcclusion, OfAnOpenPlaneIsOne) {
    for (const NamedId& hemisphere : kEveryHemisphere) {
        RenderOptions options = lookAlongZ(IntegratorId::Ao, 4, 1, 1024);
        options.params.hemisphere = hemisphere.id;
        const double tolerance = hemisphere.id == kHemisphereUniform ? 2e-3 : 1e-6;  // cosine: every sample is worth 1
        const glm::dvec4 mean = meanOf(renderReference(ground(matte(glm::vec3(0))).build(), options));
        EXPECT_NEAR(mean.r, 1, tolerance) << hemisphere.name;
        EXPECT_NEAR(mean.b, 1, tolerance) << hemisphere.name;
    }
}

// A wall without end takes half of the sky from where it stands, whatever it is made of.
TEST(AmbientOcclusion, UnderAnEndlessWallIsHalf) {
    Material unlit = emitter(glm::vec3(9));
    unlit.unlit = true;
    for (const Material& wall : {matte(glm::vec3(0.5F)), unlit, bsdfMaterial("dielectric")}) {
        SceneBuilder builder = ground(unlit);
        builder.quad(builder.material(wall), {0, -400, 0}, {0, 800, 0}, {0, 0, 400});
        const SceneArrays scene = builder.build();
        for (const NamedId& hemisphere : kEveryHemisphere) {
            RenderOptions options = lookAlongZ(IntegratorId::Ao, 1, 1e-3F, 1024);
            options.params.eye.x = 0.02F;
            options.params.hemisphere = hemisphere.id;
            expectEstimates(estimate(scene, options, 8), 0.5, 2e-4);
        }
    }
}

// Under a ceiling at height h, seen up to distance D: what is flatter than h / D is open, a share of (h / D)^2.
TEST(AmbientOcclusion, LooksAsFarAsItIsTold) {
    SceneBuilder builder = ground(matte(glm::vec3(0.5F)));
    builder.quad(builder.material(matte(glm::vec3(0.5F))), {-400, -400, 7}, {0, 800, 0}, {800, 0, 0});
    const SceneArrays scene = builder.build();
    RenderOptions options = lookAlongZ(IntegratorId::Ao, 1, 1e-3F, 1024);
    for (const float distance : {5.0F, 8.0F, 14.0F, 28.0F}) {
        options.params.aoDistance = distance;
        expectEstimates(estimate(scene, options, 8), std::pow(std::min(1.0, 7 / double{distance}), 2), 1e-4);
    }
    options.params.aoDistance = kInfinity;
    EXPECT_EQ(meanOf(renderReference(scene, options)).r, 0);
}

/// A quad in the view's lower half, turned by `angle` about x.
SceneBuilder tilted(const Material& material, float angle) {
    SceneBuilder builder;
    const glm::vec3 up(0, std::cos(angle), std::sin(angle));
    builder.quad(builder.material(material), {-9, 0, 0}, {18, 0, 0}, -9.0F * up);
    return builder;
}

TEST(Looks, ShowTheSurfaceAndNothingElse) {
    Material m = matte({0.25F, 0.5F, 0.75F});
    m.emissive = glm::vec3(5);
    m.doubleSided = true;
    const SceneArrays scene = tilted(m, 0.4F).build(glm::vec3(7));
    const auto at = [&](IntegratorId integrator, std::uint32_t y) {
        const Image image = filmToImage(renderReference(scene, lookAlongZ(integrator, 8, 1, 16)));
        EXPECT_EQ(image.at(3, 1)[0], 0) << "the sky is black";
        EXPECT_EQ(image.at(3, 1)[3], 0) << "and transparent";
        EXPECT_EQ(image.at(3, y)[3], 1);
        return glm::vec3(image.at(3, y)[0], image.at(3, y)[1], image.at(3, y)[2]);
    };
    EXPECT_EQ(at(IntegratorId::Albedo, 6), glm::vec3(0.25F, 0.5F, 0.75F));
    const glm::vec3 normal(0, -std::sin(0.4F), std::cos(0.4F));
    EXPECT_LT(glm::distance(at(IntegratorId::Normal, 6), (normal + 1.0F) / 2.0F), 1e-4F);
    EXPECT_NEAR(at(IntegratorId::Depth, 6).x, 5 + 0.625 * std::tan(0.4), 2e-3) << "the row's middle is y = -0.625";
    EXPECT_NEAR(at(IntegratorId::Uv, 6).y, 0.625 / std::cos(0.4) / 9, 1e-3);
    EXPECT_NEAR(at(IntegratorId::Uv, 6).x, (9 - 0.125) / 18, 1e-3);
    const glm::vec3 b = at(IntegratorId::Barycentrics, 6);
    EXPECT_NEAR(b.x + b.y + b.z, 1, 1e-6);
    EXPECT_GT(std::min({b.x, b.y, b.z}), 0);
}

TEST(Looks, TexcoordsWrapIntoTheUnitSquare) {
    SceneBuilder builder;
    builder.quad(builder.material(matte(glm::vec3(1))), {-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
    for (glm::vec2& uv : builder.scene().meshes[0].primitives[0].uv0) uv = 4.0F * uv - 2.25F;
    const Image image = filmToImage(renderReference(builder.build(), lookAlongZ(IntegratorId::Uv, 64, 1, 1)));
    for (std::uint32_t x = 0; x < 64; ++x) {
        const float u = 4 * (static_cast<float>(x) + 0.5F) / 64 - 2.25F, wrapped = u - std::floor(u);
        if (std::abs(wrapped - 0.5F) > 0.45F) continue;  // wraps within the pixel
        EXPECT_NEAR(image.at(x, 20)[0], wrapped, 0.04F) << x;
    }
}

TEST(Looks, DepthOfAPanoramaIsTheDistance) {
    SceneBuilder builder;
    const SceneArrays scene = builder.roomAround(builder.material(matte(glm::vec3(1))), glm::vec3(0), 3).build();
    RenderOptions options = lookAlongZ(IntegratorId::Depth, 16, 1, 4);
    options.params.eye = glm::vec3(0);
    options.params.projection = kProjectionPanorama;
    options.aovs.add(Aov::Depth);
    const Film film = renderReference(scene, options);
    const Image image = filmToImage(film);
    for (const float depth : {image.at(8, 7)[0], image.at(0, 8)[0], image.at(4, 8)[0]}) EXPECT_NEAR(depth, 3.2F, 0.25F);
    for (std::uint32_t i = 0; i < 256; ++i) {
        EXPECT_GE(image.pixels[4 * i], 3);
        EXPECT_LE(image.pixels[4 * i], 5.2F);
        EXPECT_EQ(film.layers[i], uvec4(film.sums[i].red.x, film.sums[i].red.y, film.sums[i].red.z, 0));
    }
}

TEST(Looks, CostCountsTheSearchOfMissesToo) {
    Material m = matte(glm::vec3(1));
    m.doubleSided = true;
    const SceneArrays scene = tilted(m, 0.4F).build();
    const Image image = filmToImage(renderReference(scene, lookAlongZ(IntegratorId::Cost, 8, 1, 4)));
    EXPECT_EQ(image.at(3, 6)[0], 1) << "the root alone";
    EXPECT_GE(image.at(3, 6)[1], 1);
    EXPECT_LE(image.at(3, 6)[1], 2) << "there are but two triangles";
    EXPECT_EQ(image.at(3, 6)[3], 1);
    EXPECT_EQ(image.at(3, 1)[0], 1);
    EXPECT_EQ(image.at(3, 1)[1], 0);
    EXPECT_EQ(image.at(3, 1)[3], 0);
}

TEST(Looks, LightProbabilityIsThatOfTheSamplesDirection) {
    // A lamp of 1 dm^2 a metre above: a light sample has density d^2 / (A cos), a BSDF sample cos / pi.
    SceneBuilder builder = ground(bsdfMaterial("lambert"));
    builder.quad(builder.material(emitter(glm::vec3(1))), {-0.05F, 0.05F, 1}, {0.1F, 0, 0}, {0, -0.1F, 0});
    RenderOptions options = lookAlongZ(IntegratorId::LightProbability, 1, 1e-4F, 64);
    options.params.eye.z = 0.5F;
    EXPECT_NEAR(meanOf(renderReference(builder.build(), options)).g, 1 / (1 + 0.01 / 3.14159265), 1e-4);

    SceneBuilder sunny = ground(bsdfMaterial("lambert"));
    PunctualLight sun;
    sun.kind = PunctualKind::Directional;
    EXPECT_EQ(meanOf(renderReference(sunny.light(sun).build(), options)).g, 1);
    sun.worldFromLight = glm::rotate(glm::mat4(1), 3.0F, {1, 0, 0});  // from below
    SceneBuilder dark = ground(bsdfMaterial("lambert"));
    EXPECT_EQ(meanOf(renderReference(dark.light(sun).build(), options)).g, 0);
    EXPECT_EQ(meanOf(renderReference(ground(metal(glm::vec3(1), 0)).light(sun).build(), options)).g, 0) << "a mirror";
}

// A filter's weight is part of every value.
TEST(Looks, KeepTheMeanUnderAFilterWithLobesBelowZero) {
    const SceneArrays scene = ground(matte({0.25F, 0.5F, 0.75F})).build();
    for (const IntegratorId integrator : {IntegratorId::Albedo, IntegratorId::Ao}) {
        RenderOptions options = lookAlongZ(integrator, 2, 1, 1024);
        options.params.pixelFilter = kFilterMitchell;
        options.params.filterRadius = 2;
        const Estimate e = estimateRgb(scene, options, 8)[1];
        expectEstimates(e, integrator == IntegratorId::Ao ? 1 : 0.5);
        EXPECT_GT(e.standardError, 0) << "weights vary";
    }
}

}  // namespace
}  // namespace vkpt
