// Hierarchy, scenes, cameras, lights.
#include "gltf/nodes.h"

#include <cmath>

#include "builder.h"

namespace vkpt::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kHalf = 0.70710678118654752;  // sin and cos of 45 degrees

glm::vec3 placed(const Scene& scene, const glm::vec3& p, std::size_t instance = 0) {
    return glm::vec3(scene.instances.at(instance).worldFromObject * glm::vec4(p, 1));
}

TEST(Nodes, ScaleThenRotateThenTranslate) {
    Builder b;
    b.triangle();
    b.json["nodes"][0].update({{"translation", {10, 0, 0}}, {"rotation", {0, 0, kHalf, kHalf}}, {"scale", {2, 3, 4}}});
    expectNear(placed(b.import(), {1, 1, 1}), {7, 2, 4}, 1e-5F);  // (2,3,4) -> (-3,2,4) -> (7,2,4)
}

TEST(Nodes, MatricesAreColumnMajor) {
    Builder b;
    b.triangle();
    b.json["nodes"][0]["matrix"] = {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1};
    expectNear(placed(b.import(), {1, 0, 0}), {5, 7, 7});
}

TEST(Nodes, ParentsApplyAfterChildren) {
    Builder b;
    b.triangle();
    b.json["nodes"].push_back({{"children", {0}}, {"rotation", {0, 0, kHalf, kHalf}}});
    b.json["nodes"][0]["translation"] = {1, 0, 0};
    b.json["scenes"][0]["nodes"] = {1};
    expectNear(placed(b.import(), {0, 0, 0}), {0, 1, 0});
}

TEST(Nodes, NegativeScaleIsKept) {
    Builder b;
    b.triangle();
    b.json["nodes"][0]["scale"] = {-1, 1, 1};
    EXPECT_LT(glm::determinant(glm::mat3(b.import().instances.at(0).worldFromObject)), 0);
}

TEST(Nodes, RotationsAreUnitUpToRounding) {
    Builder b;
    b.triangle();
    b.json["nodes"][0]["rotation"] = {0, 0, 0.709, 0.709};
    expectNear(placed(b.import(), {1, 0, 0}), {0, 1, 0});
    for (const Json& rotation : {Json{0, 0, 0, 0}, Json{0, 0, 0.8, 0.8}}) {
        b.json["nodes"][0]["rotation"] = rotation;
        EXPECT_THAT(faultOf(b), HasSubstr("nodes[0]: rotation is no unit quaternion"));
    }
}

TEST(Nodes, AMatrixStandsAloneAndIsOneOfTranslationRotationAndScale) {
    const auto fault = [](const Json& node) {
        Builder b;
        b.json["nodes"] = {node};
        return faultOf(b);
    };
    const Json identity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    EXPECT_THAT(fault({{"matrix", identity}, {"scale", {1, 1, 1}}}), HasSubstr("nodes[0]: has a matrix beside"));
    Json sheared = identity, projective = identity;
    sheared[4] = 0.5;
    projective[3] = 0.5;
    EXPECT_THAT(fault({{"matrix", sheared}}), HasSubstr("nodes[0]: its matrix shears"));
    EXPECT_THAT(fault({{"matrix", projective}}), HasSubstr("nodes[0]: the last row of its matrix"));
}

TEST(Nodes, OneMeshManyInstances) {
    Builder b;
    b.triangle();
    b.json["meshes"][0]["name"] = "mesh";
    b.json["nodes"].push_back({{"mesh", 0}, {"name", "second"}, {"translation", {3, 0, 0}}});
    b.json["scenes"][0]["nodes"] = {1, 0};
    const Scene scene = b.import();
    EXPECT_EQ(scene.meshes.size(), 1U);
    ASSERT_EQ(scene.instances.size(), 2U);
    EXPECT_EQ(scene.instances[0].name, "second");
    EXPECT_EQ(scene.instances[1].name, "mesh");
}

TEST(Nodes, DeepHierarchyNeedsNoStack) {
    Builder b;
    b.triangle();
    constexpr int kDepth = 50000;
    for (int i = 1; i <= kDepth; ++i) b.json["nodes"].push_back({{"children", {i - 1}}, {"translation", {1, 0, 0}}});
    b.json["scenes"][0]["nodes"] = {kDepth};
    expectNear(placed(b.import(), {0, 0, 0}), {kDepth, 0, 0});
}

TEST(Nodes, CyclesAndSharedChildrenAreRefused) {
    Builder b;
    b.triangle();
    b.json["nodes"].push_back({{"children", {0}}});
    b.json["nodes"][0]["children"] = {1};
    EXPECT_THAT(faultOf(b), HasSubstr("nodes[0]: is reached twice"));
    b.json.erase("scenes");
    EXPECT_THAT(faultOf(b), HasSubstr("there is a cycle"));

    Builder shared;
    shared.triangle();
    for (int i = 0; i < 2; ++i) shared.json["nodes"].push_back({{"children", {0}}});
    shared.json["scenes"][0]["nodes"] = {1, 2};
    EXPECT_THAT(faultOf(shared), HasSubstr("nodes[0]: is reached twice"));
}

TEST(Nodes, TransformsMustStayFinite) {
    Builder b;
    b.triangle();
    b.json["nodes"][0]["scale"] = {1e30, 1, 1};
    b.json["nodes"].push_back({{"children", {0}}, {"scale", {1e30, 1, 1}}});
    b.json["scenes"][0]["nodes"] = {1};
    EXPECT_THAT(faultOf(b), HasSubstr("nodes[0]: its transform is not finite"));
}

// Scene 0 places a triangle, scene 1 nothing, scene 2 two.
Builder threeScenes() {
    Builder b;
    for (int i = 0; i < 3; ++i) b.triangle();
    b.json["scenes"] = {{{"nodes", {0}}}, Json::object(), {{"nodes", {2, 1}}}};
    b.json["scene"] = 2;
    return b;
}

TEST(Scenes, DefaultAndChosen) {
    EXPECT_EQ(threeScenes().import().instances.size(), 2U);
    EXPECT_EQ(threeScenes().import({.scene = 0}).instances.size(), 1U);
    EXPECT_EQ(threeScenes().import({.scene = 1}).instances.size(), 0U);
    EXPECT_THAT(faultOf([] { (void)threeScenes().import({.scene = 3}); }),
                HasSubstr("scene 3 does not exist; the file has 3"));
    Builder undefined = threeScenes();
    undefined.json.erase("scene");
    EXPECT_EQ(undefined.import().instances.size(), 1U) << "without a default, the first";
}

TEST(Scenes, OnlyMeshesOfTheChosenSceneAreKept) {
    Builder b = threeScenes();
    b.json["meshes"][0]["primitives"][0]["indices"] = b.accessor<std::uint8_t>({0, 1, 99}, "SCALAR", 1);
    EXPECT_EQ(b.import().meshes.size(), 2U);
    EXPECT_THAT(faultOf([&] { (void)b.import({.scene = 0}); }), HasSubstr("meshes[0]"));
}

TEST(Scenes, WithoutScenesAllRootsShow) {
    Builder b = threeScenes();
    b.json.erase("scenes");
    b.json.erase("scene");
    b.json["nodes"][0]["children"] = {2};
    const Scene scene = b.import();
    EXPECT_EQ(scene.instances.size(), 3U);
    EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("no scene")));
}

TEST(Scenes, NothingAtAll) {
    const Scene scene = Builder().import();
    EXPECT_TRUE(scene.instances.empty());
    EXPECT_EQ(scene.materials.size(), 1U) << "there is always a material";
}

TEST(Cameras, PerspectiveAndOrthographic) {
    Builder b;
    b.json["cameras"] = {
        {{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}, {"aspectRatio", 2}}}},
        {{"type", "orthographic"},
         {"name", "plan"},
         {"orthographic", {{"xmag", 6}, {"ymag", 3}, {"znear", 0.1}, {"zfar", 9}}}}};
    b.json["nodes"] = {{{"camera", 0}, {"name", "eye"}, {"translation", {1, 2, 3}}, {"scale", {2, 2, 2}}},
                       {{"camera", 1}},
                       {{"camera", 0}}};
    b.json["scenes"] = {{{"nodes", {0, 1, 2}}}};
    const Scene scene = b.import();
    ASSERT_EQ(scene.cameras.size(), 3U);
    EXPECT_EQ(scene.cameras[0].name, "eye");
    EXPECT_FLOAT_EQ(scene.cameras[0].yfov, 0.5F);
    EXPECT_EQ(scene.cameras[0].aspect, 2.0F);
    expectNear(glm::vec3(scene.cameras[0].worldFromCamera[3]), {1, 2, 3});
    expectNear(glm::vec3(scene.cameras[0].worldFromCamera[1]), {0, 1, 0});
    EXPECT_EQ(scene.cameras[1].name, "plan");
    EXPECT_TRUE(scene.cameras[1].orthographic);
    EXPECT_EQ(scene.cameras[1].ymag, 3);
    EXPECT_EQ(scene.cameras[1].aspect, 2.0F);
}

TEST(Cameras, Faults) {
    const auto fault = [](const Json& camera) {
        Builder b;
        b.json["cameras"] = {camera};
        b.json["nodes"] = {{{"camera", 0}}};
        return faultOf(b);
    };
    EXPECT_THAT(fault({{"type", "fisheye"}}), HasSubstr("cameras[0]: must be perspective or orthographic"));
    EXPECT_THAT(fault({{"type", "perspective"}}), HasSubstr("cameras[0]"));
    EXPECT_THAT(fault({{"type", "perspective"}, {"perspective", {{"yfov", 4}}}}),
                HasSubstr("cameras[0].perspective.yfov"));
    EXPECT_THAT(fault({{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 0}}}}),
                HasSubstr("must not be 0"));
    EXPECT_THAT(fault({{"type", "perspective"}, {"perspective", {{"yfov", 0}}}}),
                HasSubstr("cameras[0].perspective.yfov: 0 is not greater than 0"));
    EXPECT_THAT(
        fault({{"type", "perspective"}, {"perspective", {{"yfov", 1}}}, {"orthographic", {{"xmag", 1}, {"ymag", 1}}}}),
        HasSubstr("cameras[0]: has both"));
}

Builder withLights(Json lights) {
    Builder b;
    b.json["extensionsUsed"] = {"KHR_lights_punctual"};
    for (std::size_t i = 0; i < lights.size(); ++i)
        b.push("nodes", {{"translation", {i, 0, 0}},
                         {"scale", {3, 3, 3}},
                         {"extensions", {{"KHR_lights_punctual", {{"light", i}}}}}});
    b.json["extensions"]["KHR_lights_punctual"]["lights"] = std::move(lights);
    return b;
}

TEST(Lights, PointSpotDirectional) {
    const Scene scene =
        withLights({{{"type", "point"}, {"color", {1, 0.5, 0}}, {"intensity", 8}, {"range", 5}, {"name", "lamp"}},
                    {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.3}}}},
                    {{"type", "directional"}},
                    {{"type", "spot"}, {"spot", Json::object()}}})
            .import();
    ASSERT_EQ(scene.lights.size(), 4U);
    EXPECT_EQ(scene.lights[0].kind, PunctualKind::Point);
    EXPECT_EQ(scene.lights[0].name, "lamp");
    EXPECT_EQ(scene.lights[0].intensity, glm::vec3(8, 4, 0));
    EXPECT_EQ(scene.lights[0].range, 5);
    EXPECT_EQ(scene.lights[1].kind, PunctualKind::Spot);
    EXPECT_FLOAT_EQ(scene.lights[1].innerConeAngle, 0.2F);
    EXPECT_FLOAT_EQ(scene.lights[1].outerConeAngle, 0.3F);
    expectNear(glm::vec3(scene.lights[1].worldFromLight[3]), {1, 0, 0});
    expectNear(glm::vec3(scene.lights[1].worldFromLight[2]), {0, 0, 1});
    EXPECT_EQ(scene.lights[2].kind, PunctualKind::Directional);
    EXPECT_EQ(scene.lights[2].intensity, glm::vec3(1));
    EXPECT_EQ(scene.lights[2].range, 0);
    EXPECT_EQ(scene.lights[3].innerConeAngle, 0);
    EXPECT_FLOAT_EQ(scene.lights[3].outerConeAngle, 0.785398163F);
}

TEST(Lights, HardSpotsAndFaults) {
    const auto spot = [](double inner, double outer) {
        return Json{{{"type", "spot"}, {"spot", {{"innerConeAngle", inner}, {"outerConeAngle", outer}}}}};
    };
    EXPECT_EQ(withLights(spot(0.5, 0.5)).import().lights.at(0).innerConeAngle, 0.5F);
    EXPECT_THAT(faultOf(withLights(spot(0.6, 0.5))), HasSubstr("lights[0]: innerConeAngle is greater"));
    EXPECT_THAT(faultOf(withLights(spot(0.5, 2))), HasSubstr("lights[0].spot.outerConeAngle: 2 is not between"));
    EXPECT_THAT(faultOf(withLights({{{"type", "spot"}}})), HasSubstr("lights[0]: is a spot without the object"));
    EXPECT_THAT(faultOf(withLights({{{"type", "area"}}})), HasSubstr("lights[0]: type is none of point, spot"));
    EXPECT_THAT(faultOf(withLights({{{"type", "point"}, {"range", 0}}})), HasSubstr("range: 0 is not greater than 0"));
    EXPECT_THAT(faultOf(withLights({{{"type", "point"}, {"intensity", -1}}})), HasSubstr("intensity: -1 is not 0"));
    Builder b = withLights({{{"type", "point"}}});
    b.json["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 4;
    EXPECT_THAT(faultOf(b), HasSubstr("nodes[0].extensions.KHR_lights_punctual.light: 4"));
    b.json.erase("extensions");
    EXPECT_THAT(faultOf(b), HasSubstr("the file has 0 lights"));
}

}  // namespace
}  // namespace vkpt::test
