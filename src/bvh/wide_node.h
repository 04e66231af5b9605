// The encoding of WideNode, for the builder, the CPU reference and the tests. Header only, no allocation.
//
// A node has eight slots. Meta byte of slot s: [Ylitie 17]
//   empty 0                              no child
//   inner (1 << 5) | (24 + s)            bit s of the inner mask (top byte of `exponents`) is set too
//   leaf  unary(count) << 5 | offset     unary: 1 -> 001, 2 -> 011, 3 -> 111; items itemBase + offset onwards
// Inner children lie at childBase, childBase + 1, … in slot order; the items of all leaves of a node lie at itemBase
// onwards in slot order. An item is a triangle, or in the top level an instance.
//
// Box of slot s on axis a: [origin_a + lo * 2^e, origin_a + hi * 2^e], with 2^e = uintBitsToFloat(e_a << 23), e_a the
// byte of axis a in `exponents`. e_a = 0 means 0: the node is flat along a. q * 2^e is exact in float and the sum is
// rounded once, so that a fused multiply-add decodes the same box. Boxes decoded so contain what is below them; the
// rounding of the ray-box test itself is the traversal's to bound. An empty slot has lo = 255, hi = 0.
//
// Order: bit a of a slot (x: 1, y: 2, z: 4) tells on which side of the node's middle the child lies. With
// octant = (d.x < 0) | (d.y < 0) << 1 | (d.z < 0) << 2 the children are met roughly front to back in increasing order
// of slot ^ octant; a meta byte's low five bits XOR (7 - octant) are a bit index whose highest bit comes first.
#pragma once
#include <bit>
#include <cstdint>
#include <glm/glm.hpp>

#include "constants.h"
#include "layout.h"

namespace vkpt {

inline constexpr std::uint32_t kWideNodeSlots = 8;

/// Levels of nodes a path from the root can cross: top level, one mesh, both together. buildBvh keeps to them.
/// A traversal that stacks one entry (the slots not yet visited) a level, and one for the instances not yet visited
/// of the top-level node it left, needs one entry less than the levels, at most kMaxBvhDepth - 1.
inline constexpr std::uint32_t kMaxTopDepth = 10;
inline constexpr std::uint32_t kMaxMeshDepth = 22;
inline constexpr std::uint32_t kMaxBvhDepth = kMaxTopDepth + kMaxMeshDepth;
static_assert(kMaxBvhDepth - 1 <= kMaxStackEntries);

struct Box {
    glm::vec3 lo{0}, hi{0};
};

enum class WideChildKind : std::uint8_t { Empty, Inner, Leaf };

/// What one slot says: for Inner `first` is the child's node index, for Leaf its first item of `count`.
struct WideChild {
    WideChildKind kind = WideChildKind::Empty;
    std::uint32_t first = 0, count = 0;
    Box box;
};

[[nodiscard]] inline std::uint32_t wideByte(std::uint32_t low, std::uint32_t high, std::uint32_t slot) {
    return ((slot < 4 ? low : high) >> (8 * (slot & 3))) & 0xffU;
}

[[nodiscard]] inline std::uint32_t wideMeta(const WideNode& node, std::uint32_t slot) {
    return wideByte(node.meta0, node.meta1, slot);
}

/// Bit s is set where slot s holds an inner node.
[[nodiscard]] inline std::uint32_t wideInnerMask(const WideNode& node) { return node.exponents >> 24; }

/// Size of a grid cell along `axis`: a power of two, or 0 where the node is flat.
[[nodiscard]] inline float wideCell(const WideNode& node, int axis) {
    return std::bit_cast<float>(((node.exponents >> (8 * axis)) & 0xffU) << 23);
}

[[nodiscard]] inline Box wideBox(const WideNode& node, std::uint32_t slot) {
    const glm::vec3 cell{wideCell(node, 0), wideCell(node, 1), wideCell(node, 2)};
    const glm::vec3 lo{wideByte(node.loX0, node.loX1, slot), wideByte(node.loY0, node.loY1, slot),
                       wideByte(node.loZ0, node.loZ1, slot)};
    const glm::vec3 hi{wideByte(node.hiX0, node.hiX1, slot), wideByte(node.hiY0, node.hiY1, slot),
                       wideByte(node.hiZ0, node.hiZ1, slot)};
    return {node.origin + lo * cell, node.origin + hi * cell};
}

[[nodiscard]] inline WideChild wideChild(const WideNode& node, std::uint32_t slot) {
    const std::uint32_t meta = wideMeta(node, slot), low = meta & 31U;
    if (meta == 0) return {};
    if (low >= 24) {
        const std::uint32_t before = wideInnerMask(node) & ((1U << slot) - 1U);
        return {WideChildKind::Inner, node.childBase + static_cast<std::uint32_t>(std::popcount(before)), 1,
                wideBox(node, slot)};
    }
    return {WideChildKind::Leaf, node.itemBase + low, static_cast<std::uint32_t>(std::popcount(meta >> 5)),
            wideBox(node, slot)};
}

}  // namespace vkpt
