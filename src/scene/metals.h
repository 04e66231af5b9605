// Complex indices of refraction of metals in three bands.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <string_view>

namespace vkpt {

struct Metal {
    std::string_view symbol;
    glm::vec3 eta, k;
};

/// Measured spectra, reduced to linear Rec. 709. Cu, Au, Ag [Palik 85], Al, Hg [Palik 85] as tabulated for Mitsuba
/// [Jakob 10]; Fe [Johnson 74] at 650, 550 and 450 nm.
inline constexpr std::array kMetals = {
    Metal{"Cu", {0.200438F, 0.924033F, 1.102212F}, {3.912949F, 2.452848F, 2.142188F}},
    Metal{"Fe", {2.9114F, 2.9497F, 2.5845F}, {3.0893F, 2.9318F, 2.7670F}},
    Metal{"Au", {0.143119F, 0.374957F, 1.442479F}, {3.983160F, 2.385721F, 1.603215F}},
    Metal{"Ag", {0.155265F, 0.116723F, 0.138381F}, {4.828343F, 3.122246F, 2.146950F}},
    Metal{"Al", {1.657460F, 0.880369F, 0.521229F}, {9.223869F, 6.269523F, 4.837001F}},
    Metal{"Hg", {2.398931F, 1.440025F, 0.909551F}, {6.327627F, 4.371941F, 3.421790F}},
};

}  // namespace vkpt
