#include "scene/flatten.h"

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
    return arrays;
}

}  // namespace vkpt
