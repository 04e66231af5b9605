// Invariants that the arrays of every real file must keep.
#include <gtest/gtest.h>

#include <filesystem>

#include "base/math.h"
#include "gltf/import.h"
#include "scene/camera.h"
#include "scene/environment.h"
#include "scene/flatten.h"

namespace vkpt {
namespace {

namespace fs = std::filesystem;

void expectSoundGeometry(const SceneArrays& a) {
    std::size_t wrong = 0, crossed = 0;
    for (const TriangleRecord& t : a.triangles) {
        const glm::vec3 n = glm::normalize(glm::cross(t.v1 - t.v0, t.v2 - t.v0));
        const bool indexed = std::max({t.i0, t.i1, t.i2}) < a.vertices.size();
        const bool lit = t.light == kNone || (t.light < a.lights.size() && a.lights[t.light].a == t.v0);
        wrong += isFinite(n) && indexed && lit && t.flags >> kTriangleMaterialShift < a.materials.size() ? 0 : 1;
        if (!indexed) continue;
        for (const std::uint32_t i : {t.i0, t.i1, t.i2}) {
            crossed += glm::dot(unpackNormal(a.vertices[i].normal), n) < 0 ? 1 : 0;
        }
    }
    EXPECT_EQ(wrong, 0U);
    EXPECT_LE(static_cast<double>(crossed), 0.02 * 3 * static_cast<double>(a.triangles.size()));  // fronts are fronts
    std::uint64_t covered = 0;
    for (const MeshRange& range : a.meshRanges) covered += range.triangleCount;
    EXPECT_EQ(covered, a.triangles.size());
}

void expectSoundMaterials(const SceneArrays& a) {
    for (const MaterialRecord& m : a.materials) {
        for (const std::uint32_t t :
             {m.baseColorTexture, m.metallicRoughnessTexture, m.normalTexture, m.emissiveTexture}) {
            EXPECT_TRUE(t == kNone || t < a.textures.size());
        }
    }
    for (const TextureRecord& t : a.textures) {
        const std::uint64_t count = (t.size & 0xffffU) * std::uint64_t{t.size >> 16U};
        EXPECT_LT(t.texels + (count - 1) * t.stride, a.texels.size());
    }
    EXPECT_EQ(a.texels.size() % 4, 0U);
}

void expectSound(const fs::path& file) {
    SCOPED_TRACE(file);
    SceneArrays a = flatten(importGltf(file));
    EXPECT_GT(a.triangles.size(), 0U);
    addEnvironment(a, constantEnvironment(glm::vec3(1)), 1, 0);
    expectSoundGeometry(a);
    expectSoundMaterials(a);
    ASSERT_EQ(a.lightCdf.size(), a.lights.size());
    ASSERT_EQ(a.lightPower.size(), a.lights.size());
    double sum = 0;
    for (const LightRecord& light : a.lights) sum += double{light.pmf};
    EXPECT_EQ(sum, 1);
    EXPECT_TRUE(isFinite(a.boundsMin) && isFinite(a.boundsMax));
    RenderParams params{};
    params.width = 96, params.height = 54;
    frameScene(params, a);
    EXPECT_TRUE(isFinite(params.eye));
}

TEST(SceneFiles, OurOwnFlattenSoundly) {
    std::size_t seen = 0;
    for (const auto& entry : fs::directory_iterator(VKPT_SCENES)) {
        if (!fs::exists(entry.path() / "scene.gltf")) continue;
        expectSound(entry.path() / "scene.gltf");
        ++seen;
    }
    EXPECT_GT(seen, 5U);
}

TEST(SceneFiles, KhronosModelsFlattenSoundly) {
    const fs::path folder = fs::path(VKPT_ASSETS) / "models";
    if (!fs::exists(folder)) GTEST_SKIP() << "absent: " << folder;
    for (const char* name : {"NegativeScaleTest.glb", "DamagedHelmet.glb", "Duck.glb", "BoxVertexColors.glb",
                             "MultiUVTest.glb", "OrientationTest.glb", "MetalRoughSpheresNoTextures.glb"}) {
        expectSound(folder / name);
    }
}

}  // namespace
}  // namespace vkpt
