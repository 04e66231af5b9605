#include "scene/info.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/environment.h"
#include "scene_builder.h"

namespace vkpt {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Scene richScene() {
    Scene scene = sceneOf(gridPrimitive(20), {glm::mat4(1), glm::translate(glm::mat4(1), {5, 0, 0})});
    scene.materials[0].name = "enamel";
    scene.materials[0].baseColor = {0.8F, 0.1F, 0.1F, 1};
    scene.images.push_back(imageOf(16, 8, 0xffffffffU));
    scene.materials[0].baseColorTexture.image = 0;
    scene.cameras.push_back({.name = "front",
                             .worldFromCamera = glm::mat4(1),
                             .orthographic = false,
                             .yfov = 0.7F,
                             .ymag = 1,
                             .aspect = {}});
    scene.lights.push_back({"sun", PunctualKind::Directional, glm::mat4(1), glm::vec3(3), 0, 0, 0});
    scene.extensions = {{"KHR_lights_punctual", "honoured", true}, {"KHR_materials_sheen", "ignored", false}};
    scene.ignored = {"animations"};
    scene.skippedPoints = 12;
    scene.warnings = {"a warning"};
    return scene;
}

TEST(Info, CountsWhatIsThere) {
    const Scene scene = richScene();
    const SceneArrays arrays = flatten(scene);
    const Json info = sceneInfo(scene, arrays);
    EXPECT_EQ(info["counts"]["triangles"], 800);
    EXPECT_EQ(info["counts"]["trianglesPlaced"], 1600);
    EXPECT_EQ(info["counts"]["trianglesStored"], arrays.triangles.size());
    EXPECT_EQ(info["counts"]["vertices"], 441);
    EXPECT_EQ(info["counts"]["texels"], 128);
    EXPECT_EQ(info["bounds"]["max"], (Json{6.0, 1.0, 0.0}));
    EXPECT_EQ(info["memory"]["triangles"], 1600 * 64);
    EXPECT_EQ(info["memory"]["texels"], 512);
    EXPECT_EQ(info["cameras"][0]["name"], "front");
    EXPECT_EQ(info["lights"]["punctual"][0]["type"], "directional");
    EXPECT_EQ(info["materials"][0]["baseColor"][0], 0.8);  // as written, not as a float turned double
    EXPECT_EQ(info["extensions"]["honoured"][0]["name"], "KHR_lights_punctual");
    EXPECT_EQ(info["extensions"]["ignored"][0]["name"], "KHR_materials_sheen");
    EXPECT_TRUE(info["extensions"]["approximated"].empty());
    EXPECT_EQ(info["leftOut"]["points"], 12);
    EXPECT_EQ(info["leftOut"]["features"][0], "animations");
}

TEST(Info, MemoryTotalIsTheSumAndGrowsWithTheEnvironment) {
    const Scene scene = richScene();
    SceneArrays arrays = flatten(scene);
    const Json before = sceneInfo(scene, arrays)["memory"];
    addEnvironment(arrays, studioEnvironment(), 1, 0);
    const Json after = sceneInfo(scene, arrays)["memory"];
    EXPECT_EQ(before["environment"], 0);
    EXPECT_GT(after["environment"], 512 * 256 * 16);
    EXPECT_GT(after["total"], before["total"]);
    std::uint64_t sum = 0;
    for (const auto& [name, value] : after.items()) sum += name == "total" ? 0 : value.get<std::uint64_t>();
    EXPECT_EQ(after["total"], sum);
}

TEST(Info, TheTableTellsTheSame) {
    const Scene scene = richScene();
    const std::string text = sceneInfoText(sceneInfo(scene, flatten(scene)));
    for (const char* part : {"memory.gltf", "1,600", "front", "sun", "enamel", "KHR_lights_punctual (required)",
                             "KHR_materials_sheen", "animations", "12 points", "a warning", "3, 3, 3 lux"}) {
        EXPECT_THAT(text, HasSubstr(part));
    }
    EXPECT_THAT(text, Not(HasSubstr("lines")));
}

TEST(Info, AnEmptySceneHasATableToo) {
    const Scene scene;
    EXPECT_THAT(sceneInfoText(sceneInfo(scene, flatten(scene))), HasSubstr("studio"));
}

}  // namespace
}  // namespace vkpt
