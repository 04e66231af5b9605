// Pixel filters, as tables to draw positions from. [Ernst 06]
#pragma once
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "constants.h"
#include "layout.h"

namespace vkpt {

struct FilterInfo {
    std::uint32_t id;  ///< kFilter*
    std::string_view name;
    float radius;  ///< pixels, by default
    std::string_view help;
};

/// Separable filters, zero beyond their radius. gaussian: sigma is a third of the radius, less its value at the
/// radius; mitchell: B = C = 1/3, stretched to the radius. [Mitchell 88]
inline constexpr auto kFilters = std::to_array<FilterInfo>({
    {kFilterBox, "box", 0.5F, "one pixel, all alike"},
    {kFilterTent, "tent", 1, "falls to nothing at the next pixel's middle"},
    {kFilterGaussian, "gaussian", 1.5F, "sigma of a third of the radius"},
    {kFilterBlackmanHarris, "blackman-harris", 0.75F, "a window of four cosines"},
    {kFilterMitchell, "mitchell", 2, "sharpens: has lobes below 0"},
});

/// Whether it takes light away somewhere.
[[nodiscard]] constexpr bool hasNegativeLobes(std::uint32_t filter) { return filter == kFilterMitchell; }

/// Value at x, -1 to 1 over the radius, up to a factor.
[[nodiscard]] double filterValue(std::uint32_t filter, double x);

/// kFilterSteps intervals to draw from evenly, all alike. Each stands for a share of a lobe of one sign, with its mean
/// and variance: so the table has the filter's own moments up to the second, though it is flat within an interval. The
/// weights average to 1. Empty for the box of one pixel.
[[nodiscard]] std::vector<FilterCell> filterTable(const RenderParams& params);

}  // namespace vkpt
