// BSDFs within paths: light that goes through surfaces, from both sides, with light samples and without.
#include <gtest/gtest.h>

#include "reference/test_scene.h"

namespace vkpt {
namespace {

Material of(std::string_view spec) {
    Material m;
    m.bsdf = parseBsdfSpec(spec);
    return m;
}

/// A cube about the origin, its fronts outside.
void addBox(test::SceneBuilder& builder, std::uint32_t material, float h) {
    const glm::vec3 x(2 * h, 0, 0), y(0, 2 * h, 0), z(0, 0, 2 * h), lo(-h), hi(h);
    builder.quad(material, lo, z, y).quad(material, lo, x, z).quad(material, lo, y, x);
    builder.quad(material, hi, -y, -z).quad(material, hi, -z, -x).quad(material, hi, -x, -y);
}

double renderInFurnace(const test::SceneBuilder& builder, std::uint32_t depth, std::uint32_t spp) {
    const EnvironmentMap white = constantEnvironment(glm::vec3(1));
    const SceneArrays scene = builder.build(&white, {.multiscatter = true});
    RenderOptions options = test::viewAlongZ(8, 0.45F, spp, depth);
    options.params.rrMode = kRouletteOff;
    const glm::dvec4 mean = test::meanOf(renderReference(scene, options));
    EXPECT_NEAR(mean.x, mean.z, 1e-6);
    return mean.x;
}

// What is lost entering by 1/eta^2 is regained leaving: a closed body of clear glass is invisible in uniform light.
TEST(DielectricPaths, ClearGlassIsInvisibleInUniformLight) {
    for (const std::string_view spec : {"dielectric", "dielectric:alpha=0.3", "dielectric:ior=diamond,alpha=0.1"}) {
        test::SceneBuilder builder;
        addBox(builder, builder.material(of(spec)), 0.5F);
        EXPECT_NEAR(renderInFurnace(builder, 200, 1024), 1, 0.01) << spec;
    }
}

// One rough boundary in white light: what passes is divided by eta^2, and light samples count from behind.
TEST(DielectricPaths, LightSamplesReachThroughARoughBoundary) {
    test::SceneBuilder builder;
    builder.quad(builder.material(of("dielectric:alpha=0.4")), {-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
    // At normal incidence 0.0387 is reflected (with interreflection), the rest passes.
    EXPECT_NEAR(renderInFurnace(builder, 1, 256), 0.0387 + (1 - 0.0387) / 2.25, 6e-3);
}

TEST(DielectricPaths, FromBehindTheIndexIsInverted) {
    test::SceneBuilder builder;
    builder.quad(builder.material(of("dielectric")), {-1, -1, 0}, {0, 2, 0}, {2, 0, 0});  // its front faces -z
    EXPECT_NEAR(renderInFurnace(builder, 1, 64), 0.04 + 0.96 * 2.25, 0.03);
}

TEST(EveryBsdfPath, WhiteModelsReflectWhatTheirAlbedoIs) {
    struct Case {
        std::string_view spec;
        double albedo;
    };
    for (const Case& c :
         {Case{"lambert:color=0.5", 0.5}, Case{"mirror:color=0.5", 0.5}, Case{"eon:color=1", 1.0},
          Case{"phong:color=0.6,diffuse=0.3,exponent=30", 0.9},
          Case{"blinn_phong:color=0.6,diffuse=0.3,exponent=30", 0.9}, Case{"plastic:diffuse=1,alpha=0.2", 1.0},
          Case{"gltf:roughness=0.6", 1.0}, Case{"gltf:metallic=1,roughness=0.9", 1.0}}) {
        test::SceneBuilder builder;
        builder.quad(builder.material(of(c.spec)), {-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
        EXPECT_NEAR(renderInFurnace(builder, 1, 128), c.albedo, 0.01) << c.spec;
    }
}

}  // namespace
}  // namespace vkpt
