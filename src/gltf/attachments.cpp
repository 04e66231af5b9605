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
        if (!(camera.yfov > 0 && camera.yfov < kPi))
            document.fail("cameras[{}].perspective.yfov: {} must lie between 0 and pi", index, camera.yfov);
        const auto aspect = static_cast<float>(source.perspective.aspectRatio);
        if (aspect > 0) camera.aspect = aspect;
    } else {
        camera.orthographic = true;
        const float xmag = std::abs(static_cast<float>(source.orthographic.xmag));
        camera.ymag = std::abs(static_cast<float>(source.orthographic.ymag));
        if (!(xmag > 0 && camera.ymag > 0))
            document.fail("cameras[{}].orthographic: xmag and ymag must not be 0", index);
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
    else if (source.type != "point")
        document.fail("extensions.KHR_lights_punctual.lights[{}].type: \"{}\" is none of point, spot, directional",
                      index, source.type);
    if (!source.color.empty()) light.intensity = {source.color[0], source.color[1], source.color[2]};
    light.intensity = glm::max(light.intensity * static_cast<float>(source.intensity), 0.0F);
    light.range = std::max(static_cast<float>(source.range), 0.0F);
    // Exporters write inner == outer for a hard edge, which the specification does not allow but means.
    light.outerConeAngle = std::clamp(static_cast<float>(source.spot.outerConeAngle), 0.0F, kPi / 2);
    light.innerConeAngle = std::clamp(static_cast<float>(source.spot.innerConeAngle), 0.0F, light.outerConeAngle);
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
