// One node at a time: quantised boxes contain, slots follow the octants.
#include "bvh/encode.h"

#include <gtest/gtest.h>

#include <cmath>

#include "verify/inputs/soups.h"

namespace vkpt {
namespace {

Bounds boxAround(const vec3& a, const vec3& b) {
    const vec3 lo = glm::min(a, b), hi = glm::max(a, b);
    return {Float4{lo.x, lo.y, lo.z, 0}, Float4{hi.x, hi.y, hi.z, 0}};
}

/// Cells of the grid that the decoded interval exceeds the true one by, at most.
float excessInCells(const WideNode& node, std::uint32_t slot, const Bounds& box) {
    const Box decoded = wideBox(node, slot);
    float worst = 0;
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_LE(decoded.lo[axis], box.lo[axis]);
        EXPECT_GE(decoded.hi[axis], box.hi[axis]);
        const float cell = wideCell(node, axis);
        if (cell == 0) continue;
        worst = std::max(worst, (box.lo[axis] - decoded.lo[axis]) / cell);
        worst = std::max(worst, (decoded.hi[axis] - box.hi[axis]) / cell);
    }
    return worst;
}

TEST(WideNodeEncoding, ContainsItsChildrenTightlyAtEveryScale) {
    Random random(5);
    for (const float scale : {1e-37F, 1e-20F, 1e-5F, 1.0F, 1e3F, 1e20F, 4e36F}) {
        for (const float offset : {0.0F, 1.0F, 1e3F, 1e6F}) {
            if (scale * offset > 1e37F) continue;
            SCOPED_TRACE(testing::Message() << "scale " << scale << " offset " << offset);
            for (int round = 0; round < 50; ++round) {
                std::array<WideSlot, kWideNodeSlots> slots;
                for (WideSlot& slot : slots) {
                    const vec3 shift = vec3(offset, -offset, 0.5F * offset), at = shift + random.vec();
                    slot = {WideChildKind::Leaf, 1, boxAround(scale * at, scale * (at + 0.1F * random.vec()))};
                }
                const WideNode node = encodeWideNode(slots, 0, 0);
                for (std::uint32_t s = 0; s < kWideNodeSlots; ++s) {
                    // Far from the origin a cell may be finer than floats are there: their rounding is allowed too.
                    const float cell = wideCell(node, 0);
                    const float ulps = cell > 0 ? 2 * offset * scale * 0x1p-22F / cell : 0;
                    EXPECT_LE(excessInCells(node, s, slots[s].box), 1.01F + ulps);
                }
            }
        }
    }
}

TEST(WideNodeEncoding, UsesMoreThanHalfOfTheGrid) {
    Random random(6);
    for (int round = 0; round < 200; ++round) {
        std::array<WideSlot, kWideNodeSlots> slots;
        slots[3] = {WideChildKind::Leaf, 1, boxAround(random.vec(), random.vec())};
        slots[5] = {WideChildKind::Leaf, 1, boxAround(random.vec(), random.vec())};
        const WideNode node = encodeWideNode(slots, 0, 0);
        EXPECT_GE(std::max(wideByte(node.hiX0, node.hiX1, 3), wideByte(node.hiX0, node.hiX1, 5)), 127U);
        EXPECT_GE(std::max(wideByte(node.hiZ0, node.hiZ1, 3), wideByte(node.hiZ0, node.hiZ1, 5)), 127U);
    }
}

TEST(WideNodeEncoding, FlatNodesAreExact) {
    std::array<WideSlot, kWideNodeSlots> slots;
    slots[0] = {WideChildKind::Leaf, 3, boxAround({0.1F, 7.3F, 0.2F}, {0.4F, 7.3F, 0.9F})};
    const WideNode node = encodeWideNode(slots, 0, 0);
    EXPECT_EQ(wideCell(node, 1), 0.0F);
    EXPECT_EQ(wideBox(node, 0).lo.y, 7.3F);
    EXPECT_EQ(wideBox(node, 0).hi.y, 7.3F);
}

TEST(WideNodeEncoding, ReadsBackKindsBasesAndCounts) {
    std::array<WideSlot, kWideNodeSlots> slots;
    const Bounds box = boxAround({0, 0, 0}, {1, 1, 1});
    slots[1] = {WideChildKind::Leaf, 2, box};
    slots[2] = {WideChildKind::Inner, 0, box};
    slots[4] = {WideChildKind::Leaf, 3, box};
    slots[6] = {WideChildKind::Inner, 0, box};
    slots[7] = {WideChildKind::Leaf, 1, box};
    const WideNode node = encodeWideNode(slots, 100, 50);
    EXPECT_EQ(wideInnerMask(node), 0b01000100U);
    EXPECT_EQ(wideMeta(node, 1), 0b011'00000U);
    EXPECT_EQ(wideMeta(node, 2), 0b001'11010U);
    EXPECT_EQ(wideMeta(node, 4), 0b111'00010U);
    EXPECT_EQ(wideMeta(node, 7), 0b001'00101U);
    EXPECT_EQ(wideChild(node, 2).first, 100U);
    EXPECT_EQ(wideChild(node, 6).first, 101U);
    EXPECT_EQ(wideChild(node, 4).first, 52U);
    EXPECT_EQ(wideChild(node, 4).count, 3U);
    EXPECT_EQ(wideChild(node, 0).kind, WideChildKind::Empty);
}

TEST(WideNodeSlots, ChildrenInTheCornersGetTheCornersSlots) {
    std::array<Bounds, kWideNodeSlots> boxes;
    for (std::uint32_t s = 0; s < kWideNodeSlots; ++s) {
        const std::uint32_t corner = s ^ 5U;
        const vec3 at((corner & 1U) != 0 ? 1 : -1, (corner & 2U) != 0 ? 1 : -1, (corner & 4U) != 0 ? 1 : -1);
        boxes[s] = boxAround(at - 0.5F, at + 0.5F);
    }
    const auto slotOf = assignSlots(boxes);
    for (std::uint32_t c = 0; c < kWideNodeSlots; ++c) EXPECT_EQ(slotOf[c], c ^ 5U);
}

/// Sum of distances towards the slots' corners; what the assignment maximises.
double gainOf(std::span<const Bounds> boxes, std::size_t child, std::uint32_t slot) {
    Bounds all;
    for (const Bounds& box : boxes) all.grow(box);
    double gain = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double d = double{boxes[child].lo[axis]} + boxes[child].hi[axis] - all.lo[axis] - all.hi[axis];
        gain += (slot >> axis & 1U) != 0 ? d : -d;
    }
    return gain;
}

TEST(WideNodeSlots, AssignmentIsWithinTwoPercentOfTheBest) {
    Random random(9);
    double reached = 0, possible = 0;
    for (int round = 0; round < 200; ++round) {
        const std::size_t n = 2 + static_cast<std::size_t>(round) % 7;
        std::vector<Bounds> boxes;
        for (std::size_t c = 0; c < n; ++c) {
            const vec3 at = random.vec();
            boxes.push_back(boxAround(at, at + 0.2F * random.vec()));
        }
        const auto slotOf = assignSlots(boxes);
        std::uint32_t used = 0;
        for (std::size_t c = 0; c < n; ++c) {
            used |= 1U << slotOf[c];
            reached += gainOf(boxes, c, slotOf[c]);
        }
        EXPECT_EQ(static_cast<std::size_t>(std::popcount(used)), n) << "two children in one slot";
        // Exact: best[set] is the most that the first popcount(set) children gain in the slots of the set.
        std::array<double, 256> best{};
        for (std::uint32_t set = 1; set < 256; ++set) {
            const auto c = static_cast<std::size_t>(std::popcount(set)) - 1;
            best[set] = -INFINITY;
            for (std::uint32_t s = 0; c < n && s < 8; ++s) {
                if ((set >> s & 1U) != 0) best[set] = std::max(best[set], best[set ^ 1U << s] + gainOf(boxes, c, s));
            }
        }
        double optimum = -INFINITY;
        for (std::uint32_t set = 1; set < 256; ++set) {
            if (static_cast<std::size_t>(std::popcount(set)) == n) optimum = std::max(optimum, best[set]);
        }
        possible += optimum;
    }
    EXPECT_GT(reached, 0.98 * possible);
    EXPECT_LT(reached, 1.0001 * possible);
}

}  // namespace
}  // namespace vkpt
