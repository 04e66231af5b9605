#include "scene/default_light.h"

#include <algorithm>

namespace vkpt {

bool hasOwnLight(const SceneArrays& arrays) {
    if (arrays.features.punctualLights || arrays.features.environment) return true;
    return std::any_of(arrays.triangles.begin(), arrays.triangles.end(), [&](const TriangleRecord& triangle) {
        const MaterialRecord& material = arrays.materials[triangle.flags >> kTriangleMaterialShift];
        return material.emissive != glm::vec3(0) && material.emissiveTexture == kNone;
    });
}

}  // namespace vkpt
