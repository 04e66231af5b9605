// The single fork of the data flow: flat, device-ready arrays that both renderers read and neither writes.
#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "constants.h"
#include "layout.h"

namespace vkpt {

/// What the scene holds, so that kernels can leave out what it does not.
struct SceneFeatures {
    bool instances = false;          ///< two-level BVH
    bool alpha = false;              ///< some triangle is MASK or BLEND
    std::uint32_t maps = 0;          ///< roles (kMap*) of the maps that some material has, a bit each
    std::uint32_t mapSets = 0;       ///< sets of maps that some material has, at most
    bool textureTransforms = false;  ///< some TextureRecord is not the identity
    bool vertexExtras = false;       ///< TEXCOORD_1 or COLOR_0
    bool triangleLights = false;
    bool texturedEmission = false;  ///< a triangle light has an emissive texture
    bool punctualLights = false;
    bool environment = false;
    bool unlit = false;
    std::uint32_t bsdfModels = 1;  ///< models (ids of registry.def) that some triangle has, a bit each; bit 0 is glTF's
    bool media = false;            ///< some dielectric absorbs
    bool multiscatter = false;     ///< interreflection between facets is compensated; albedoTables is filled
};

/// A contiguous range of triangles that gets a BVH of its own, and where it is placed.
/// Without instancing there is exactly one, baked to world space.
struct MeshRange {
    std::uint32_t firstTriangle = 0, triangleCount = 0;
};

/// Which of the film's layers takes the light of what. Empty: light is not told apart (scene/light_groups.h).
struct LightGroups {
    std::vector<std::string> names;       ///< of the groups
    std::vector<std::uint32_t> ofLight;   ///< a group for each of SceneArrays::lights
    std::vector<std::uint32_t> ofObject;  ///< a group for each mesh instance; 0 where it does not emit
    std::uint32_t behind = 0;             ///< of environment and background

    [[nodiscard]] bool empty() const { return names.empty(); }
};

struct SceneArrays {
    std::vector<TriangleRecord> triangles;  ///< after buildBvh: in leaf order
    std::vector<VertexRecord> vertices;
    std::vector<VertexExtra> vertexExtras;  ///< empty, or one a vertex
    std::vector<MeshRange> meshRanges;      ///< [0] is the baked geometry, possibly empty
    /// Empty without instancing; else one places meshRanges[0] at identity, unless that range is empty: its object is
    /// kNone, since its triangles have their own. Every placement has a positive determinant.
    std::vector<InstanceRecord> instances;
    std::vector<std::uint32_t> instanceMesh;  ///< which MeshRange each instance places
    std::vector<MaterialRecord> materials;
    std::vector<BsdfRecord> bsdfs;         ///< one a material, or none where all are glTF's
    std::vector<AlbedoCell> albedoTables;  ///< kAlbedoTableWords a table; the first is glTF's
    std::vector<TextureRecord> textures;
    std::vector<std::uint32_t> texels;
    std::vector<LightRecord> lights;
    std::vector<float> lightCdf;    ///< inclusive; the last is 1; multiples of 2^-24 (sampling_table.h)
    std::vector<float> lightPower;  ///< one a light: what pmf is proportional to, lumens or a like weight
    std::vector<vec4> envTexels;    ///< empty without an environment
    std::vector<float> envRows;     ///< marginal CDF, padded with 1 to a multiple of 4
    std::vector<float> envColumns;  ///< conditional CDFs, each row padded with 1 to a multiple of 4
    std::uint32_t envWidth = 0, envHeight = 0, envLight = kNone;
    float envRotation = 0;                 ///< radians about +y
    std::vector<WideNode> nodes;           ///< filled by buildBvh
    std::uint32_t rootNode = 0;            ///< root of the top level, or of the only level
    std::uint32_t bvhDepth = 0;            ///< levels of nodes, top level and deepest mesh together; by buildBvh
    glm::vec3 boundsMin{0}, boundsMax{0};  ///< world space, of everything
    SceneFeatures features;
    std::vector<std::string> objectNames, materialNames;
    std::vector<std::string> punctualNames;  ///< of the lights that are no triangles and no environment, in their order
    LightGroups lightGroups;
    std::uint64_t droppedTriangles = 0;  ///< without area, or with non-finite corners
    std::uint64_t droppedInstances = 0;  ///< placements of shared meshes by a matrix without an inverse
};

}  // namespace vkpt
