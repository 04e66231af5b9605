// Where texels lie: maps of a material that are read alike side by side, each image once.
#include <gtest/gtest.h>

#include "scene_builder.h"

namespace vkpt {
namespace {

/// `materials` materials, each on a triangle of its own, and images whose texels all differ.
Scene mappedScene(std::size_t materials, const std::vector<glm::uvec2>& sizes) {
    Scene scene = sceneOf(trianglePrimitive());
    for (std::uint32_t m = 1; m < materials; ++m) scene.meshes[0].primitives.push_back(trianglePrimitive(m));
    scene.materials.resize(materials);
    for (Material& m : scene.materials) m.emissive = glm::vec3(1);
    std::uint32_t texel = 1;
    for (const glm::uvec2& size : sizes) {
        scene.images.push_back(imageOf(size.x, size.y, 0));
        for (std::uint32_t& t : scene.images.back().texels) t = texel++;
    }
    return scene;
}

std::uint32_t setsOf(const SceneArrays& a, std::size_t material) {
    return a.materials.at(material).flags >> kMaterialMapSetShift;
}

void expectTexels(const SceneArrays& a, std::uint32_t texture, const TextureImage& image) {
    ASSERT_LT(texture, a.textures.size());
    const TextureRecord& record = a.textures[texture];
    for (std::size_t i = 0; i < image.texels.size(); ++i)
        ASSERT_EQ(a.texels.at(record.texels + i * record.stride), image.texels[i]) << "texel " << i;
}

constexpr std::uint32_t roles(std::initializer_list<std::uint32_t> list) {
    std::uint32_t bits = 0;
    for (const std::uint32_t role : list) bits |= 1U << role;
    return bits;
}

TEST(TextureLayout, MapsOfOneMaterialLieSideBySide) {
    Scene scene = mappedScene(1, {{4, 2}, {4, 2}, {4, 2}, {4, 2}});
    Material& m = scene.materials[0];
    m.baseColorTexture.image = 2;
    m.metallicRoughnessTexture.image = 0;
    m.normalTexture.image = 3;
    m.emissiveTexture.image = 1;
    const SceneArrays a = flatten(scene);
    EXPECT_EQ(setsOf(a, 0), 15U);
    EXPECT_EQ(a.features.mapSets, 1U);
    EXPECT_EQ(a.texels.size(), 32U);
    const MaterialRecord& r = a.materials[0];
    const std::uint32_t order[] = {r.baseColorTexture, r.metallicRoughnessTexture, r.normalTexture, r.emissiveTexture};
    const int images[] = {2, 0, 3, 1};
    for (std::uint32_t role = 0; role < kMapRoles; ++role) {
        EXPECT_EQ(a.textures.at(order[role]).texels, role);
        EXPECT_EQ(a.textures[order[role]].stride, 4U);
        expectTexels(a, order[role], scene.images[static_cast<std::size_t>(images[role])]);
    }
}

TEST(TextureLayout, ASetLiesWithinOneWord) {
    Scene scene = mappedScene(3, {{3, 1}, {3, 3}, {3, 3}, {5, 1}, {5, 1}, {5, 1}});
    scene.materials[0].baseColorTexture.image = 0;
    scene.materials[1].normalTexture.image = 1;
    scene.materials[1].emissiveTexture.image = 2;
    scene.materials[2].baseColorTexture.image = 3;
    scene.materials[2].metallicRoughnessTexture.image = 4;
    scene.materials[2].normalTexture.image = 5;
    const SceneArrays a = flatten(scene);
    EXPECT_EQ(a.textures.at(a.materials[0].baseColorTexture).stride, 1U);
    EXPECT_EQ(a.textures.at(a.materials[1].normalTexture).stride, 2U);
    EXPECT_EQ(a.textures.at(a.materials[1].normalTexture).texels % 4, 0U);
    EXPECT_EQ(a.textures.at(a.materials[2].baseColorTexture).stride, 4U);
    EXPECT_EQ(a.textures.at(a.materials[2].baseColorTexture).texels % 4, 0U);
    expectTexels(a, a.materials[0].baseColorTexture, scene.images[0]);
    expectTexels(a, a.materials[1].emissiveTexture, scene.images[2]);
    expectTexels(a, a.materials[2].normalTexture, scene.images[5]);
}

TEST(TextureLayout, MapsReadDifferentlyMakeSetsOfTheirOwn) {
    Scene scene = mappedScene(1, {{4, 4}, {4, 4}, {2, 8}, {4, 4}});
    Material& m = scene.materials[0];
    m.baseColorTexture.image = 0;
    m.metallicRoughnessTexture.image = 1;
    m.metallicRoughnessTexture.wrapS = Wrap::MirroredRepeat;
    m.normalTexture.image = 2;
    m.emissiveTexture.image = 3;
    const SceneArrays a = flatten(scene);
    EXPECT_EQ(setsOf(a, 0),
              roles({kMapBaseColor, kMapEmissive}) | roles({kMapMetallicRoughness}) << 4U | roles({kMapNormal}) << 8U);
    EXPECT_EQ(a.features.mapSets, 3U);
    EXPECT_EQ(a.texels.size(), 64U);
}

TEST(TextureLayout, ImagesAreStoredOnceHoweverOftenTheyAreUsed) {
    Scene scene = mappedScene(3, {{4, 4}, {4, 4}, {4, 4}});
    for (Material& m : scene.materials) m.baseColorTexture.image = 0;
    scene.materials[0].normalTexture.image = 1;
    scene.materials[1].normalTexture.image = 1;    // the same set again
    scene.materials[2].normalTexture.image = 2;    // image 0 lies elsewhere already
    scene.materials[2].emissiveTexture.image = 0;  // one image in two roles
    const SceneArrays a = flatten(scene);
    EXPECT_EQ(setsOf(a, 0), roles({kMapBaseColor, kMapNormal}));
    EXPECT_EQ(setsOf(a, 1), setsOf(a, 0));
    EXPECT_EQ(setsOf(a, 2), roles({kMapBaseColor}) | roles({kMapNormal}) << 4U | roles({kMapEmissive}) << 8U);
    EXPECT_EQ(a.texels.size(), 48U);
    for (std::size_t m = 0; m < 3; ++m) {
        expectTexels(a, a.materials[m].baseColorTexture, scene.images[0]);
        expectTexels(a, a.materials[m].normalTexture, scene.images[m == 2 ? 2 : 1]);
    }
    expectTexels(a, a.materials[2].emissiveTexture, scene.images[0]);
}

}  // namespace
}  // namespace vkpt
