// Boxes as pairs of four-lane vectors, so that a box grows in two instructions. The fourth lane is unused.
#pragma once
#include <bit>
#include <cstdint>
#include <limits>

namespace vkpt {

typedef float Float4 __attribute__((vector_size(16)));
typedef std::int32_t Int4 __attribute__((vector_size(16)));

[[nodiscard]] inline Float4 minimum(Float4 a, Float4 b) { return a < b ? a : b; }
[[nodiscard]] inline Float4 maximum(Float4 a, Float4 b) { return a > b ? a : b; }

/// Coordinates beyond this are clamped: extents, sums of corners and grids of 255 cells then stay finite.
inline constexpr float kMaxCoordinate = 1e37F;

struct Bounds {
    Float4 lo = Float4{} + std::numeric_limits<float>::max();
    Float4 hi = Float4{} - std::numeric_limits<float>::max();

    void grow(Float4 point) {
        lo = minimum(lo, point);
        hi = maximum(hi, point);
    }
    void grow(const Bounds& other) {
        lo = minimum(lo, other.lo);
        hi = maximum(hi, other.hi);
    }
    [[nodiscard]] bool empty() const { return lo[0] > hi[0]; }
};

/// Half the surface of a box in units of scale^-2; `scale` keeps the products of huge and tiny extents in range.
/// At least kLeastArea, so that where areas vanish (points, lines) costs count items and nodes. A power of two keeps
/// such costs exact, and ties ties.
inline constexpr float kLeastArea = 0x1p-66F;

[[nodiscard]] inline float halfArea(const Bounds& box, float scale) {
    const Float4 d = (box.hi - box.lo) * scale;
    const float area = d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
    return area > kLeastArea ? area : kLeastArea;
}

/// What the builder sorts: the box of a triangle or an instance, and its index. 32 bytes, uninitialised by default.
/// The index lives in the fourth lane of `lo`, as the bits of a float of 1 or more: differences of
/// such are never denormal, which would slow the arithmetic on all lanes.
struct ItemRef {
    Float4 lo, hi;

    ItemRef() = default;
    ItemRef(const Bounds& box, std::uint32_t index) : lo(box.lo), hi(box.hi) {
        lo[3] = std::bit_cast<float>(index + kIndexBias);
        hi[3] = 0;
    }
    [[nodiscard]] std::uint32_t index() const { return std::bit_cast<std::uint32_t>(float{lo[3]}) - kIndexBias; }
    [[nodiscard]] Bounds box() const { return {lo, hi}; }
    /// Twice the box's middle.
    [[nodiscard]] Float4 centroid() const { return lo + hi; }

private:
    static constexpr std::uint32_t kIndexBias = 0x3f800000;  ///< bits of 1.0F; indices stay below 2^30
};

}  // namespace vkpt
