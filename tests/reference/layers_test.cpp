// What the film's layers say of scenes whose answers are known.
#include "reference/layers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "film/layer_images.h"
#include "reference/accumulate.h"
#include "test_scene.h"

namespace vkpt {
namespace {

using namespace test;

Film renderLayers(const SceneArrays& scene, RenderOptions options) {
    options.aovs = kAllAovs;
    options.params.backgroundMode = kBackgroundTransparent;
    return renderReference(scene, options);
}

const LayerImage& layerOf(const std::vector<LayerImage>& layers, Aov aov) {
    return layers[static_cast<std::size_t>(aov)];
}

/// A quad over the left half of the view, z = -2, another behind it over the right half but for its upper quarter.
struct TwoQuads {
    SceneArrays scene;
    Film film;
    std::vector<LayerImage> layers;

    TwoQuads() {
        SceneBuilder builder;
        builder.quad(builder.material(matte({0.25F, 0.5F, 0.75F})), {-1, -1, -2}, {1, 0, 0}, {0, 2, 0});
        builder.quad(builder.material(matte({0.125F, 0, 1})), {0, -1, -4}, {1, 0, 0}, {0, 1.5F, 0});
        scene = builder.build();
        film = renderLayers(scene, viewAlongZ(8, 1, 16, 1));
        layers = layerImages(film);
    }
    [[nodiscard]] glm::vec3 at(Aov aov, std::uint32_t x, std::uint32_t y) const {
        const Image& image = layerOf(layers, aov).image;
        glm::vec3 value(0);
        for (std::uint32_t c = 0; c < std::min(image.channels, 3U); ++c) value[static_cast<int>(c)] = image.at(x, y)[c];
        return value;
    }
    [[nodiscard]] std::uint32_t number(Aov aov, std::uint32_t x, std::uint32_t y) const {
        return layerOf(layers, aov).numbers[y * 8 + x];
    }
};

TEST(Layers, DescribeTheFirstSurface) {
    const TwoQuads t;
    EXPECT_EQ(t.at(Aov::Albedo, 1, 4), glm::vec3(0.25F, 0.5F, 0.75F));
    EXPECT_EQ(t.at(Aov::Albedo, 6, 4), glm::vec3(0.125F, 0, 1));
    EXPECT_LT(glm::distance(t.at(Aov::Normal, 1, 4), glm::vec3(0, 0, 1)), 1e-4F);
    EXPECT_NEAR(t.at(Aov::Depth, 1, 4).x, 7, 1e-5F) << "from the camera at z = 5";
    EXPECT_NEAR(t.at(Aov::Depth, 6, 4).x, 9, 1e-5F);
    const glm::vec3 p = t.at(Aov::Position, 2, 6);  // pixel centre (2.5, 6.5) of 8: x = -0.375, y = -0.625
    EXPECT_NEAR(p.x, -0.375F, 0.04F);
    EXPECT_NEAR(p.y, -0.625F, 0.04F);
    EXPECT_NEAR(p.z, -2, 1e-5F);
    const glm::vec3 uv = t.at(Aov::Uv, 2, 6);
    EXPECT_NEAR(uv.x, p.x + 1, 1e-5F);
    EXPECT_NEAR(uv.y, (p.y + 1) / 2, 1e-5F);
    EXPECT_EQ(uv.z, 1);
}

TEST(Layers, NumbersTellSurfacesApart) {
    const TwoQuads t;
    EXPECT_EQ(t.number(Aov::Material, 1, 4), 0U);
    EXPECT_EQ(t.number(Aov::Material, 6, 4), 1U);
    EXPECT_EQ(t.number(Aov::Instance, 1, 4), 0U);
    EXPECT_EQ(t.number(Aov::Instance, 6, 4), 1U);
    EXPECT_LT(t.number(Aov::Primitive, 1, 4), 2U);
    EXPECT_EQ(t.number(Aov::Primitive, 6, 4) / 2, 1U);
    for (const Aov aov : {Aov::Material, Aov::Instance, Aov::Primitive}) EXPECT_EQ(t.number(aov, 6, 0), kNone);
    for (const std::uint32_t samples : layerOf(t.layers, Aov::Samples).numbers) ASSERT_EQ(samples, 16U);
}

TEST(Layers, NothingIsNothing) {
    const TwoQuads t;
    for (const Aov aov : {Aov::Albedo, Aov::Normal, Aov::Depth, Aov::Position, Aov::Uv, Aov::Alpha, Aov::Variance})
        EXPECT_EQ(t.at(aov, 6, 0), glm::vec3(0));
    EXPECT_EQ(t.at(Aov::Alpha, 6, 4).x, 1);
}

// A pixel that two surfaces share: albedo, normal and alpha are those of all samples, depth that of the hits.
TEST(Layers, PartlyCoveredPixels) {
    SceneBuilder builder;
    builder.quad(builder.material(matte(glm::vec3(1))), {-1, -1, -2}, {1.0625F, 0, 0}, {0, 2, 0});  // to x = 1/16
    const Film film = renderLayers(builder.build(), viewAlongZ(8, 1, 64, 0));
    const auto layers = layerImages(film);
    const float alpha = layerOf(layers, Aov::Alpha).image.at(4, 3)[0];
    EXPECT_EQ(alpha, 0.25F) << "a quarter of the pixel: 16 of 64 stratified samples";
    EXPECT_EQ(layerOf(layers, Aov::Albedo).image.at(4, 3)[0], alpha);
    EXPECT_NEAR(layerOf(layers, Aov::Normal).image.at(4, 3)[2], alpha, 1e-4F);
    EXPECT_NEAR(layerOf(layers, Aov::Depth).image.at(4, 3)[0], 7, 1e-5F);
    EXPECT_EQ(layerOf(layers, Aov::Uv).image.at(4, 3)[2], alpha);
}

TEST(Layers, NormalsFaceTheCameraOnBothSides) {
    SceneBuilder builder;
    Material twoSided = matte(glm::vec3(0.5F));
    twoSided.doubleSided = true;
    builder.quad(builder.material(twoSided), {-1, -1, 0}, {0, 2, 0}, {2, 0, 0});  // front to -z
    const auto layers = layerImages(renderLayers(builder.build(), viewAlongZ(4, 1, 2, 0)));
    EXPECT_GT(layerOf(layers, Aov::Normal).image.at(1, 1)[2], 0.999F);
}

TEST(Layers, VarianceIsThatOfSinglePaths) {
    // Half of each pixel's paths see 4 nits, the others nothing: luminance has mean 2 and variance 4 n / (n - 1).
    SceneBuilder builder;
    for (int i = 0; i < 8; ++i)
        builder.quad(builder.material(emitter(glm::vec3(4))), {-1 + 0.25F * static_cast<float>(i), -1, 0},
                     {0.125F, 0, 0}, {0, 2, 0});
    const Film film = renderLayers(builder.build(), viewAlongZ(8, 1, 64, 0));
    const auto layers = layerImages(film);
    for (std::uint32_t i = 0; i < 64; ++i)
        ASSERT_FLOAT_EQ(layerOf(layers, Aov::Variance).image.pixels[i], 4.0F * 64 / 63) << i;
    EXPECT_EQ(pathsWithoutVariance(film), 0U);
}

TEST(Layers, PathsBeyondTheVariancesRangeAreCounted) {
    SceneBuilder builder;
    builder.quad(builder.material(emitter(glm::vec3(0x1p33F))), {-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
    const Film film = renderLayers(builder.build(), viewAlongZ(4, 1, 3, 0));
    EXPECT_EQ(pathsWithoutVariance(film), 4U * 4 * 3);
    EXPECT_EQ(layerOf(layerImages(film), Aov::Variance).image.pixels[5], 0);
    EXPECT_EQ(film.refused, 0U) << "the picture takes them";
}

TEST(Layers, ValuesBeyondTheirRangeAreRefusedWholeAndCounted) {
    SceneBuilder builder;
    Primitive p;
    p.material = builder.material(matte(glm::vec3(0.5F)));
    p.positions = {{-1, -1, 0}, {3, -1, 0}, {-1, 3, 0}};
    p.normals.assign(3, {0, 0, 1});
    p.uv0 = {{0x1p33F, 0}, {0x1p33F, 1}, {0x1p33F, 2}};
    p.triangles = {{0, 1, 2}};
    builder.mesh({std::move(p)}, glm::mat4(1));
    const Film film = renderLayers(builder.build(), viewAlongZ(4, 1, 2, 0));
    EXPECT_EQ(film.refusedInLayers, 4U * 4 * 2);
    const auto layers = layerImages(film);
    EXPECT_EQ(layerOf(layers, Aov::Uv).image.at(1, 1)[0], 0);
    EXPECT_EQ(layerOf(layers, Aov::Uv).image.at(1, 1)[1], 0);
    EXPECT_EQ(layerOf(layers, Aov::Albedo).image.at(1, 1)[0], 0.5F);
}

TEST(Layers, RangesInAnyOrderAndThreadsChangeNothing) {
    SceneBuilder builder;
    builder.quad(builder.material(matte({0.3F, 0.6F, 0.9F})), {-3, -3, -1}, {7, 0, 1}, {0, 7, 2});
    const SceneArrays scene = builder.build(glm::vec3(0.7F));
    RenderOptions options = viewAlongZ(12, 2, 12, 3);
    const Film whole = renderLayers(scene, options);
    Film sum(12, 12, kAllAovs);
    for (const SampleRange range : {SampleRange{7, 12}, SampleRange{0, 2}, SampleRange{2, 7}}) {
        options.sampleBegin = range.begin;
        options.sampleEnd = range.end;
        addFilm(sum, renderLayers(scene, options));
    }
    EXPECT_EQ(sum.layers, whole.layers);
    EXPECT_EQ(sum.ranges, whole.ranges);
    options = viewAlongZ(12, 2, 12, 3);
    options.aovs = kAllAovs;
    options.params.backgroundMode = kBackgroundTransparent;
    EXPECT_EQ(renderReference(scene, options, {}, {.threads = 1}).layers, whole.layers);
}

TEST(Layers, LeaveThePictureAsItIs) {
    SceneBuilder builder;
    builder.quad(builder.material(matte({0.3F, 0.6F, 0.9F})), {-3, -3, -1}, {7, 0, 1}, {0, 7, 2});
    const SceneArrays scene = builder.build(glm::vec3(0.7F));
    RenderOptions options = viewAlongZ(12, 2, 12, 3);
    options.params.backgroundMode = kBackgroundTransparent;
    EXPECT_EQ(filmToImage(renderReference(scene, options)).pixels, filmToImage(renderLayers(scene, options)).pixels);
}

}  // namespace
}  // namespace vkpt
