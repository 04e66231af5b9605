// Every bit that a renderer reads is in one of the hashes.
#include "scene/content_hash.h"

#include <gtest/gtest.h>

#include <functional>

namespace vkpt {
namespace {

SceneArrays oneOfEach() {
    SceneArrays a;
    a.triangles.resize(2);
    a.vertices.resize(2);
    a.vertexExtras.resize(2);
    a.meshRanges.resize(2);
    a.instances.resize(2);
    a.instanceMesh.resize(2);
    a.materials.resize(2);
    a.textures.resize(2);
    a.texels.resize(2);
    a.lights.resize(2);
    a.lightCdf.resize(2);
    a.envTexels.resize(2);
    a.envRows.resize(2);
    a.envColumns.resize(2);
    a.nodes.resize(2);
    return a;
}

using Change = std::function<void(SceneArrays&)>;
using Member = std::string SceneHashes::*;

/// The hash that a change must alter; the three others must stay.
void expectAlters(Member altered, const char* what, const Change& change) {
    SceneArrays arrays = oneOfEach();
    const SceneHashes before = hashScene(arrays);
    change(arrays);
    const SceneHashes after = hashScene(arrays);
    for (const Member member :
         {&SceneHashes::geometry, &SceneHashes::materials, &SceneHashes::lights, &SceneHashes::environment}) {
        if (member == altered)
            EXPECT_NE(before.*member, after.*member) << what;
        else
            EXPECT_EQ(before.*member, after.*member) << what;
    }
}

TEST(HashScene, EveryArrayCounts) {
    const Member geometry = &SceneHashes::geometry, materials = &SceneHashes::materials, lights = &SceneHashes::lights,
                 environment = &SceneHashes::environment;
    expectAlters(geometry, "triangles", [](auto& a) { a.triangles[1].v2.z = 1e-30F; });
    expectAlters(geometry, "vertices", [](auto& a) { a.vertices[1].tangent = 1; });
    expectAlters(geometry, "vertexExtras", [](auto& a) { a.vertexExtras[1].colorBA = 1; });
    expectAlters(geometry, "meshRanges", [](auto& a) { a.meshRanges[1].triangleCount = 1; });
    expectAlters(geometry, "instances", [](auto& a) { a.instances[1].object = 1; });
    expectAlters(geometry, "instanceMesh", [](auto& a) { a.instanceMesh[1] = 1; });
    expectAlters(geometry, "nodes", [](auto& a) { a.nodes[1].hiZ1 = 1; });
    expectAlters(geometry, "rootNode", [](auto& a) { a.rootNode = 1; });
    expectAlters(materials, "materials", [](auto& a) { a.materials[1].emissiveTexture = 1; });
    expectAlters(materials, "textures", [](auto& a) { a.textures[1].rowV.z = 1; });
    expectAlters(materials, "texels", [](auto& a) { a.texels[1] = 1; });
    expectAlters(materials, "one more", [](auto& a) { a.texels.push_back(0); });
    expectAlters(lights, "lights", [](auto& a) { a.lights[1].index = 1; });
    expectAlters(lights, "lightCdf", [](auto& a) { a.lightCdf[1] = 1; });
    expectAlters(lights, "lightGroups", [](auto& a) { a.lightGroups = {{"lamp"}, {0}, {}, 0}; });
    expectAlters(environment, "envTexels", [](auto& a) { a.envTexels[1].w = 1; });
    expectAlters(environment, "envRows", [](auto& a) { a.envRows[1] = 1; });
    expectAlters(environment, "envColumns", [](auto& a) { a.envColumns[1] = 1; });
    expectAlters(environment, "envWidth", [](auto& a) { a.envWidth = 1; });
    expectAlters(environment, "envHeight", [](auto& a) { a.envHeight = 1; });
    expectAlters(environment, "envLight", [](auto& a) { a.envLight = 1; });
    expectAlters(environment, "envRotation", [](auto& a) { a.envRotation = 1; });
    expectAlters(nullptr, "names", [](auto& a) { a.objectNames.emplace_back("table"); });
}

TEST(HashOptions, AllButTheRangeCounts) {
    const RenderOptions options;
    const std::string before = hashOptions(options);
    RenderOptions other = options;
    other.sampleBegin = 3;
    other.sampleEnd = 9;
    EXPECT_EQ(hashOptions(other), before);
    other = options;
    other.params.rrFixed = 0.5F;
    EXPECT_NE(hashOptions(other), before);
    other = options;
    other.sampler = SamplerId::Random;
    EXPECT_NE(hashOptions(other), before);
    other = options;
    other.aovs.add(Aov::Depth);
    EXPECT_NE(hashOptions(other), before);
}

}  // namespace
}  // namespace vkpt
