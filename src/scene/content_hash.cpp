#include "scene/content_hash.h"

#include "base/hash.h"

namespace vkpt {
namespace {

template <class Value>
std::span<const std::byte> bytesOf(const Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    return std::as_bytes(std::span(&value, 1));
}

}  // namespace

SceneHashes hashScene(const SceneArrays& arrays) {
    // Names every member, so that a new one does not compile until it is hashed or known to be derived.
    const auto& [triangles, vertices, vertexExtras, meshRanges, instances, instanceMesh, materials, bsdfs, albedoTables,
                 textures, texels, lights, lightCdf, lightPower, envTexels, envRows, envColumns, envWidth, envHeight,
                 envLight, envRotation, nodes, rootNode, bvhDepth, boundsMin, boundsMax, features, objectNames,
                 materialNames, punctualNames, lightGroups, droppedTriangles, droppedInstances] = arrays;
    SceneHashes hashes;
    hashes.geometry = ContentHash()
                          .add(triangles)
                          .add(vertices)
                          .add(vertexExtras)
                          .add(meshRanges)
                          .add(instances)
                          .add(instanceMesh)
                          .add(nodes)
                          .add(bytesOf(rootNode))
                          .hex();
    hashes.materials = ContentHash()
                           .add(materials)
                           .add(bsdfs)
                           .add(albedoTables)
                           .add(bytesOf(features.multiscatter))
                           .add(textures)
                           .add(texels)
                           .hex();
    ContentHash lightHash;
    lightHash.add(lights).add(lightCdf);
    if (!lightGroups.empty())
        lightHash.add(lightGroups.ofLight).add(lightGroups.ofObject).add(bytesOf(lightGroups.behind));
    hashes.lights = lightHash.hex();
    ContentHash environment;
    environment.add(envTexels).add(envRows).add(envColumns);
    environment.add(bytesOf(envWidth)).add(bytesOf(envHeight)).add(bytesOf(envLight)).add(bytesOf(envRotation));
    hashes.environment = environment.hex();
    return hashes;
}

std::string hashOptions(const RenderOptions& options) {
    const auto& [params, sampler, sampleBegin, sampleEnd, aovs, light] = options;
    const auto& [samplerId, scramble] = sampler;
    ContentHash hash;
    hash.add(bytesOf(params)).add(bytesOf(samplerId)).add(bytesOf(scramble)).add(bytesOf(aovs.bits));
    if (!light.empty()) hash.add(bytesOf(light.lengths));
    for (const std::string& group : light.groups) hash.add(group);
    return hash.hex();
}

}  // namespace vkpt
