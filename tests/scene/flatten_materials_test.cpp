#include <gtest/gtest.h>

#include "scene_builder.h"

namespace vkpt {
namespace {

Scene texturedScene() {
    Scene scene = sceneOf(trianglePrimitive());
    scene.images = {imageOf(4, 2, 0xff112233U), imageOf(3, 1, 0xffffffffU), imageOf(8, 8, 0)};
    return scene;
}

bool hasAlpha(const Scene& scene) {
    const SceneArrays a = flatten(scene);
    EXPECT_EQ(a.features.alpha, (a.triangles.at(0).flags & kTriangleHasAlpha) != 0);
    return a.features.alpha;
}

TEST(FlattenMaterials, CarriesEveryFactor) {
    Scene scene = texturedScene();
    Material& m = scene.materials[0];
    m.name = "paint";
    m.baseColor = {0.1F, 0.2F, 0.3F, 0.4F};
    m.metallic = 0.5F;
    m.roughness = 0.6F;
    m.emissive = {7, 8, 9};
    m.normalScale = 0.7F;
    m.alphaMode = AlphaMode::Mask;
    m.alphaCutoff = 0.8F;
    m.doubleSided = true;
    const SceneArrays a = flatten(scene);
    const MaterialRecord& r = a.materials.at(0);
    EXPECT_EQ(r.baseColor, m.baseColor);
    EXPECT_EQ(r.metallic, 0.5F);
    EXPECT_EQ(r.roughness, 0.6F);
    EXPECT_EQ(r.emissive, m.emissive);
    EXPECT_EQ(r.normalScale, 0.7F);
    EXPECT_EQ(r.alphaCutoff, 0.8F);
    EXPECT_EQ(r.flags, kMaterialAlphaMask | kMaterialDoubleSided);
    EXPECT_EQ(r.baseColorTexture, kNone);
    EXPECT_EQ(a.materialNames.at(0), "paint");
    EXPECT_EQ(a.triangles[0].flags & kTriangleSingleSided, 0U);
}

TEST(FlattenMaterials, TriangleFlagsHoldMaterialAndSide) {
    Scene scene = sceneOf(trianglePrimitive(5));
    EXPECT_EQ(flatten(scene).triangles.at(0).flags, 5U << kTriangleMaterialShift | kTriangleSingleSided);
    scene.materials[5].doubleSided = true;
    EXPECT_EQ(flatten(scene).triangles.at(0).flags, 5U << kTriangleMaterialShift);
}

TEST(FlattenMaterials, TextureRecordsSayHowToRead) {
    Scene scene = texturedScene();
    Material& m = scene.materials[0];
    m.emissive = glm::vec3(1);
    m.baseColorTexture.image = 1;
    m.normalTexture.image = 0;
    m.metallicRoughnessTexture = {.image = 1,
                                  .wrapS = Wrap::MirroredRepeat,
                                  .wrapT = Wrap::ClampToEdge,
                                  .nearest = true,
                                  .uvSet = 1,
                                  .rowU = {2, 0, 0.5F},
                                  .rowV = {0, 3, 0.25F}};
    m.emissiveTexture.image = 1;
    const SceneArrays a = flatten(scene);
    const MaterialRecord& r = a.materials.at(0);
    const TextureRecord& rough = a.textures.at(r.metallicRoughnessTexture);
    EXPECT_EQ(rough.size, 3U | 1U << 16U);
    EXPECT_EQ(rough.flags,
              kTextureNearest | kTextureUv1 | kWrapMirror << kTextureWrapSShift | kWrapClamp << kTextureWrapTShift);
    EXPECT_EQ(rough.rowU, glm::vec4(2, 0, 0.5F, 0));
    EXPECT_EQ(rough.rowV, glm::vec4(0, 3, 0.25F, 0));
    EXPECT_EQ(a.textures.at(r.baseColorTexture).flags, kTextureSrgb);
    EXPECT_EQ(a.textures.at(r.emissiveTexture).flags, kTextureSrgb);
    EXPECT_EQ(a.textures.at(r.normalTexture).flags, 0U);
    EXPECT_EQ(a.features.maps, 15U);

    // Images once each, the unread one not at all, in whole words.
    EXPECT_EQ(a.textures.at(r.baseColorTexture).texels, rough.texels);
    EXPECT_EQ(a.texels.size(), 12U);
    EXPECT_EQ(a.texels.at(a.textures.at(r.normalTexture).texels + 7), 0xff112233U);
    EXPECT_EQ(a.texels.at(rough.texels + 2), 0xffffffffU);
}

TEST(FlattenMaterials, SlotsWithoutEffectAreLeftOut) {
    Scene scene = texturedScene();
    Material& m = scene.materials[0];
    m.emissiveTexture.image = 0;           // factor is 0
    m.metallicRoughnessTexture.image = 0;  // both factors are 0
    m.metallic = m.roughness = 0;
    m.baseColorTexture.image = 99;  // no such image
    EXPECT_TRUE(flatten(scene).textures.empty());

    m.unlit = true;
    m.normalTexture.image = 0;
    m.emissive = glm::vec3(1);
    const SceneArrays a = flatten(scene);
    EXPECT_TRUE(a.textures.empty());
    EXPECT_TRUE(a.features.unlit);
    EXPECT_TRUE(a.lights.empty());
}

TEST(FlattenMaterials, MaterialsNobodyUsesBringNoTexels) {
    Scene scene = texturedScene();
    scene.materials.push_back({});
    scene.materials[1].baseColorTexture.image = 2;
    const SceneArrays a = flatten(scene);
    EXPECT_EQ(a.materials.size(), 2U);
    EXPECT_TRUE(a.texels.empty());
    EXPECT_EQ(a.features.maps, 0U);
}

TEST(AlphaFlag, OnlyWhereAlphaCanMatter) {
    Scene scene = texturedScene();
    Material& m = scene.materials[0];
    m.baseColor.a = 0.4F;
    EXPECT_FALSE(hasAlpha(scene));  // OPAQUE ignores alpha
    m.alphaMode = AlphaMode::Blend;
    EXPECT_TRUE(hasAlpha(scene));
    m.alphaMode = AlphaMode::Mask;
    EXPECT_TRUE(hasAlpha(scene));
    m.alphaCutoff = 0.4F;  // present where alpha >= cutoff
    EXPECT_FALSE(hasAlpha(scene));
    m.alphaCutoff = 2;  // nothing ever passes
    m.baseColor.a = 1;
    EXPECT_TRUE(hasAlpha(scene));
}

TEST(AlphaFlag, AsksTextureAndVertexColours) {
    Scene scene = texturedScene();
    Material& m = scene.materials[0];
    m.alphaMode = AlphaMode::Blend;
    m.baseColorTexture.image = 0;
    EXPECT_FALSE(hasAlpha(scene));
    scene.images[0].texels[5] = 0xfe000000U;
    EXPECT_TRUE(hasAlpha(scene));
    scene.images[0].texels[5] = 0xff000000U;
    scene.meshes[0].primitives[0].colors.assign(3, glm::vec4(1));
    EXPECT_FALSE(hasAlpha(scene));
    scene.meshes[0].primitives[0].colors[2].a = 0.99F;
    EXPECT_TRUE(hasAlpha(scene));
}

}  // namespace
}  // namespace vkpt
