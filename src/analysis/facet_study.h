// The microsurface of a BSDF, a degree at a time: its distribution of normals and what hides them.
#pragma once
#include "base/json.h"
#include "reference/lone_bsdf.h"

namespace vkpt {

/// In the plane of the x axis, where a direction tilts from the normal by -89 to 89 degrees: `D` of facets tilted so;
/// `G1` towards it and `G2` of it and its mirror image, both of facets that face the normal; `G2From60` of it and of
/// a direction at -60 degrees. Null for models without microfacets, with two distributions, or smooth.
[[nodiscard]] Json facetsJson(const reference::LoneBsdf& bsdf);

}  // namespace vkpt
