// Packs one wide node: slots of its children, quantised boxes.
#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "bvh/bounds.h"
#include "bvh/wide_node.h"

namespace vkpt {

/// What goes into one slot.
struct WideSlot {
    WideChildKind kind = WideChildKind::Empty;
    std::uint32_t count = 0;  ///< items of a leaf, 1 to kWideNodeLeafItems
    Bounds box;
};

/// A slot for each child (at most 8), so that slot ^ octant orders them roughly front to back for rays of any octant:
/// minimises the sum of the children's distances along their slots' diagonals. [Ylitie 17] assign by auction; here a
/// greedy choice is improved by exchanges, which comes within two percent of the best.
[[nodiscard]] std::array<std::uint8_t, kWideNodeSlots> assignSlots(std::span<const Bounds> children);

/// Encodes a node; the decoded boxes contain slots[].box exactly (see wide_node.h). All slots may be empty.
[[nodiscard]] WideNode encodeWideNode(std::span<const WideSlot, kWideNodeSlots> slots, std::uint32_t childBase,
                                      std::uint32_t itemBase);

}  // namespace vkpt
