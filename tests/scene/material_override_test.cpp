// --material and --material-all, and what flattening makes of other models.
#include "scene/material_override.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "scene_builder.h"

namespace vkpt {
namespace {

using testing::HasSubstr;

Scene twoMaterials() {
    Scene scene = sceneOf(trianglePrimitive());
    scene.materials.resize(2);
    scene.materials[0].name = "paint";
    scene.materials[1].name = "glass";
    return scene;
}

std::string usageFault(const std::string& text) {
    Scene scene = twoMaterials();
    try {
        overrideMaterial(scene.materials, text);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::Usage);
        return error.what();
    }
    return "no fault";
}

TEST(MaterialOverride, ByNameByIndexOrAll) {
    Scene scene = twoMaterials();
    overrideMaterial(scene.materials, "glass=dielectric:ior=water");
    overrideMaterial(scene.materials, "0=lambert:color=0.25");
    EXPECT_EQ(scene.materials[0].bsdf, parseBsdfSpec("lambert:color=0.25"));
    EXPECT_EQ(scene.materials[1].bsdf, parseBsdfSpec("dielectric:ior=water"));
    scene.materials[0].unlit = true;
    overrideMaterials(scene.materials, "gltf:color=0.5,metallic=1,roughness=0.125");
    for (const Material& material : scene.materials) {
        EXPECT_FALSE(material.bsdf || material.unlit);
        EXPECT_EQ(material.metallic, 1);
        EXPECT_EQ(material.roughness, 0.125F);
        EXPECT_EQ(material.baseColor, glm::vec4(0.5F, 0.5F, 0.5F, 1));
    }
}

TEST(MaterialOverride, FaultsNameOptionAndMend) {
    EXPECT_EQ(usageFault("lambert"), "--material: 'lambert' is not NAME=SPEC");
    EXPECT_EQ(usageFault("wood=lambert"), "--material wood: the scene has no such material; it has 0 paint, 1 glass");
    EXPECT_EQ(usageFault("paint=lambert:color=7"), "--material lambert:color=7: color: 7.0 is not within 0 and 1");
}

TEST(FlattenBsdf, RecordsGroupsAndTables) {
    Scene scene = twoMaterials();
    EXPECT_TRUE(flatten(scene).bsdfs.empty());
    EXPECT_TRUE(flatten(scene).albedoTables.empty());
    EXPECT_EQ(flatten(scene, {.multiscatter = true}).albedoTables.size(), std::size_t{kAlbedoTableWords});

    overrideMaterial(scene.materials, "paint=dielectric:alpha=0.3");
    const SceneArrays a = flatten(scene, {.multiscatter = true});
    ASSERT_EQ(a.bsdfs.size(), 2U);
    EXPECT_EQ(a.bsdfs[0].table, std::uint32_t{kAlbedoTableWords});
    EXPECT_EQ(a.albedoTables.size(), std::size_t{3} * kAlbedoTableWords);
    EXPECT_EQ(a.features.bsdfModels, 1U << static_cast<std::uint32_t>(BsdfId::Dielectric));
    EXPECT_EQ(a.materials[0].flags >> kMaterialModelShift & kMaterialModelMask,
              static_cast<std::uint32_t>(BsdfId::Dielectric));
    for (const TriangleRecord& t : a.triangles) {
        EXPECT_EQ(t.flags >> kTriangleGroupShift & kTriangleGroupMask, kGroupMicrofacet);
        EXPECT_EQ(t.flags & kTriangleSingleSided, 0U) << "glass is seen from inside";
    }
    scene.materials[0].unlit = true;
    EXPECT_TRUE(flatten(scene).bsdfs.empty()) << "unlit has no BSDF";
}

}  // namespace
}  // namespace vkpt
