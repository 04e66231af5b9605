// How good a finished tree is, read from its nodes alone.
#pragma once
#include "bvh/build.h"

namespace vkpt {

/// Figures of arrays.nodes, as far as the finished tree tells them: all of BvhStats but the builder's own
/// (seconds, temporaryBytes, balancedTrees).
[[nodiscard]] BvhStats measureBvh(const SceneArrays& arrays, const BvhConfig& config = {});

}  // namespace vkpt
