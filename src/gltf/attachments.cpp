#include "gltf/attachments.h"

#include <algorithm>
#include <cmath>

#include "constants.h"

namespace vkpt::gltf {
namespace {

// A node's own name says more about a placed thing than the thing's.
std::string nameOf(const Json& node, const Json& thing) {
    const std::string name = textOr(node, "name", "");
    return name.empty() ? textOr(thing, "name", "") : name;
}

Camera readCamera(const Document& document, std::size_t index) {
    const Json& object = document.item("cameras", index);
    const std::string type = textOr(object, "type", "");
    Camera camera;
    if (type == "perspective" && object.contains("perspective")) {
        const Json& lens = member(object, "perspective");
        camera.yfov = member(lens, "yfov").get<float>();
        if (!(camera.yfov > 0 && camera.yfov < kPi))
            document.fail("cameras[{}].perspective.yfov: {} must lie between 0 and pi", index, camera.yfov);
        const float aspect = valueOr(lens, "aspectRatio", 0.0F);
        if (aspect > 0) camera.aspect = aspect;
    } else if (type == "orthographic" && object.contains("orthographic")) {
        const Json& window = member(object, "orthographic");
        camera.orthographic = true;
        const float xmag = std::abs(member(window, "xmag").get<float>());
        camera.ymag = std::abs(member(window, "ymag").get<float>());
        if (!(xmag > 0 && camera.ymag > 0))
            document.fail("cameras[{}].orthographic: xmag and ymag must not be 0", index);
        camera.aspect = xmag / camera.ymag;
    } else {
        document.fail("cameras[{}]: must be perspective or orthographic and have the object of that name", index);
    }
    return camera;
}

PunctualLight readLight(const Document& document, const Json& lights, std::size_t index) {
    const Json& object = lights[index];
    const std::string type = textOr(object, "type", "");
    PunctualLight light;
    if (type == "directional")
        light.kind = PunctualKind::Directional;
    else if (type == "spot")
        light.kind = PunctualKind::Spot;
    else if (type != "point")
        document.fail("extensions.KHR_lights_punctual.lights[{}].type: \"{}\" is none of point, spot, directional",
                      index, type);
    const Json& color = member(object, "color");
    if (!color.is_null()) light.intensity = {color[0].get<float>(), color[1].get<float>(), color[2].get<float>()};
    light.intensity = glm::max(light.intensity * valueOr(object, "intensity", 1.0F), 0.0F);
    light.range = std::max(valueOr(object, "range", 0.0F), 0.0F);
    // Exporters write inner == outer for a hard edge, which the specification does not allow but means.
    const Json& spot = member(object, "spot");
    light.outerConeAngle = std::clamp(valueOr(spot, "outerConeAngle", kPi / 4), 0.0F, kPi / 2);
    light.innerConeAngle = std::clamp(valueOr(spot, "innerConeAngle", 0.0F), 0.0F, light.outerConeAngle);
    return light;
}

}  // namespace

void readAttachments(const Document& document, const PlacedNode& placed, Scene& scene) {
    const Json& node = document.item("nodes", placed.node);
    const Json& cameraIndex = member(node, "camera");
    if (!cameraIndex.is_null()) {
        const auto index = cameraIndex.get<std::size_t>();
        Camera camera = readCamera(document, index);
        camera.name = nameOf(node, document.item("cameras", index));
        camera.worldFromCamera = withoutScale(placed.world);
        scene.cameras.push_back(std::move(camera));
    }
    const Json& lightIndex = member(extension(node, "KHR_lights_punctual"), "light");
    if (!lightIndex.is_null()) {
        const Json& lights = member(extension(document.root(), "KHR_lights_punctual"), "lights");
        const auto index = lightIndex.get<std::size_t>();
        if (index >= lights.size())
            document.fail("nodes[{}].extensions.KHR_lights_punctual.light: {}, but the file has {} lights", placed.node,
                          index, lights.size());
        PunctualLight light = readLight(document, lights, index);
        light.name = nameOf(node, lights[index]);
        light.worldFromLight = withoutScale(placed.world);
        scene.lights.push_back(std::move(light));
    }
}

}  // namespace vkpt::gltf
