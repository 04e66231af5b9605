// Materials, texture slots, samplers, texture transforms.
#include <cmath>

#include "builder.h"

namespace vkpt::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kGreyPixel =
    "data:image/png;base64,"
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGNoAAAAggCBd81ytgAAAABJRU5ErkJggg==";

// A triangle with `material`; textures 0 to 2 show images 0 to 2.
Builder withMaterial(const Json& material) {
    Builder b;
    Json& p = b.triangle();
    p["material"] = 0;
    for (const char* set : {"TEXCOORD_0", "TEXCOORD_1"}) p["attributes"][set] = b.vec2({0, 1, 1, 1, 0, 0});
    b.json["materials"] = {material};
    for (int i = 0; i < 3; ++i) {
        b.push("images", {{"uri", kGreyPixel}, {"name", "image " + std::to_string(i)}});
        b.push("textures", {{"source", i}});
    }
    return b;
}

Material imported(const Json& material) { return withMaterial(material).import().materials.at(0); }

TEST(Materials, DefaultsAreTheSpecifications) {
    Builder b;
    b.triangle();
    const Scene scene = b.import();
    ASSERT_EQ(scene.materials.size(), 1U);
    for (const Material& m : {scene.materials[0], imported(Json::object())}) {
        EXPECT_EQ(m.baseColor, glm::vec4(1));
        EXPECT_EQ(m.metallic, 1);
        EXPECT_EQ(m.roughness, 1);
        EXPECT_EQ(m.emissive, glm::vec3(0));
        EXPECT_EQ(m.alphaMode, AlphaMode::Opaque);
        EXPECT_FALSE(m.doubleSided);
        EXPECT_FALSE(m.unlit);
        EXPECT_EQ(m.baseColorTexture.image, -1);
    }
}

TEST(Materials, EveryFactor) {
    const Material m = imported(
        {{"name", "paint"},
         {"pbrMetallicRoughness",
          {{"baseColorFactor", {.1, .2, .3, .4}}, {"metallicFactor", .5}, {"roughnessFactor", .6}}},
         {"emissiveFactor", {1, .5, .25}},
         {"alphaMode", "MASK"},
         {"alphaCutoff", .7},
         {"doubleSided", true},
         {"extensions",
          {{"KHR_materials_emissive_strength", {{"emissiveStrength", 8}}}, {"KHR_materials_unlit", Json::object()}}}});
    EXPECT_EQ(m.name, "paint");
    EXPECT_EQ(m.baseColor, glm::vec4(.1F, .2F, .3F, .4F));
    EXPECT_EQ(m.metallic, .5F);
    EXPECT_EQ(m.roughness, .6F);
    EXPECT_EQ(m.emissive, glm::vec3(8, 4, 2));
    EXPECT_EQ(m.alphaMode, AlphaMode::Mask);
    EXPECT_EQ(m.alphaCutoff, .7F);
    EXPECT_TRUE(m.doubleSided);
    EXPECT_TRUE(m.unlit);
}

TEST(Materials, EverySlot) {
    const Scene scene =
        withMaterial({{"pbrMetallicRoughness",
                       {{"baseColorTexture", {{"index", 2}}}, {"metallicRoughnessTexture", {{"index", 0}}}}},
                      {"normalTexture", {{"index", 2}, {"scale", .5}}},
                      {"emissiveTexture", {{"index", 0}, {"texCoord", 1}}}})
            .import();
    const Material& m = scene.materials.at(0);
    // Image 1 has no use, so image 2 moves up.
    ASSERT_EQ(scene.images.size(), 2U);
    EXPECT_EQ(scene.images[1].name, "image 2");
    EXPECT_EQ(m.baseColorTexture.image, 1);
    EXPECT_EQ(m.metallicRoughnessTexture.image, 0);
    EXPECT_EQ(m.normalTexture.image, 1);
    EXPECT_EQ(m.normalScale, .5F);
    EXPECT_EQ(m.emissiveTexture.image, 0);
    EXPECT_EQ(m.emissiveTexture.uvSet, 1U);
    EXPECT_EQ(m.baseColorTexture.wrapS, Wrap::Repeat);
    EXPECT_FALSE(m.baseColorTexture.nearest);
    EXPECT_EQ(m.baseColorTexture.rowU, glm::vec3(1, 0, 0));
}

TEST(Materials, SamplersWrapAndFilter) {
    Builder b = withMaterial({{"emissiveTexture", {{"index", 0}}}});
    b.json["textures"][0]["sampler"] = 0;
    b.json["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}, {"minFilter", 9987}}};
    TextureUse use = b.import().materials[0].emissiveTexture;
    EXPECT_EQ(use.wrapS, Wrap::ClampToEdge);
    EXPECT_EQ(use.wrapT, Wrap::MirroredRepeat);
    EXPECT_TRUE(use.nearest);
    b.json["samplers"] = {{{"magFilter", 9729}}};
    use = b.import().materials[0].emissiveTexture;
    EXPECT_EQ(use.wrapS, Wrap::Repeat);
    EXPECT_FALSE(use.nearest);
    b.json["samplers"] = {{{"wrapS", 5}}};
    EXPECT_THAT(faultOf(b), HasSubstr("samplers[0].wrapS"));
}

// Offset, rotation and scale together: scale first, then a rotation that is counter-clockwise where V points down.
TEST(Materials, TextureTransform) {
    const auto use =
        imported({{"emissiveTexture",
                   {{"index", 0},
                    {"texCoord", 0},
                    {"extensions",
                     {{"KHR_texture_transform",
                       {{"offset", {.5, .25}}, {"rotation", std::acos(0.0)}, {"scale", {2, 3}}, {"texCoord", 1}}}}}}}})
            .emissiveTexture;
    EXPECT_EQ(use.uvSet, 1U) << "the extension's texCoord overrides";
    expectNear(use.rowU, {0, 3, .5});
    expectNear(use.rowV, {-2, 0, .25});
}

TEST(Materials, AlphaModes) {
    EXPECT_EQ(imported({{"alphaMode", "BLEND"}}).alphaMode, AlphaMode::Blend);
    EXPECT_EQ(imported({{"alphaMode", "MASK"}}).alphaCutoff, 0.5F);
    EXPECT_THAT(faultOf(withMaterial({{"alphaMode", "GLASS"}})), HasSubstr("materials[0].alphaMode: \"GLASS\""));
}

TEST(Materials, SlotsThatCannotBeReadAreLeftOutWithAWarning) {
    Scene scene = withMaterial({{"emissiveTexture", {{"index", 0}, {"texCoord", 2}}}}).import();
    EXPECT_EQ(scene.materials[0].emissiveTexture.image, -1);
    EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("materials[0].emissiveTexture: left out; TEXCOORD_2")));

    Builder b = withMaterial({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    b.json["textures"][0] = {{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}};
    scene = b.import();
    EXPECT_EQ(scene.materials[0].baseColorTexture.image, -1);
    EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("textures[0] has no PNG or JPEG source")));
}

TEST(Materials, OnlyThoseInUseAreKeptAndTheDefaultComesLast) {
    Builder b;
    for (int i = 0; i < 3; ++i) b.triangle();
    for (const char* name : {"unused", "b", "c"}) b.push("materials", {{"name", name}});
    b.json["meshes"][0]["primitives"][0]["material"] = 2;
    b.json["meshes"][2]["primitives"][0]["material"] = 1;
    const Scene scene = b.import();
    ASSERT_EQ(scene.materials.size(), 3U);
    EXPECT_EQ(scene.materials[0].name, "b");
    EXPECT_EQ(scene.materials[1].name, "c");
    EXPECT_EQ(scene.meshes[0].primitives[0].material, 1U);
    EXPECT_EQ(scene.meshes[1].primitives[0].material, 2U);
    EXPECT_EQ(scene.meshes[2].primitives[0].material, 0U);
}

TEST(MaterialsBsdf, AreReadAndFaultsNameMaterialAndField) {
    const auto withBsdf = [](const Json& bsdf) {
        return withMaterial({{"name", "brush"}, {"extensions", {{"VKPT_materials_bsdf", bsdf}}}});
    };
    const Json brushed{{"model", "conductor"}, {"metal", "Au"}, {"alpha", {0.1, 0.3}}, {"distribution", "beckmann"}};
    const Material m = withBsdf(brushed).import().materials.at(0);
    ASSERT_TRUE(m.bsdf);
    EXPECT_EQ(*m.bsdf, parseBsdfSpec("conductor:metal=Au,alpha=0.1/0.3,distribution=beckmann"));
    EXPECT_FALSE(imported(Json::object()).bsdf);

    const Material ours = withBsdf({{"model", "gltf"}, {"metallic", 0}, {"roughness", 0.25}}).import().materials.at(0);
    EXPECT_FALSE(ours.bsdf);
    EXPECT_EQ(ours.roughness, 0.25F);

    const auto faultOfBsdf = [&](const Json& bsdf) { return faultOf(withBsdf(bsdf)); };
    EXPECT_THAT(faultOfBsdf({{"model", "conductor"}, {"alpha", 7}}),
                HasSubstr("materials[0].extensions.VKPT_materials_bsdf.alpha: 7 is not within 0 and 1"));
    EXPECT_THAT(faultOfBsdf(Json::array()),
                HasSubstr("materials[0].extensions.VKPT_materials_bsdf: must be an object"));
    EXPECT_THAT(faultOfBsdf(Json::object()),
                HasSubstr("materials[0].extensions.VKPT_materials_bsdf.model: is missing"));
}

}  // namespace
}  // namespace vkpt::test
