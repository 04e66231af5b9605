// Where to cut a range of items in two.
#pragma once
#include <span>

#include "bvh/bounds.h"

namespace vkpt {

/// A range of items about to be split.
struct SplitRange {
    std::span<ItemRef> items;
    Bounds centroids;  ///< of twice the middles of the items' boxes
};

struct SplitResult {
    SplitRange left, right;
};

/// Reorders range.items (at least 2) in two non-empty parts of least surface area cost: exactly for few items, else
/// with 16 bins along each axis [Wald 07]. Falls back to halves by count where all centroids agree.
[[nodiscard]] SplitResult splitBySah(const SplitRange& range, float areaScale);

/// Halves by count along the widest axis: the depth of a tree of n items is then ceil(log2 n).
[[nodiscard]] SplitResult splitByCount(const SplitRange& range);

/// Box of the items' boxes, box of their centroids. Parallel where there are many.
[[nodiscard]] Bounds boundsOf(std::span<const ItemRef> items);
[[nodiscard]] Bounds centroidBoundsOf(std::span<const ItemRef> items);

}  // namespace vkpt
