#include "scene/flatten.h"

#include "base/math.h"
#include "scene/flatten_geometry.h"
#include "scene/flatten_lights.h"
#include "scene/flatten_materials.h"

namespace vkpt {

SceneArrays flatten(const Scene& scene, const FlattenOptions& options) {
    SceneArrays arrays;
    const std::vector<MaterialTraits> traits = materialTraits(scene);
    flattenMaterials(scene, traits, options.multiscatter, arrays);
    flattenGeometry(scene, options, traits, arrays);
    flattenLights(scene, arrays);
    for (const PunctualLight& light : scene.lights)
        if (luminance(light.intensity) > 0) arrays.punctualNames.push_back(light.name);  // those that it takes
    return arrays;
}

}  // namespace vkpt
