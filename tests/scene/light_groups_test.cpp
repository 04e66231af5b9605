// Which group the light of what belongs to, and what layers are called.
#include "scene/light_groups.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "scene/environment.h"
#include "scene/light_layers.h"
#include "scene_builder.h"

namespace vkpt {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using Names = std::vector<std::string>;

PunctualLight bulb(const std::string& name) {
    PunctualLight light;
    light.name = name;
    return light;
}

/// Lamps of one mesh by the names of their nodes, and a floor that does not shine between the first two.
Scene lamps(const Names& names) {
    Scene scene = sceneOf(trianglePrimitive());
    scene.materials[0].emissive = glm::vec3(3);
    scene.materials.push_back({});
    scene.meshes.push_back({"floor", {trianglePrimitive(1)}});
    scene.instances.clear();
    for (const std::string& name : names) {
        scene.instances.push_back({name, 0, glm::mat4(1)});
        if (scene.instances.size() == 1) scene.instances.push_back({"floor", 1, glm::mat4(1)});
    }
    return scene;
}

SceneArrays grouped(const Scene& scene, const Names& wanted = {}, bool background = false) {
    SceneArrays arrays = flatten(scene);
    groupLights(arrays, {true, wanted}, background, "file");
    return arrays;
}

std::string groupingFault(const Scene& scene, const Names& wanted = {}, ExitCode code = ExitCode::File) {
    try {
        (void)grouped(scene, wanted);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), code);
        return error.what();
    }
    return "none";
}

TEST(LightGroups, AreNamedAfterWhatShines) {
    Scene scene = lamps({"lamp", "sign"});
    scene.lights = {bulb("sun"), bulb("moon")};
    const LightGroups groups = grouped(scene).lightGroups;
    EXPECT_THAT(groups.names, ElementsAre("lamp", "sign", "sun", "moon"));
    EXPECT_THAT(groups.ofObject, ElementsAre(0, 0, 1)) << "the floor has none";
    EXPECT_THAT(groups.ofLight, ElementsAre(0, 1, 2, 3));
}

TEST(LightGroups, UnnamedOnesAreNumbered) {
    Scene scene = lamps({"", "lamp", ""});
    scene.lights = {bulb(""), bulb("sun"), bulb("")};
    EXPECT_THAT(grouped(scene).lightGroups.names, ElementsAre("mesh0", "lamp", "mesh3", "light0", "sun", "light2"));
}

TEST(LightGroups, OneNameIsOneGroup) {
    Scene scene = lamps({"street", "car", "street"});
    scene.lights = {bulb("car"), bulb("street")};
    const LightGroups groups = grouped(scene).lightGroups;
    EXPECT_THAT(groups.names, ElementsAre("street", "car"));
    EXPECT_THAT(groups.ofLight, ElementsAre(0, 1, 0, 1, 0));
}

TEST(LightGroups, ADarkLightHasNone) {
    Scene scene = lamps({"lamp"});
    scene.lights = {bulb("off"), bulb("on")};
    scene.lights[0].intensity = glm::vec3(0);
    EXPECT_THAT(grouped(scene).lightGroups.names, ElementsAre("lamp", "on"));
}

TEST(LightGroups, TheEnvironmentIsOneAndTheBackgroundBelongsToIt) {
    SceneArrays arrays = flatten(lamps({"lamp"}));
    addEnvironment(arrays, constantEnvironment(glm::vec3(1)), 1, 0);
    groupLights(arrays, {true, {}}, false, "file");
    EXPECT_THAT(arrays.lightGroups.names, ElementsAre("lamp", kEnvironmentGroup));
    EXPECT_EQ(arrays.lightGroups.behind, 1U);
    EXPECT_THAT(arrays.lightGroups.ofLight, ElementsAre(0, 1));
    const LightGroups background = grouped(lamps({"lamp"}), {}, true).lightGroups;
    EXPECT_THAT(background.names, ElementsAre("lamp", kEnvironmentGroup));
    EXPECT_EQ(background.behind, 1U);
}

TEST(LightGroups, UnlitSurfacesShineInstancedToo) {
    Scene scene = sceneOf(gridPrimitive(3), {glm::mat4(1), glm::scale(glm::mat4(1), {2, 2, 2})});
    scene.materials[0].unlit = true;
    scene.instances[0].name = "left";
    scene.instances[1].name = "right";
    scene.materials.push_back({});
    scene.materials[1].emissive = glm::vec3(1);
    scene.meshes.push_back({"baked", {trianglePrimitive(1)}});
    scene.instances.push_back({"baked", 1, glm::mat4(1)});
    SceneArrays arrays = flatten(scene, {.instancing = true, .instancingThreshold = 0});
    ASSERT_EQ(arrays.instances.size(), 3U) << "two placements, and one of what is baked";
    groupLights(arrays, {true, {}}, false, "file");
    EXPECT_THAT(arrays.lightGroups.names, ElementsAre("left", "right", "baked"));
    EXPECT_THAT(arrays.lightGroups.ofObject, ElementsAre(0, 1, 2));
}

TEST(LightGroups, ChosenOnesLeaveTheRestToOthers) {
    Scene scene = lamps({"a", "b", "c"});
    scene.lights = {bulb("d")};
    const LightGroups groups = grouped(scene, {"b", "d"}).lightGroups;
    EXPECT_THAT(groups.names, ElementsAre(kOtherLights, "b", "d"));
    EXPECT_THAT(groups.ofLight, ElementsAre(0, 1, 0, 2));
    EXPECT_THAT(grouped(scene, {"a", "b", "c", "d"}).lightGroups.names, ElementsAre("a", "b", "c", "d"));
    EXPECT_THAT(groupingFault(scene, {"b", "e"}, ExitCode::Usage), AllOf(HasSubstr("'e'"), HasSubstr("a, b, c, d")));
}

TEST(LightGroups, AreNoMoreThanTheFilmHasRoomFor) {
    Names names;
    for (std::uint32_t i = 0; i < kMostLightGroups; ++i) names.push_back("lamp " + std::to_string(i));
    EXPECT_EQ(grouped(lamps(names)).lightGroups.names.size(), kMostLightGroups);
    names.emplace_back("one more");
    EXPECT_THAT(groupingFault(lamps(names)), AllOf(HasSubstr("file: --light-groups: 65 names"), HasSubstr("A,B,...")));
    EXPECT_THAT(grouped(lamps(names), {"one more"}).lightGroups.names, ElementsAre(kOtherLights, "one more"));
}

TEST(LightGroups, NeedLight) {
    Scene scene = lamps({"lamp"});
    scene.materials[0].emissive = glm::vec3(0);
    EXPECT_THAT(groupingFault(scene), HasSubstr("nothing shines"));
}

TEST(LightLayers, AreNamedByTheScatteringsOfTheirPaths) {
    EXPECT_EQ(lengthLayerName(0), "emission");
    EXPECT_EQ(lengthLayerName(1), "direct");
    EXPECT_EQ(lengthLayerName(2), "bounce1");
    EXPECT_EQ(lengthLayerName(14), "bounce13");
    EXPECT_EQ(lengthLayerName(15), "bounce14_and_more");
    EXPECT_EQ(lengthLayers(0), 1U);
    EXPECT_EQ(lengthLayers(8), 9U);
    EXPECT_EQ(lengthLayers(15), 16U);
    EXPECT_EQ(lengthLayers(1000), 16U);
}

TEST(LightLayers, GroupsGetNamesThatFilesCanHold) {
    EXPECT_THAT(groupLayerNames({"lamp", "a.b/c", "a b c", "", "ü-1"}),
                ElementsAre("light_lamp", "light_a_b_c", "light_a_b_c_2", "light_", "light___-1"));
    EXPECT_LT(groupLayerNames({std::string(1000, 'x')}).front().size(), 64U);
}

}  // namespace
}  // namespace vkpt
