// Closest and any hit in the compressed wide BVH that buildBvh made; the code shares nothing with the shaders.
#pragma once
#include <optional>

#include "reference/hit.h"

namespace vkpt::reference {

/// What a search did.
struct SearchCost {
    std::uint32_t nodes = 0;      ///< whose children's boxes were tested
    std::uint32_t triangles = 0;  ///< that were tested
};

/// The nearest surface with 0 < t that is there for this ray: neither the back of a single-sided triangle nor one
/// that the alpha test under `alphaKey` removes. Of equal t the lower `primitive`, then the lower instance. `cost` is
/// added to where it is given.
[[nodiscard]] std::optional<Hit> closestHit(const SceneArrays& scene, const Ray& ray, std::uint32_t alphaKey,
                                            SearchCost* cost = nullptr);

/// Whether any such surface lies at 0 < t < tMax.
[[nodiscard]] bool anyHit(const SceneArrays& scene, const Ray& ray, float tMax, std::uint32_t alphaKey);

}  // namespace vkpt::reference
