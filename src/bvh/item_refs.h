// The boxes that trees are built over.
#pragma once
#include <span>

#include "bvh/bounds.h"
#include "bvh/wide_node.h"
#include "layout.h"

namespace vkpt {

/// One ItemRef a triangle, indexed from 0. The boxes are exact. A triangle that cannot be met, since a corner is not
/// finite or beyond kMaxCoordinate, counts as the point v0, or as the origin where v0 itself is at fault.
void makeTriangleRefs(std::span<const TriangleRecord> triangles, std::span<ItemRef> refs);

/// World box of `boxes` of object space placed by `instance`, widened by the rounding of both its matrices: a ray
/// taken to object space that meets what is inside meets this box before.
[[nodiscard]] Bounds placedBounds(const InstanceRecord& instance, std::span<const Box> boxes);

}  // namespace vkpt
