#include "reference/warp.h"

#include "wavefront/probe_scene.h"
#include "wavefront/random_inputs.h"

namespace vkpt {
namespace {

using WarpProbe = GpuTest;

struct Out {
    glm::vec2 disk, triangle;
    glm::vec4 hemisphere;
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

TEST_F(WarpProbe, DiskAndHemisphereAreWithin4e7OfTheirTruth) {
    const auto points = squareGrid();
    const auto out = evaluate<Out>("warp", points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec2 u(points[i]);
        const glm::dvec3 expected = reference::squareToCosineHemisphere<double>(u);
        ASSERT_TRUE(isNear(out[i].disk, reference::squareToDisk<double>(u), 4e-7)) << u.x << ", " << u.y;
        const glm::dvec3 w(out[i].hemisphere);
        ASSERT_TRUE(isNear(glm::dvec2(w), glm::dvec2(expected), 4e-7)) << u.x << ", " << u.y;
        // The root turns an error of 4e-7 in the disk into one of its own size only away from the rim.
        ASSERT_TRUE(isNear(w.z * w.z, expected.z * expected.z, 1e-6)) << u.x << ", " << u.y;
        ASSERT_TRUE(isNear(glm::dot(w, w), 1, 1e-6)) << u.x << ", " << u.y;
        ASSERT_GE(w.z, 0);
    }
}

TEST_F(WarpProbe, TriangleMapEqualsReferenceExactly) {
    const auto points = squareGrid();
    const auto out = evaluate<Out>("warp", points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::vec3 expected = reference::squareToTriangle<float>(glm::vec2(points[i]));
        ASSERT_EQ(out[i].triangle, glm::vec2(expected)) << points[i].x << ", " << points[i].y;
        ASSERT_TRUE(out[i].triangle.x >= 0 && out[i].triangle.y >= 0 && out[i].triangle.x + out[i].triangle.y <= 1);
    }
}

}  // namespace
}  // namespace vkpt
