// Sorts lights, emissive meshes and surroundings into groups by name.
#pragma once
#include <string>
#include <vector>

#include "scene/scene_arrays.h"

namespace vkpt {

/// Which groups there are to be.
struct LightGroupChoice {
    bool on = false;
    std::vector<std::string> names;  ///< only these, and kOtherLights for the rest; empty: every name
};

inline constexpr const char* kEnvironmentGroup = "environment";
inline constexpr const char* kOtherLights = "others";

/// Fills arrays.lightGroups. What has the same name is in the same group: punctual lights by their own, meshes that
/// emit or are unlit by that of their node, or of the mesh; "light2", "mesh5" where they have none, counted among the
/// lights that shine and the mesh instances; environment and background as kEnvironmentGroup. Groups come in the order
/// of meshes, lights, environment. `backgroundShines`: the camera sees one that is no environment. Environment and
/// lights must be in place. Throws FileError, naming `file`, for more than kMostLightGroups groups and where nothing
/// shines, Error (Usage) for a chosen name that the scene lacks.
void groupLights(SceneArrays& arrays, const LightGroupChoice& choice, bool backgroundShines, const std::string& file);

}  // namespace vkpt
