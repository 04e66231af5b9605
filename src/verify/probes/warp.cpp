#include "reference/warp.h"

#include <cmath>
#include <numbers>

#include "verify/context.h"
#include "verify/inputs/random_inputs.h"
#include "verify/probes.h"

namespace vkpt {
namespace {

struct Out {
    glm::vec2 disk, unused;
    glm::vec4 hemisphere, uniform;
};

/// A grid that meets the diagonals, the middle and the borders of the square, and points in between.
std::vector<glm::vec4> squareGrid() {
    std::vector<glm::vec4> points;
    for (int y = 0; y <= 32; ++y)
        for (int x = 0; x <= 32; ++x)
            points.push_back({std::min(x / 32.0F, 0x1.fffffep-1F), std::min(y / 32.0F, 0x1.fffffep-1F), 0, 0});
    RandomInputs random(4);
    for (int i = 0; i < 4000; ++i) points.emplace_back(random.square(), 0, 0);
    return points;
}

}  // namespace

void checkWarp(VerifyContext& context, Findings& findings) {
    const auto points = squareGrid();
    const auto out = context.prober().evaluate<Out>("warp", points);
    const auto scope =
        findings.inputs([&](std::size_t i) { return "the point " + show(glm::vec2(points[i])) + " of the square"; });
    for (std::size_t i = 0; i < points.size(); ++i) {
        findings.at(i);
        const glm::dvec2 u(points[i]);
        findings.near("squareToDisk", out[i].disk, reference::squareToDisk<double>(u), 4e-7);
        const glm::dvec3 w(out[i].hemisphere), expected = reference::squareToCosineHemisphere<double>(u);
        findings.near("squareToCosineHemisphere", glm::dvec2(w), glm::dvec2(expected), 4e-7);
        // The root turns an error of 4e-7 in the disk into one of its own size only away from the rim.
        findings.near("its squared height", w.z * w.z, expected.z * expected.z, 1e-6);
        findings.near("its length", glm::dot(w, w), 1, 1e-6);
        findings.holds("its side", w.z >= 0, "is below the surface");

        const glm::dvec3 even(out[i].uniform);
        const double turns = 2 * std::numbers::pi * u.x, radius = glm::length(glm::dvec2(even));
        findings.equal("height of squareToUniformHemisphere", out[i].uniform.z, points[i].y);
        findings.near("its azimuth", glm::dvec2(even), radius * glm::dvec2(std::cos(turns), std::sin(turns)), 4e-7);
        findings.near("its length", glm::dot(even, even), 1, 1e-6);
    }
}

}  // namespace vkpt
