// BSDFs of every model of the registry, over their parameters.
#pragma once
#include <string>
#include <vector>

#include "registry.h"
#include "scene/scene_arrays.h"

namespace vkpt {

struct BsdfCase {
    BsdfId model = BsdfId::Gltf;
    std::uint32_t material = 0;  ///< its BsdfRecord
    std::string text;            ///< what it is, for reports
};

/// Records and albedo tables of `cases`, no geometry.
struct BsdfCases {
    SceneArrays scene;
    std::vector<BsdfCase> cases;
};

/// A table whose albedos vary smoothly: what is looked up in it need not be true of any surface.
[[nodiscard]] std::vector<AlbedoCell> makeSmoothTable(std::uint32_t seed);

/// Every model but glTF's, with every distribution and masking that it may have, smooth to rough, isotropic or not.
[[nodiscard]] BsdfCases makeBsdfCases(bool multiscatter);

}  // namespace vkpt
