// What a glTF file says, as plain host data: the importer writes it, flatten reads it.
// Units and axes are glTF's: metres, Y up, linear Rec. 709, radiance in nits.
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scene/bsdf_spec.h"

namespace vkpt {

/// 8-bit image, row 0 at the top, R in the low byte. Not decoded from sRGB.
struct TextureImage {
    std::string name;
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint32_t> texels;
};

enum class Wrap : std::uint8_t { Repeat, ClampToEdge, MirroredRepeat };

/// One use of an image by a material. `image` is -1 where the slot is empty.
struct TextureUse {
    int image = -1;
    Wrap wrapS = Wrap::Repeat, wrapT = Wrap::Repeat;
    bool nearest = false;
    std::uint32_t uvSet = 0;  ///< 0 or 1
    glm::vec3 rowU{1, 0, 0};  ///< u' = dot(rowU, (u, v, 1)): KHR_texture_transform
    glm::vec3 rowV{0, 1, 0};
};

enum class AlphaMode : std::uint8_t { Opaque, Mask, Blend };

struct Material {
    std::string name;
    glm::vec4 baseColor{1};
    float metallic = 1, roughness = 1;
    glm::vec3 emissive{0};  ///< nits: factor x KHR_materials_emissive_strength
    float normalScale = 1;
    AlphaMode alphaMode = AlphaMode::Opaque;
    float alphaCutoff = 0.5F;
    bool doubleSided = false, unlit = false;
    std::optional<BsdfSpec> bsdf;  ///< another model than glTF's: VKPT_materials_bsdf or --material
    TextureUse baseColorTexture, metallicRoughnessTexture, normalTexture, emissiveTexture;
};

/// Triangles of one material. All attribute arrays are empty or as long as `positions`.
struct Primitive {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;    ///< never empty after import (flat where the file has none)
    std::vector<glm::vec4> tangents;   ///< present where the material has a normal map
    std::vector<glm::vec2> uv0, uv1;
    std::vector<glm::vec4> colors;     ///< linear, clamped to [0,1]
    std::vector<glm::uvec3> triangles; ///< indices into the arrays above, counter-clockwise fronts
    std::uint32_t material = 0;        ///< index into Scene::materials, always valid
};

struct Mesh {
    std::string name;
    std::vector<Primitive> primitives;
};

struct Camera {
    std::string name;
    glm::mat4 worldFromCamera{1};  ///< looks along -Z
    bool orthographic = false;
    float yfov = 0.7F;  ///< radians, perspective
    float ymag = 1;     ///< half the window's height in metres, orthographic
    std::optional<float> aspect;  ///< width / height as the file states it
};

enum class PunctualKind : std::uint8_t { Point, Spot, Directional };

struct PunctualLight {
    std::string name;
    PunctualKind kind = PunctualKind::Point;
    glm::mat4 worldFromLight{1};  ///< shines along -Z
    glm::vec3 intensity{1};       ///< color x intensity: candela, or lux for directional
    float range = 0;              ///< metres; 0: infinite
    float innerConeAngle = 0, outerConeAngle = 0.785398163F;  ///< radians
};

/// One mesh placed by a node.
struct MeshInstance {
    std::string name;  ///< the node's, or the mesh's where the node has none
    std::uint32_t mesh = 0;
    glm::mat4 worldFromObject{1};
};

/// What the importer did with an extension or feature of the file.
struct ExtensionUse {
    std::string name;
    std::string support;  ///< "honoured", "approximated" or "ignored"
    bool required = false;
};

struct Scene {
    std::filesystem::path path;
    std::vector<std::filesystem::path> files;  ///< what else was read, sorted: buffers and images outside `path`
    std::vector<TextureImage> images;
    std::vector<Material> materials;  ///< at least one: glTF's default material comes last if it is used
    std::vector<Mesh> meshes;
    std::vector<MeshInstance> instances;
    std::vector<Camera> cameras;
    std::vector<PunctualLight> lights;
    std::vector<ExtensionUse> extensions;
    std::vector<std::string> warnings;      ///< for the log, one line each
    std::vector<std::string> ignored;       ///< "animations", "skins", "morph targets" where the file has them
    std::uint64_t skippedPoints = 0, skippedLines = 0;
};

}  // namespace vkpt
