#include "scene/info.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>

namespace vkpt {
namespace {

/// The float with no digits that only its conversion to double would add.
double plain(float value) { return std::isfinite(value) ? std::stod(fmt::format("{}", value)) : double{value}; }

Json toJson(const glm::vec3& v) { return {plain(v.x), plain(v.y), plain(v.z)}; }

Json counts(const Scene& scene, const SceneArrays& arrays) {
    std::uint64_t primitives = 0, unique = 0, placed = 0, vertices = 0;
    for (const Mesh& mesh : scene.meshes) {
        primitives += mesh.primitives.size();
        for (const Primitive& primitive : mesh.primitives) {
            unique += primitive.triangles.size();
            vertices += primitive.positions.size();
        }
    }
    for (const MeshInstance& instance : scene.instances) {
        for (const Primitive& primitive : scene.meshes[instance.mesh].primitives) placed += primitive.triangles.size();
    }
    std::uint64_t texels = 0;
    for (const TextureImage& image : scene.images) texels += image.texels.size();
    return {{"meshes", scene.meshes.size()},
            {"instances", scene.instances.size()},
            {"primitives", primitives},
            {"triangles", unique},
            {"trianglesPlaced", placed},
            {"trianglesStored", arrays.triangles.size()},
            {"vertices", vertices},
            {"images", scene.images.size()},
            {"texels", texels},
            {"materials", scene.materials.size()},
            {"cameras", scene.cameras.size()},
            {"lights", arrays.lights.size()}};
}

template <typename T>
std::uint64_t bytes(const std::vector<T>& v) {
    return v.size() * sizeof(T);
}

Json memory(const SceneArrays& arrays) {
    Json sections{{"triangles", bytes(arrays.triangles)},
                  {"vertices", bytes(arrays.vertices) + bytes(arrays.vertexExtras)},
                  {"nodes", bytes(arrays.nodes)},
                  {"instances", bytes(arrays.instances)},
                  {"materials", bytes(arrays.materials) + bytes(arrays.textures)},
                  {"texels", bytes(arrays.texels)},
                  {"lights", bytes(arrays.lights) + bytes(arrays.lightCdf)},
                  {"environment", bytes(arrays.envTexels) + bytes(arrays.envRows) + bytes(arrays.envColumns)}};
    std::uint64_t total = 0;
    for (const Json& section : sections) total += section.get<std::uint64_t>();
    sections["total"] = total;
    return sections;
}

Json cameras(const Scene& scene) {
    Json list = Json::array();
    for (const Camera& camera : scene.cameras) {
        Json entry{{"name", camera.name}, {"type", camera.orthographic ? "orthographic" : "perspective"}};
        if (camera.orthographic) {
            entry["ymag"] = plain(camera.ymag);
        } else {
            entry["yfovDegrees"] = plain(glm::degrees(camera.yfov));
        }
        entry["eye"] = toJson(glm::vec3(camera.worldFromCamera[3]));
        list.push_back(entry);
    }
    return list;
}

Json lights(const Scene& scene, const SceneArrays& arrays) {
    std::uint64_t triangles = 0;
    for (const LightRecord& light : arrays.lights) {
        triangles += light.kind == kLightTriangle || light.kind == kLightTriangleTwoSided ? 1 : 0;
    }
    Json list = Json::array();
    for (const PunctualLight& light : scene.lights) {
        constexpr std::array<std::string_view, 3> kKinds{"point", "spot", "directional"};
        Json entry{{"name", light.name},
                   {"type", kKinds[static_cast<std::size_t>(light.kind)]},
                   {"intensity", toJson(light.intensity)},
                   {"unit", light.kind == PunctualKind::Directional ? "lux" : "candela"}};
        if (light.range > 0) entry["range"] = plain(light.range);
        if (light.kind == PunctualKind::Spot) {
            entry["innerConeDegrees"] = plain(glm::degrees(light.innerConeAngle));
            entry["outerConeDegrees"] = plain(glm::degrees(light.outerConeAngle));
        }
        list.push_back(entry);
    }
    return {{"emissiveTriangles", triangles}, {"environment", arrays.features.environment}, {"punctual", list}};
}

Json textureSlots(const Material& material) {
    Json slots = Json::array();
    const auto add = [&](std::string_view name, const TextureUse& use) {
        if (use.image >= 0) slots.push_back(name);
    };
    add("baseColor", material.baseColorTexture);
    add("metallicRoughness", material.metallicRoughnessTexture);
    add("normal", material.normalTexture);
    add("emissive", material.emissiveTexture);
    return slots;
}

std::string modelName(const Material& material) {
    if (material.unlit) return "unlit";
    if (!material.bsdf) return "metallic-roughness";
    return std::string(kBsdfModels[static_cast<std::size_t>(material.bsdf->model)].name);
}

Json materials(const Scene& scene) {
    Json list = Json::array();
    for (const Material& material : scene.materials) {
        constexpr std::array<std::string_view, 3> kModes{"OPAQUE", "MASK", "BLEND"};
        const glm::vec4& base = material.baseColor;
        list.push_back({{"name", material.name},
                        {"model", modelName(material)},
                        {"baseColor", {plain(base.r), plain(base.g), plain(base.b), plain(base.a)}},
                        {"metallic", plain(material.metallic)},
                        {"roughness", plain(material.roughness)},
                        {"emissive", toJson(material.emissive)},
                        {"alphaMode", kModes[static_cast<std::size_t>(material.alphaMode)]},
                        {"doubleSided", material.doubleSided},
                        {"textures", textureSlots(material)}});
        if (material.bsdf) list.back()["bsdf"] = bsdfToJson(*material.bsdf);
    }
    return list;
}

Json extensions(const Scene& scene) {
    Json groups{{"honoured", Json::array()}, {"approximated", Json::array()}, {"ignored", Json::array()}};
    for (const ExtensionUse& use : scene.extensions) {
        groups[use.support].push_back({{"name", use.name}, {"required", use.required}});
    }
    return groups;
}

}  // namespace

Json sceneInfo(const Scene& scene, const SceneArrays& arrays) {
    return {{"file", scene.path.string()},
            {"counts", counts(scene, arrays)},
            {"bounds",
             {{"min", toJson(arrays.boundsMin)},
              {"max", toJson(arrays.boundsMax)},
              {"size", toJson(arrays.boundsMax - arrays.boundsMin)}}},
            {"memory", memory(arrays)},
            {"cameras", cameras(scene)},
            {"lights", lights(scene, arrays)},
            {"materials", materials(scene)},
            {"extensions", extensions(scene)},
            {"leftOut",
             {{"features", scene.ignored},
              {"points", scene.skippedPoints},
              {"lines", scene.skippedLines},
              {"degenerateTriangles", arrays.droppedTriangles},
              {"degenerateInstances", arrays.droppedInstances}}},
            {"warnings", scene.warnings}};
}

}  // namespace vkpt
