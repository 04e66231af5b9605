// Light transport in closed form, by every strategy: all of them estimate the same, and the right thing.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "bsdf_oracle.h"
#include "estimate.h"

namespace vkpt {
namespace {

using namespace test;

constexpr double kPi = 3.14159265358979323846;

/// Calls test(options) for every strategy and hemisphere.
template <class Test>
void forEveryEstimator(RenderOptions options, Test&& test) {
    for (const NamedId& strategy : kEveryStrategy)
        for (const NamedId& hemisphere : kEveryHemisphere) {
            SCOPED_TRACE(std::string(strategy.name) + ", hemisphere " + hemisphere.name);
            options.params.strategy = strategy.id;
            options.params.hemisphere = hemisphere.id;
            test(options);
        }
}

/// Shines and reflects nothing.
Material lamp(float nits) {
    Material m = bsdfMaterial("lambert:color=0");
    m.emissive = glm::vec3(nits);
    return m;
}

SceneBuilder groundOf(const Material& material) {
    SceneBuilder builder;
    builder.quad(builder.material(material), {-9, -9, 0}, {18, 0, 0}, {0, 18, 0});
    return builder;
}

/// A disc of radius r at height z that shines downwards, as a fan of triangles.
void addDisc(SceneBuilder& builder, const Material& material, float r, float z) {
    constexpr std::uint32_t kSides = 96;
    Primitive p;
    p.material = builder.material(material);
    p.positions.push_back({0, 0, z});
    for (std::uint32_t i = 0; i < kSides; ++i) {
        const float a = 2 * static_cast<float>(kPi) * static_cast<float>(i) / kSides;
        p.positions.push_back({r * std::cos(a), r * std::sin(a), z});
        p.triangles.push_back({0, 1 + (i + 1) % kSides, 1 + i});
    }
    p.normals.assign(p.positions.size(), {0, 0, -1});
    builder.mesh({std::move(p)}, glm::mat4(1));
}

// A disc of radius r at height h gives the ground beneath its middle the irradiance pi L r^2 / (r^2 + h^2).
TEST(EveryEstimator, DiscLightOverAPlane) {
    SceneBuilder builder = groundOf(bsdfMaterial("lambert:color=0.6"));
    const double side = 2 * kPi / 96, r2 = std::sin(side) / side;  // of the circle of the polygon's area
    addDisc(builder, lamp(2), 1, 1);
    const double truth = 0.6 * 2 * r2 / (r2 + 1);
    const SceneArrays scene = builder.build();
    forEveryEstimator(viewAlongZ(1, 1e-3F, 128, 1, 0.5F), [&](const RenderOptions& options) {
        expectEstimates(estimate(scene, options, 32), truth, 2e-5);
    });
}

TEST(EveryEstimator, FurnaceShowsTheAlbedo) {
    const SceneArrays matteScene = groundOf(bsdfMaterial("lambert:color=0.8")).build(glm::vec3(1));
    const SceneArrays metalScene = groundOf(metal({1, 0.7F, 0.3F}, 0.6F)).build(glm::vec3(1));
    const double metalAlbedo = gltfAlbedo({1, 0.7, 0.3}, 1, 0.6, 0.7).x;
    for (const IntegratorId integrator : {IntegratorId::Path, IntegratorId::Direct}) {
        RenderOptions options = viewAtAngle(0.7F, 0.5F, 32, 1);
        options.params.integrator = static_cast<std::uint32_t>(integrator);
        options.params.bsdfSamples = 2;
        forEveryEstimator(options, [&](const RenderOptions& o) {
            expectEstimates(estimate(matteScene, o, 8), 0.8, 1e-4);
            expectEstimates(estimate(metalScene, o, 8), metalAlbedo, 1e-3);
        });
    }
}

// No BSDF sample meets a point: all other strategies give the same to rounding, whatever draws the next direction.
TEST(EveryEstimator, PunctualLightsAreForLightSamplesAlone) {
    for (const PunctualKind kind : {PunctualKind::Point, PunctualKind::Directional}) {
        SceneBuilder builder = groundOf(bsdfMaterial("lambert:color=0.5"));
        PunctualLight light;
        light.kind = kind;
        light.intensity = glm::vec3(3);
        light.worldFromLight = glm::rotate(glm::translate(glm::mat4(1), glm::vec3(1, 0, 2)), 0.5F, {0, 1, 0});
        const double cosine = kind == PunctualKind::Point ? 2 / std::sqrt(5.0) : std::cos(0.5);
        const double truth = 0.5 / kPi * 3 * cosine / (kind == PunctualKind::Point ? 5 : 1);
        const SceneArrays scene = builder.light(light).build();
        forEveryEstimator(viewAlongZ(1, 1e-4F, 4, 2), [&](const RenderOptions& options) {
            const double found = options.params.strategy == kStrategyBsdf ? 0 : truth;
            EXPECT_NEAR(meanOf(renderReference(scene, options)).r, found, 1e-5);
        });
    }
}

// Between the cones: clamp((cos - cosOuter) / (cosInner - cosOuter))^2. [KHR_lights_punctual]
TEST(EveryEstimator, SpotFallsOffBetweenItsCones) {
    for (const double angle : {0.1, 0.3, 0.35, 0.45, 0.6}) {
        SceneBuilder builder = groundOf(bsdfMaterial("lambert:color=0.5"));
        PunctualLight light;
        light.kind = PunctualKind::Spot;
        light.innerConeAngle = 0.2F;
        light.outerConeAngle = 0.5F;
        light.intensity = glm::vec3(7);
        light.worldFromLight = glm::translate(glm::mat4(1), glm::vec3(2 * std::tan(angle), 0, 2));
        const double s = std::clamp((std::cos(angle) - std::cos(0.5)) / (std::cos(0.2) - std::cos(0.5)), 0.0, 1.0);
        const double distance2 = 4 / std::cos(angle) / std::cos(angle);
        const double truth = 0.5 / kPi * 7 * s * s * std::cos(angle) / distance2;
        const SceneArrays scene = builder.light(light).build();
        EXPECT_NEAR(meanOf(renderReference(scene, viewAlongZ(1, 1e-4F, 4, 1))).r, truth, 1e-5) << angle;
    }
}

/// A sphere of radius r about the origin, 8 x 4^levels triangles, as large as the sphere that it stands for.
void addSphere(SceneBuilder& builder, const Material& material, double r, bool inwards, int levels) {
    std::vector<glm::dvec3> corners;  // three a triangle
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 x(i & 1 ? 1 : -1, 0, 0), y(0, i & 2 ? 1 : -1, 0), z(0, 0, i & 4 ? 1 : -1);
        const bool even = glm::dot(glm::cross(x, y), z) > 0;
        corners.insert(corners.end(), {x, even ? y : z, even ? z : y});
    }
    for (int level = 0; level < levels; ++level) {
        std::vector<glm::dvec3> finer;
        for (std::size_t i = 0; i < corners.size(); i += 3) {
            const glm::dvec3 a = corners[i], b = corners[i + 1], c = corners[i + 2];
            const glm::dvec3 ab = glm::normalize(a + b), bc = glm::normalize(b + c), ca = glm::normalize(c + a);
            finer.insert(finer.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
        }
        corners = std::move(finer);
    }
    double area = 0;
    for (std::size_t i = 0; i < corners.size(); i += 3)
        area += glm::length(glm::cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i])) / 2;
    Primitive p;
    p.material = builder.material(material);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        p.positions.push_back(glm::vec3(corners[i] * r * std::sqrt(4 * kPi / area)));
        p.normals.push_back(glm::vec3(inwards ? -corners[i] : corners[i]));
    }
    for (std::uint32_t i = 0; i < corners.size(); i += 3) p.triangles.push_back({i, i + 1 + inwards, i + 2 - inwards});
    builder.mesh({std::move(p)}, glm::mat4(1));
}

// A black sphere of radius r that shines with L in the middle of a matte one of radius 1: the wall receives pi L r^2 at
// once, and 1 - r^2 of what it sends comes back to it. So its radiance is rho L r^2 / (1 - rho (1 - r^2)).
TEST(EveryEstimator, SphereInsideASphere) {
    constexpr double kR = 0.5, kRho = 0.6;
    SceneBuilder builder;
    addSphere(builder, lamp(3), kR, false, 3);
    addSphere(builder, bsdfMaterial("lambert:color=0.6"), 1, true, 4);
    const SceneArrays scene = builder.build();
    RenderOptions options = viewAlongZ(8, 0.5F, 8, 40, -0.7F);  // looks at the wall from between the spheres
    options.params.projection = kProjectionPerspective;
    options.params.rrMode = kRouletteThroughput;
    const double truth = kRho * 3 * kR * kR / (1 - kRho * (1 - kR * kR));
    for (const NamedId& strategy : kEveryStrategy) {
        SCOPED_TRACE(strategy.name);
        options.params.strategy = strategy.id;
        expectEstimates(estimate(scene, options, 24), truth, 3e-3);  // facets stand for the spheres
    }
}

// A closed room that glows and reflects 0.99: after D bounces (1 - 0.99^(D+1)) / 0.01 nits, and nothing is lost on the
// way.
TEST(LongPaths, KeepTheirEnergyForAThousandBounces) {
    Material glowing = bsdfMaterial("lambert:color=0.99");
    glowing.emissive = glm::vec3(1);
    SceneBuilder builder;
    const SceneArrays scene = builder.roomAround(builder.material(glowing), glm::vec3(0), 3).build();
    RenderOptions options = viewAlongZ(4, 1, 4, 1000, 1);
    const double truth = (1 - std::pow(0.99, 1001)) / 0.01;
    options.params.strategy = kStrategyBsdf;  // every segment adds its glow: no path differs from another
    options.params.rrMode = kRouletteOff;
    const Estimate exact = estimate(scene, options, 2);
    EXPECT_NEAR(exact.mean, truth, 1e-4 * truth);
    EXPECT_LT(exact.standardError, 1e-5 * truth);
    for (const std::uint32_t roulette : {kRouletteThroughput, kRouletteFixed}) {
        setRoulette(options.params, roulette);
        options.params.rrDepth = 3;
        options.params.rrFixed = 0.99F;
        options.params.spp = options.sampleEnd = 32;
        expectEstimates(estimate(scene, options, 8), truth, 1e-4);
    }
    options.params.strategy = kStrategyMisPower;
    options.params.rrMode = kRouletteOff;
    options.params.spp = options.sampleEnd = 2;
    expectEstimates(estimate(scene, options, 8), truth, 1e-4);
}

// Each contribution of two and more scatterings is cut, no other.
TEST(ClampIndirect, CutsWhatWasScatteredTwice) {
    Material glowing = metal(glm::vec3(1), 0);
    glowing.emissive = {1, 0.5F, 0.25F};
    SceneBuilder builder;
    const SceneArrays scene = builder.roomAround(builder.material(glowing), glm::vec3(0), 3).build();
    RenderOptions options = viewAlongZ(4, 1, 4, 5, 1);
    const auto check = [&](float most, double factor) {
        options.params.clampIndirect = most;
        const glm::dvec3 mean = meanOf(renderReference(scene, options));
        EXPECT_LT(glm::distance(mean, (2 + 4 * factor) * glm::dvec3(1, 0.5, 0.25)), 1e-3) << most;
    };
    check(0, 1);
    check(2, 1);
    check(0.5F, 0.5);  // the hue stays
    check(0.125F, 0.125);
}

TEST(ClampIndirect, CutsLightSamplesFromTheSecondSurfaceOn) {
    SceneBuilder builder = groundOf(metal(glm::vec3(1), 0));  // a mirror that shows a lit ceiling
    builder.quad(builder.material(bsdfMaterial("lambert:color=0.5")), {-9, -9, 6}, {0, 18, 0}, {18, 0, 0});
    PunctualLight light;
    light.intensity = glm::vec3(40);
    light.worldFromLight = glm::translate(glm::mat4(1), glm::vec3(0.5F, 0, 4));
    const SceneArrays scene = builder.light(light).build();
    RenderOptions options = viewAlongZ(1, 1e-3F, 4, 2, 3);
    const double open = meanOf(renderReference(scene, options)).r;
    ASSERT_GT(open, 1);
    options.params.clampIndirect = 0.75F;
    EXPECT_NEAR(meanOf(renderReference(scene, options)).r, 0.75, 1e-5);
    options.params.eye.z = 5;
    options.params.forward.z = 1;  // the ceiling itself: scattered once
    EXPECT_NEAR(meanOf(renderReference(scene, options)).r, open, 0.02 * open);
}

// Nothing is counted twice where a mirror shows a lamp, nor missed.
TEST(EveryEstimator, AMirrorShowsALamp) {
    SceneBuilder builder = groundOf(metal(glm::vec3(1), 0));
    addDisc(builder, lamp(2), 3, 6);
    const SceneArrays scene = builder.build();
    forEveryEstimator(viewAlongZ(2, 0.1F, 4, 1, 2), [&](const RenderOptions& options) {
        EXPECT_NEAR(meanOf(renderReference(scene, options)).r, 2, 1e-5);
    });
}

}  // namespace
}  // namespace vkpt
