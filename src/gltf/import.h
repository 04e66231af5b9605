// glTF 2.0 file -> Scene.
#pragma once
#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "scene/scene.h"

namespace vkpt {

struct ImportOptions {
    int scene = -1;              ///< index into the file's scenes; -1: its default scene, else its first
    bool allowExternal = false;  ///< buffers and images may lie outside the scene's folder
    /// Changes the materials before geometry is read, which depends on them (tangents). Errors pass through.
    std::function<void(std::vector<Material>&)> editMaterials{};
};

/// Reads a .gltf or .glb file with its buffers and images. [glTF 2.0]
/// Everything is validated: what the file refers to is there and every number is finite.
/// Holds what the chosen scene draws: meshes, materials and images that nothing places are left out; what is kept
/// stands in the file's order. Cameras and lights come one for each node that carries one.
/// Throws FileError, naming the place in the file, where the file is missing, malformed or needs an extension that
/// vkpt does not support. Lesser faults become Scene::warnings.
[[nodiscard]] Scene importGltf(const std::filesystem::path& file, const ImportOptions& options = {});

/// The same of bytes in memory. Errors call them `file`, in whose folder their URIs begin.
[[nodiscard]] Scene importGltf(std::span<const unsigned char> bytes, const std::filesystem::path& file,
                               const ImportOptions& options = {});

}  // namespace vkpt
