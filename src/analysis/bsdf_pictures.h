// Pictures of BSDFs: lobes in the plane of incidence, a map of the hemisphere, a sphere.
#pragma once
#include <string>
#include <vector>

#include "analysis/bsdf_measures.h"
#include "plot/drawing.h"
#include "reference/lone_bsdf.h"

namespace vkpt {

struct PicturedBsdf {
    std::string name;
    const reference::LoneBsdf* bsdf = nullptr;
    bool multiscatter = true;
};

/// A row of lobe plots, every BSDF in each, then a hemisphere map and a sphere of each.
[[nodiscard]] Drawing drawBsdfs(const std::vector<PicturedBsdf>& bsdfs);

}  // namespace vkpt
