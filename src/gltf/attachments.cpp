#include "gltf/attachments.h"

#include <algorithm>
#include <cmath>

#include "constants.h"
#include "gltf/model.h"

namespace vkpt::gltf {
namespace {

// A node's own name says more about a placed thing than the thing's.
template <typename Thing>
std::string nameOf(const tinygltf::Node& node, const Thing& thing) {
    return node.name.empty() ? thing.name : node.name;
}

Camera readCamera(const Document& document, int index) {
    const tinygltf::Camera& source = document.model().cameras[index];
    Camera camera;
    if (source.type == "perspective") {
        camera.yfov = static_cast<float>(source.perspective.yfov);
        if (!(camera.yfov < kPi))
            document.fail("cameras[{}].perspective.yfov: {} must be less than pi", index, camera.yfov);
        const auto aspect = static_cast<float>(source.perspective.aspectRatio);
        if (aspect > 0) camera.aspect = aspect;
    } else {
        camera.orthographic = true;
        const float xmag = std::abs(static_cast<float>(source.orthographic.xmag));
        camera.ymag = std::abs(static_cast<float>(source.orthographic.ymag));
        camera.aspect = xmag / camera.ymag;
    }
    return camera;
}

PunctualLight readLight(const Document& document, int index) {
    const tinygltf::Light& source = document.model().lights[index];
    PunctualLight light;
    if (source.type == "directional")
        light.kind = PunctualKind::Directional;
    else if (source.type == "spot")
        light.kind = PunctualKind::Spot;
    if (!source.color.empty()) light.intensity = {source.color[0], source.color[1], source.color[2]};
    light.intensity *= static_cast<float>(source.intensity);
    light.range = static_cast<float>(source.range);
    light.outerConeAngle = std::min(static_cast<float>(source.spot.outerConeAngle), kPi / 2);
    light.innerConeAngle = std::min(static_cast<float>(source.spot.innerConeAngle), light.outerConeAngle);
    return light;
}

}  // namespace

void readAttachments(const Document& document, const PlacedNode& placed, Scene& scene) {
    const tinygltf::Model& model = document.model();
    const tinygltf::Node& node = model.nodes[placed.node];
    if (node.camera >= 0) {
        Camera camera = readCamera(document, node.camera);
        camera.name = nameOf(node, model.cameras[node.camera]);
        camera.worldFromCamera = withoutScale(placed.world);
        scene.cameras.push_back(std::move(camera));
    }
    const int index = static_cast<int>(numberOr(extension(node.extensions, "KHR_lights_punctual"), "light", -1));
    if (index >= static_cast<int>(model.lights.size()))
        document.fail("nodes[{}].extensions.KHR_lights_punctual.light: {}, but the file has {} lights", placed.node,
                      index, model.lights.size());
    if (index >= 0) {
        PunctualLight light = readLight(document, index);
        light.name = nameOf(node, model.lights[index]);
        light.worldFromLight = withoutScale(placed.world);
        scene.lights.push_back(std::move(light));
    }
}

}  // namespace vkpt::gltf
