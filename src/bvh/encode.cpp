#include "bvh/encode.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace vkpt {

namespace {

using SlotTable = std::array<std::array<float, kWideNodeSlots>, kWideNodeSlots>;

/// gain[c][s]: how far child c lies from the middle of the node towards the corner of slot s.
SlotTable slotGains(std::span<const Bounds> children) {
    Bounds all;
    for (const Bounds& box : children) all.grow(box);
    const Float4 middle = all.lo + all.hi;
    SlotTable gain{};
    for (std::size_t c = 0; c < children.size(); ++c) {
        const Float4 d = children[c].lo + children[c].hi - middle;
        for (std::uint32_t s = 0; s < kWideNodeSlots; ++s) {
            gain[c][s] =
                ((s & 1U) != 0 ? d[0] : -d[0]) + ((s & 2U) != 0 ? d[1] : -d[1]) + ((s & 4U) != 0 ? d[2] : -d[2]);
        }
    }
    return gain;
}

/// childIn[s] = c: repeatedly the child and the slot with the largest gain of those left; unused children stand for
/// empty slots.
std::array<std::uint8_t, kWideNodeSlots> assignGreedily(const SlotTable& gain, std::size_t children) {
    std::array<std::uint8_t, kWideNodeSlots> childIn{};
    std::uint32_t freeChildren = (1U << children) - 1U, freeSlots = 0xffU;
    while (freeChildren != 0) {
        float best = -INFINITY;
        std::uint32_t bestChild = 0, bestSlot = 0;
        for (std::uint32_t cs = freeChildren; cs != 0; cs &= cs - 1) {
            const auto c = static_cast<std::uint32_t>(std::countr_zero(cs));
            for (std::uint32_t ss = freeSlots; ss != 0; ss &= ss - 1) {
                const auto s = static_cast<std::uint32_t>(std::countr_zero(ss));
                if (gain[c][s] > best) best = gain[c][s], bestChild = c, bestSlot = s;
            }
        }
        childIn[bestSlot] = static_cast<std::uint8_t>(bestChild);
        freeChildren &= ~(1U << bestChild);
        freeSlots &= ~(1U << bestSlot);
    }
    auto unused = static_cast<std::uint8_t>(children);
    for (std::uint32_t s = 0; s < kWideNodeSlots; ++s) {
        if ((freeSlots >> s & 1U) != 0) childIn[s] = unused++;
    }
    return childIn;
}

float decode(float origin, std::uint32_t q, float cell) { return origin + static_cast<float>(q) * cell; }

float cellOf(std::uint32_t exponent) { return std::bit_cast<float>(exponent << 23); }

/// Smallest biased exponent whose 255 cells reach from lo to hi in float arithmetic; 0 where lo == hi.
std::uint32_t gridExponent(float lo, float hi) {
    if (!(lo < hi)) return 0;
    const int guess = std::ilogb((hi - lo) / 255.0F) + 127;
    auto exponent = static_cast<std::uint32_t>(std::clamp(guess, 1, 253));
    while (decode(lo, 255, cellOf(exponent)) < hi) ++exponent;
    return exponent;
}

std::uint32_t quantiseDown(float x, float origin, float cell) {
    if (cell == 0) return 0;
    auto q = static_cast<std::uint32_t>(std::min(255.0F, (x - origin) / cell));
    while (q > 0 && decode(origin, q, cell) > x) --q;
    return q;
}

std::uint32_t quantiseUp(float x, float origin, float cell) {
    if (cell == 0) return 0;
    auto q = static_cast<std::uint32_t>(std::min(255.0F, std::ceil((x - origin) / cell)));
    while (q < 255 && decode(origin, q, cell) < x) ++q;
    return q;
}

struct ByteLane {
    std::uint32_t low = 0, high = 0;

    void set(std::uint32_t slot, std::uint32_t value) { (slot < 4 ? low : high) |= value << (8 * (slot & 3U)); }
};

/// Quantises the children's intervals along one axis; returns the exponent byte.
std::uint32_t quantiseAxis(std::span<const WideSlot, kWideNodeSlots> slots, const Bounds& all, int axis, ByteLane& lo,
                           ByteLane& hi) {
    const float origin = all.lo[axis];
    const std::uint32_t exponent = gridExponent(origin, all.hi[axis]);
    const float cell = cellOf(exponent);
    for (std::uint32_t s = 0; s < kWideNodeSlots; ++s) {
        const bool empty = slots[s].kind == WideChildKind::Empty;
        lo.set(s, empty ? 255U : quantiseDown(slots[s].box.lo[axis], origin, cell));
        hi.set(s, empty ? 0U : quantiseUp(slots[s].box.hi[axis], origin, cell));
    }
    return exponent;
}

}  // namespace

std::array<std::uint8_t, kWideNodeSlots> assignSlots(std::span<const Bounds> children) {
    assert(children.size() <= kWideNodeSlots);
    const SlotTable gain = slotGains(children);
    auto childIn = assignGreedily(gain, children.size());
    // Each exchange raises the total gain, so that the loop ends; the bound guards against rounding cycles.
    bool improved = true;
    for (int pass = 0; improved && pass < 8; ++pass) {
        improved = false;
        for (std::uint32_t s = 0; s < kWideNodeSlots; ++s) {
            for (std::uint32_t t = s + 1; t < kWideNodeSlots; ++t) {
                const std::uint8_t a = childIn[s], b = childIn[t];
                if (gain[a][t] + gain[b][s] > gain[a][s] + gain[b][t]) {
                    std::swap(childIn[s], childIn[t]);
                    improved = true;
                }
            }
        }
    }
    std::array<std::uint8_t, kWideNodeSlots> slotOf{};
    for (std::uint32_t s = 0; s < kWideNodeSlots; ++s) slotOf[childIn[s]] = static_cast<std::uint8_t>(s);
    return slotOf;
}

WideNode encodeWideNode(std::span<const WideSlot, kWideNodeSlots> slots, std::uint32_t childBase,
                        std::uint32_t itemBase) {
    Bounds all;
    ByteLane meta;
    std::uint32_t innerMask = 0, items = 0;
    for (std::uint32_t s = 0; s < kWideNodeSlots; ++s) {
        const WideSlot& slot = slots[s];
        if (slot.kind == WideChildKind::Empty) continue;
        all.grow(slot.box);
        if (slot.kind == WideChildKind::Inner) {
            innerMask |= 1U << s;
            meta.set(s, 1U << 5 | (24U + s));
        } else {
            assert(slot.count >= 1 && slot.count <= kWideNodeLeafItems);
            meta.set(s, ((1U << slot.count) - 1U) << 5 | items);
            items += slot.count;
        }
    }
    if (all.empty()) all.lo = all.hi = Float4{};

    WideNode node{};
    ByteLane lo[3], hi[3];
    node.exponents = innerMask << 24;
    for (int axis = 0; axis < 3; ++axis) {
        node.origin[axis] = all.lo[axis];
        node.exponents |= quantiseAxis(slots, all, axis, lo[axis], hi[axis]) << (8 * axis);
    }
    node.childBase = childBase;
    node.itemBase = itemBase;
    node.meta0 = meta.low, node.meta1 = meta.high;
    node.loX0 = lo[0].low, node.loX1 = lo[0].high, node.hiX0 = hi[0].low, node.hiX1 = hi[0].high;
    node.loY0 = lo[1].low, node.loY1 = lo[1].high, node.hiY0 = hi[1].low, node.hiY1 = hi[1].high;
    node.loZ0 = lo[2].low, node.loZ1 = lo[2].high, node.hiZ0 = hi[2].low, node.hiZ1 = hi[2].high;
    return node;
}

}  // namespace vkpt
