// Every model at hand.
#include <algorithm>
#include <fstream>
#include <set>

#include "builder.h"

namespace vkpt::test {
namespace {

const std::filesystem::path kModels = std::filesystem::path(VKPT_ASSETS) / "models";

std::vector<std::filesystem::path> filesBelow(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    if (!std::filesystem::exists(folder)) return files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".gltf" || entry.path().extension() == ".glb") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

// What every importer's output promises: see scene/scene.h.
void expectSound(const Scene& scene) {
    ASSERT_FALSE(scene.materials.empty());
    for (const MeshInstance& instance : scene.instances) ASSERT_LT(instance.mesh, scene.meshes.size());
    for (const Mesh& mesh : scene.meshes)
        for (const Primitive& p : mesh.primitives) {
            const std::size_t n = p.positions.size();
            EXPECT_EQ(p.normals.size(), n);
            for (const std::size_t size : {p.tangents.size(), p.uv0.size(), p.uv1.size(), p.colors.size()})
                EXPECT_TRUE(size == 0 || size == n);
            ASSERT_LT(p.material, scene.materials.size());
            EXPECT_EQ(scene.materials[p.material].normalTexture.image >= 0, !p.tangents.empty());
            EXPECT_TRUE(std::all_of(p.triangles.begin(), p.triangles.end(),
                                    [&](const glm::uvec3& t) { return t.x < n && t.y < n && t.z < n; }));
            EXPECT_TRUE(std::all_of(p.normals.begin(), p.normals.end(),
                                    [](const glm::vec3& v) { return std::abs(glm::dot(v, v) - 1) < 1e-4F; }));
        }
    for (const Material& m : scene.materials)
        for (const TextureUse* use :
             {&m.baseColorTexture, &m.metallicRoughnessTexture, &m.normalTexture, &m.emissiveTexture}) {
            ASSERT_LT(use->image, static_cast<int>(scene.images.size()));
            EXPECT_LT(use->uvSet, 2U);
        }
    for (const TextureImage& image : scene.images)
        EXPECT_EQ(image.texels.size(), std::size_t{image.width} * image.height);
}

TEST(Smoke, EveryModelImportsOrNamesTheExtensionItNeeds) {
    const auto files = filesBelow(kModels);
    if (files.empty()) GTEST_SKIP() << "no models: " << kModels << " is absent";
    std::size_t imported = 0;
    for (const auto& file : files) {
        SCOPED_TRACE(file.string());
        try {
            expectSound(importGltf(file));
            ++imported;
        } catch (const FileError& error) {
            const std::string message = error.what();
            const bool future = message.find("asset.minVersion: the file needs glTF 2.1") != std::string::npos;
            EXPECT_TRUE(future || message.find(": extensionsRequired: needs ") != std::string::npos) << message;
        }
    }
    EXPECT_GE(imported * 10, files.size() * 8) << "too few models import";
}

}  // namespace
}  // namespace vkpt::test
