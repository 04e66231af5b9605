// The device's path state in the reference's words.
#pragma once
#include <array>

#include "film/wide_integer.h"
#include "reference/path.h"
#include "wavefront/renderer.h"

namespace vkpt {

/// Sums are taken modulo this.
inline constexpr U128 kModulus = U128{1} << 96U;

/// Exact sums of one path: three channels of 96 bits, in two's complement.
using PathSums = std::array<U128, 3>;

/// One batch of the device, and how to read it.
class DevicePaths {
public:
    DevicePaths(const SceneArrays& scene, const RenderOptions& options)
        : scene_(scene), width_(options.params.width), tracer_(scene, options) {}

    [[nodiscard]] const reference::PathTracer& tracer() const { return tracer_; }

    struct Place {
        std::uint32_t x = 0, y = 0, index = 0;
    };
    /// Pixel and sample of a slot.
    [[nodiscard]] Place placeOf(const BatchParams& batch, std::uint32_t path) const;
    /// Where the path stands before segment `bounce`.
    [[nodiscard]] reference::PathState stateOf(const StageSnapshot& device, std::uint32_t path,
                                               std::uint32_t bounce) const;
    /// What its segment met, once the intersect kernel has run.
    [[nodiscard]] reference::Hit hitOf(const StageSnapshot& device, std::uint32_t path) const;

private:
    const SceneArrays& scene_;
    std::uint32_t width_;
    reference::PathTracer tracer_;
};

[[nodiscard]] PathSums sumsOf(const StageSnapshot& device, std::uint32_t path);
[[nodiscard]] inline std::uint32_t alphaOf(const StageSnapshot& device, std::uint32_t path) {
    return device.word(StateArray::Red, path).w;
}
/// now - before, modulo 2^96.
[[nodiscard]] PathSums changeOf(const PathSums& before, const PathSums& now);
/// now - before, in nits; both are of one path.
[[nodiscard]] glm::dvec3 addedTo(const PathSums& before, const PathSums& now);

/// One light sample that the shade kernel queued.
struct DeviceShadow {
    std::uint32_t path = 0;
    reference::DirectLight light;
};
[[nodiscard]] DeviceShadow shadowOf(const StageSnapshot& device, std::uint32_t item);

}  // namespace vkpt
