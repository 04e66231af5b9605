// What becomes of light that more than one facet of a rough surface meets: a random walk on Smith's microsurface of GGX
// facets. [Heitz 16] Measured for the albedo tables.
#pragma once

namespace vkpt::facets {

/// A straight line over x in [0, 1], by least squares over such light under uniform illumination.
struct Line {
    double at0 = 0, at1 = 0;
};

/// Facets that reflect all. x = (1 - cosine)^2 of the direction that the light comes from.
struct MetalWalk {
    Line more;   ///< how many facets light meets after the first
    Line angle;  ///< mean of (1 - c)^3 over all facets, c the cosine at a facet
};
[[nodiscard]] MetalWalk walkOnMetal(double alpha);

/// Share of it that ends beyond the surface. eta = ior beyond / ior on the side that light comes from; x = cosine^2 (2
/// - cosine).
struct GlassWalk {
    double share = 0;  ///< mean
    Line at;           ///< by direction
};
[[nodiscard]] GlassWalk walkOnGlass(double alpha, double eta);

}  // namespace vkpt::facets
