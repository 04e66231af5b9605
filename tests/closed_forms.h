// Light transport in closed form, by every strategy: all of them estimate the same, and the right thing. Each function
// is a test of a renderer, run on the reference and on the device.
#pragma once
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "reference/bsdf_oracle.h"
#include "reference/estimate.h"

namespace vkpt::test::closed_forms {

inline constexpr double kPi = std::numbers::pi;

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

/// Mean of the red channel, of one render.
inline double redOf(const Renderer& render, const SceneArrays& scene, const RenderOptions& options) {
    return meanOf(render(scene, options)(options.params.seed)).r;
}

/// Shines and reflects nothing.
inline Material lampOf(float nits) {
    Material m = bsdfMaterial("lambert:color=0");
    m.emissive = glm::vec3(nits);
    return m;
}

/// z = 0, seen from +z.
inline SceneBuilder groundOf(const Material& material) {
    SceneBuilder builder;
    builder.quad(builder.material(material), {-9, -9, 0}, {18, 0, 0}, {0, 18, 0});
    return builder;
}

inline SceneArrays furnaceOf(const Material& material) { return groundOf(material).build(glm::vec3(1)); }

/// A disc of radius r at height z that shines downwards, as a fan of triangles.
inline void addDisc(SceneBuilder& builder, const Material& material, float r, float z) {
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

/// A sphere of radius r about the origin, 8 x 4^levels triangles, as large as the sphere that it stands for.
inline void addSphere(SceneBuilder& builder, const Material& material, double r, bool inwards, int levels) {
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

/// A disc of radius r at height h gives the ground beneath its middle the irradiance pi L r^2 / (r^2 + h^2).
inline void discLightOverAPlane(const Renderer& render) {
    SceneBuilder builder = groundOf(bsdfMaterial("lambert:color=0.6"));
    const double side = 2 * kPi / 96, r2 = std::sin(side) / side;  // of the circle of the polygon's area
    addDisc(builder, lampOf(2), 1, 1);
    const double truth = 0.6 * 2 * r2 / (r2 + 1);
    const SceneArrays scene = builder.build();
    forEveryEstimator(viewAlongZ(1, 1e-3F, 128, 1, 0.5F), [&](const RenderOptions& options) {
        expectEstimates(estimate(render(scene, options), 32), truth, 2e-5);
    });
}

/// A black sphere of radius r that shines with L in the middle of a matte one of radius 1: the wall receives pi L r^2
/// at once, and 1 - r^2 of what it sends comes back to it. So its radiance is rho L r^2 / (1 - rho (1 - r^2)).
inline void sphereInsideASphere(const Renderer& render) {
    constexpr double kR = 0.5, kRho = 0.6;
    SceneBuilder builder;
    addSphere(builder, lampOf(3), kR, false, 3);
    addSphere(builder, bsdfMaterial("lambert:color=0.6"), 1, true, 4);
    const SceneArrays scene = builder.build();
    RenderOptions options = viewAlongZ(8, 0.5F, 8, 40, -0.7F);  // looks at the wall from between the spheres
    options.params.projection = kProjectionPerspective;
    options.params.rrMode = kRouletteThroughput;
    const double truth = kRho * 3 * kR * kR / (1 - kRho * (1 - kR * kR));
    for (const NamedId& strategy : kEveryStrategy) {
        SCOPED_TRACE(strategy.name);
        options.params.strategy = strategy.id;
        expectEstimates(estimate(render(scene, options), 24), truth, 3e-3);  // facets stand for the spheres
    }
}

/// No BSDF sample meets a point: all other strategies give the same to rounding, whatever draws the next direction.
inline void punctualLightsAreForLightSamplesAlone(const Renderer& render) {
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
            EXPECT_NEAR(redOf(render, scene, options), found, 1e-5);
        });
    }
}

/// Between the cones: clamp((cos - cosOuter) / (cosInner - cosOuter))^2. [KHR_lights_punctual]
inline void spotFallsOffBetweenItsCones(const Renderer& render) {
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
        EXPECT_NEAR(redOf(render, builder.light(light).build(), viewAlongZ(1, 1e-4F, 4, 1)), truth, 1e-5) << angle;
    }
}

/// Nothing is counted twice where a mirror shows a lamp, nor missed.
inline void aMirrorShowsALamp(const Renderer& render) {
    SceneBuilder builder = groundOf(metal(glm::vec3(1), 0));
    addDisc(builder, lampOf(2), 3, 6);
    const SceneArrays scene = builder.build();
    forEveryEstimator(viewAlongZ(2, 0.1F, 4, 1, 2),
                      [&](const RenderOptions& options) { EXPECT_NEAR(redOf(render, scene, options), 2, 1e-5); });
}

/// Under uniform light a surface shows its albedo, and all of its sky is open.
inline void furnaceShowsTheAlbedo(const Renderer& render) {
    const SceneArrays matteScene = furnaceOf(bsdfMaterial("lambert:color=0.8"));
    const SceneArrays metalScene = furnaceOf(metal({1, 0.7F, 0.3F}, 0.6F));
    const double metalAlbedo = gltfAlbedo({1, 0.7, 0.3}, 1, 0.6, 0.7).x;
    for (const IntegratorId integrator : {IntegratorId::Path, IntegratorId::Direct}) {
        RenderOptions options = viewAtAngle(0.7F, 0.5F, 32, 1);
        options.params.integrator = static_cast<std::uint32_t>(integrator);
        options.params.bsdfSamples = 2;
        forEveryEstimator(options, [&](const RenderOptions& o) {
            expectEstimates(estimate(render(matteScene, o), 8), 0.8, 1e-4);
            expectEstimates(estimate(render(metalScene, o), 8), metalAlbedo, 1e-3);
        });
    }
    RenderOptions open = viewAtAngle(0.7F, 0.5F, 32, 1);
    open.params.integrator = static_cast<std::uint32_t>(IntegratorId::Ao);
    for (const NamedId& hemisphere : kEveryHemisphere) {
        open.params.hemisphere = hemisphere.id;
        expectEstimates(estimate(render(metalScene, open), 8), 1);
    }
}

/// What an integrator shows of a matte plane of albedo 0.8 under uniform light, seen straight from 5 m above the middle
/// of its texture, 1 m of 18 wide. Of integrator cost only the number of nodes is known: the root alone.
inline glm::dvec3 truthInFurnace(IntegratorId integrator) {
    const double h = 0.5 / 18;  // half of what is seen, in units of the texture; the diagonal halves it
    switch (integrator) {
        case IntegratorId::Path:
        case IntegratorId::Direct:
        case IntegratorId::Albedo:
            return glm::dvec3(0.8);
        case IntegratorId::Ao:
            return glm::dvec3(1);
        case IntegratorId::Normal:
            return {0.5, 0.5, 1};
        case IntegratorId::Uv:
            return {0.5, 0.5, 0};
        case IntegratorId::Depth:
            return glm::dvec3(5);
        case IntegratorId::Barycentrics:
            return {0.5 - h / 3, 0.25 + h / 6, 0.25 + h / 6};
        case IntegratorId::Cost:
            return {1, 0, 0};
        case IntegratorId::LightProbability:  // mean over the sphere of 1 / (1 + 4 cos) above the plane, 0 below
            return glm::dvec3(std::log(5.0) / 8);
    }
    return glm::dvec3(-1);
}

inline void furnaceOfEveryIntegrator(const Renderer& render) {
    const SceneArrays lambert = furnaceOf(bsdfMaterial("lambert:color=0.8"));
    const SceneArrays gltf = furnaceOf(matte(glm::vec3(0.8F)));  // a model's own colour is no base colour
    for (const IntegratorInfo& integrator : kIntegrators) {
        SCOPED_TRACE(integrator.name);
        RenderOptions options = viewAlongZ(4, 0.5F, 128, 3);
        options.params.integrator = static_cast<std::uint32_t>(integrator.id);
        options.params.bsdfSamples = 2;
        const auto estimates = estimateRgb(render(integrator.id == IntegratorId::Albedo ? gltf : lambert, options), 8);
        const glm::dvec3 truth = truthInFurnace(integrator.id);
        for (int channel = 0; channel < (integrator.id == IntegratorId::Cost ? 1 : 3); ++channel) {
            const Estimate& e = estimates[static_cast<std::size_t>(channel)];
            EXPECT_NEAR(e.mean, truth[channel], 3 * e.standardError + 1e-5) << channel;
            EXPECT_LT(e.standardError, 0.01) << "too noisy to prove anything";
        }
    }
}

/// A closed room of white mirrors that glow: each of depth + 1 segments adds a nit. Roulette changes noise, not the
/// mean.
inline void rouletteKeepsTheMean(const Renderer& render) {
    Material glowing = metal(glm::vec3(1), 0);
    glowing.emissive = glm::vec3(1);
    SceneBuilder builder;
    const SceneArrays scene = builder.roomAround(builder.material(glowing), glm::vec3(0), 3).build();
    RenderOptions options = viewAlongZ(32, 1, 64, 4, 1);
    options.params.projection = kProjectionPerspective;
    options.params.rrMode = kRouletteFixed;
    options.params.rrFixed = 0.7F;
    options.params.rrDepth = 2;
    EXPECT_NEAR(redOf(render, scene, options), 5, 0.02);
    options.params.rrMode = kRouletteThroughput;  // throughput stays 1: nothing may die
    EXPECT_NEAR(redOf(render, scene, options), 5, 1e-3);
}

/// A closed room that glows and reflects 0.99: after D bounces (1 - 0.99^(D+1)) / 0.01 nits, and nothing is lost on the
/// way.
inline void energyOfAThousandBounces(const Renderer& render) {
    Material glowing = bsdfMaterial("lambert:color=0.99");
    glowing.emissive = glm::vec3(1);
    SceneBuilder builder;
    const SceneArrays scene = builder.roomAround(builder.material(glowing), glm::vec3(0), 3).build();
    RenderOptions options = viewAlongZ(4, 1, 4, 1000, 1);
    const double truth = (1 - std::pow(0.99, 1001)) / 0.01;
    options.params.strategy = kStrategyBsdf;  // every segment adds its glow: no path differs from another
    options.params.rrMode = kRouletteOff;
    const Estimate exact = estimate(render(scene, options), 2);
    EXPECT_NEAR(exact.mean, truth, 1e-4 * truth);
    EXPECT_LT(exact.standardError, 1e-5 * truth);
    for (const std::uint32_t roulette : {kRouletteThroughput, kRouletteFixed}) {
        setRoulette(options.params, roulette);
        options.params.rrDepth = 3;
        options.params.rrFixed = 0.99F;
        options.params.spp = options.sampleEnd = 32;
        expectEstimates(estimate(render(scene, options), 8), truth, 1e-4);
    }
    options.params.strategy = kStrategyMisPower;
    options.params.rrMode = kRouletteOff;
    options.params.spp = options.sampleEnd = 2;
    expectEstimates(estimate(render(scene, options), 8), truth, 1e-4);
}

}  // namespace vkpt::test::closed_forms
