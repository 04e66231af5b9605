// Camera rays: pixel filters, the thin lens, the panorama.
#include "reference/camera.h"

#include <gtest/gtest.h>

#include "dimensions.h"
#include "reference/surface.h"
#include "scene/pixel_filter.h"
#include "test_scene.h"

namespace vkpt::reference {
namespace {

using namespace test;

constexpr int kGrid = 128;

/// Calls visit(u) for the middles of a grid over the unit square, and returns how many there are.
template <class Visit>
double overSquare(Visit&& visit) {
    for (int i = 0; i < kGrid * kGrid; ++i)
        visit(Vec2<float>((i % kGrid + 0.5F) / kGrid, (static_cast<float>(i / kGrid) + 0.5F) / kGrid));
    return kGrid * kGrid;
}

TEST(SampleFilter, WithoutATableIsThePixel) {
    const FilmPlace place = sampleFilter({}, {0.25F, 0.75F});
    EXPECT_EQ(place.position, glm::vec2(0.25F, 0.75F));
    EXPECT_EQ(place.weight, 1);
}

// Any filter is 1 in the mean, and symmetric about the middle of the pixel.
TEST(SampleFilter, WeightsAverageToOneAroundTheMiddle) {
    for (const FilterInfo& info : kFilters) {
        RenderParams params = defaultParams();
        params.pixelFilter = info.id;
        params.filterRadius = info.radius;
        const auto cells = filterTable(params);
        glm::dvec3 sum(0);
        const double n = overSquare([&](const Vec2<float>& u) {
            const FilmPlace place = sampleFilter(cells, u);
            EXPECT_LE(std::abs(place.position.x - 0.5F), info.radius);
            sum += double{place.weight} * glm::dvec3(1, place.position);
        });
        EXPECT_NEAR(sum.x / n, 1, 2e-3) << info.name;
        EXPECT_NEAR(sum.y / n, 0.5, 5e-3) << info.name;
        EXPECT_NEAR(sum.z / n, 0.5, 5e-3) << info.name;
    }
}

RenderParams someCamera(std::uint32_t projection) {
    RenderParams p = defaultParams();
    p.width = 40;
    p.height = 20;
    p.eye = {1, 2, 3};
    p.forward = glm::normalize(glm::vec3(1, -1, 2));
    const glm::vec3 right = glm::normalize(glm::cross(p.forward, glm::vec3(0, 1, 0)));
    const bool panorama = projection == kProjectionPanorama;
    p.right = (panorama ? 1.0F : 2.0F) * right;
    p.up = glm::cross(right, p.forward);
    p.projection = projection;
    p.lensRadius = 0.5F;
    p.focusDistance = 6;
    return p;
}

// Every ray through one point of the film meets the others in the plane of focus; the lens is a disk, evenly used.
TEST(ThinLens, RaysOfOnePointMeetInThePlaneOfFocus) {
    for (const std::uint32_t projection : {kProjectionPerspective, kProjectionOrthographic}) {
        const RenderParams p = someCamera(projection);
        const Ray pinhole = cameraRay(p, {33, 4});
        const glm::vec3 focus =
            pinhole.origin + pinhole.direction * (p.focusDistance / glm::dot(pinhole.direction, p.forward));
        EXPECT_NEAR(glm::dot(focus - p.eye, p.forward), 6, 1e-5);
        glm::dvec2 mean(0);
        double square = 0;
        const double n = overSquare([&](const Vec2<float>& u) {
            const Ray ray = lensRay(p, pinhole, u);
            const glm::vec3 offset = ray.origin - pinhole.origin;
            ASSERT_LE(glm::length(offset), 0.5F + 1e-5F);
            ASSERT_NEAR(glm::dot(offset, p.forward), 0, 1e-6);
            ASSERT_NEAR(glm::length(ray.direction), 1, 1e-6);
            ASSERT_LT(glm::length(glm::cross(ray.direction, focus - ray.origin)), 1e-5F);
            mean += glm::dvec2(glm::dot(offset, glm::normalize(p.right)), glm::dot(offset, p.up));
            square += double{glm::dot(offset, offset)};
        });
        EXPECT_LT(glm::length(mean) / n, 1e-6);
        EXPECT_NEAR(square / n, 0.5 * 0.25, 1e-4) << "mean of r^2 over a disk is R^2/2";
    }
}

TEST(Panorama, IsTheWholeSphereWithForwardInItsMiddle) {
    const RenderParams p = someCamera(kProjectionPanorama);
    const auto look = [&](float x, float y) { return cameraRay(p, {x, y}).direction; };
    EXPECT_EQ(cameraRay(p, {1, 1}).origin, p.eye);
    EXPECT_LT(glm::distance(look(20, 10), p.forward), 1e-6F);
    EXPECT_LT(glm::distance(look(30, 10), p.right), 1e-6F);
    EXPECT_LT(glm::distance(look(10, 10), -p.right), 1e-6F);
    EXPECT_LT(glm::distance(look(0, 10), -p.forward), 1e-6F);
    EXPECT_LT(glm::distance(look(7, 0), p.up), 1e-6F);
    EXPECT_LT(glm::distance(look(7, 20), -p.up), 1e-6F);
    EXPECT_NEAR(std::acos(glm::dot(look(7, 5), p.up)), kPiOf<float> / 4, 1e-6) << "rows are even in the angle";
}

/// Share of a disk of radius 1 on the near side of a line at signed distance d from its middle.
double shareOfDisk(double d) {
    if (d <= -1) return 0;
    if (d >= 1) return 1;
    return 0.5 + (d * std::sqrt(1 - d * d) + std::asin(d)) / kPiOf<double>;
}

/// Mean over a pixel of `half` metres, seen through a lens of radius 0.5 focused at 2 m, of a half plane that shines
/// for x > 0 at `distance` metres, where the pinhole sees the middle of the pixel at x metres there.
double seenThroughLens(double x, float distance, std::uint32_t projection) {
    SceneBuilder builder;
    builder.quad(builder.material(emitter(glm::vec3(1))), {0, -9, 0}, {18, 0, 0}, {0, 18, 0});
    RenderOptions options = viewAlongZ(1, 1e-4F, 1U << 14U, 0, distance);
    options.params.projection = projection;
    options.params.lensRadius = 0.5F;
    options.params.focusDistance = 2;
    options.params.eye.x = static_cast<float>(x);
    return meanOf(renderReference(builder.build(), options)).r;
}

// The circle of confusion on a plane at z is a disk of radius R |z - focus| / focus.
TEST(ThinLens, AnEdgeOutOfFocusIsBlurredByTheCircleOfConfusion) {
    for (const std::uint32_t projection : {kProjectionPerspective, kProjectionOrthographic})
        for (const float distance : {1.0F, 5.0F})
            for (const double x : {-0.2, 0.0, 0.1, 0.6}) {
                const double radius = 0.5 * std::abs(double{distance} - 2) / 2;
                EXPECT_NEAR(seenThroughLens(x, distance, projection), shareOfDisk(x / radius), 4e-3)
                    << x << ' ' << distance;
            }
    EXPECT_EQ(seenThroughLens(0.01, 2, kProjectionPerspective), 1);
    EXPECT_EQ(seenThroughLens(-0.01, 2, kProjectionPerspective), 0);
}

/// Share of a filter that lies beyond x pixels.
double shareBeyond(std::uint32_t filter, double radius, double x) {
    constexpr int kSteps = 20000;
    double whole = 0, beyond = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double t = 2 * (i + 0.5) / kSteps - 1, value = filterValue(filter, t);
        whole += value;
        if (t * radius > x) beyond += value;
    }
    return beyond / whole;
}

// The response to an edge is the filter's integral: below 0 and above 1 where the filter has lobes below 0.
TEST(PixelFilters, AnEdgeShowsTheIntegralOfTheFilter) {
    constexpr std::uint32_t kSide = 9;
    SceneBuilder builder;
    builder.quad(builder.material(emitter(glm::vec3(1))), {0, -99, 0}, {99, 0, 0}, {0, 198, 0});
    const SceneArrays scene = builder.build();
    for (const FilterInfo& info : kFilters) {
        RenderOptions options = viewAlongZ(kSide, kSide / 2.0F, 4096, 0);  // a metre a pixel
        options.params.height = 1;
        options.params.up.y = 0.5F;
        options.params.eye.x = 0.9F;
        options.params.pixelFilter = info.id;
        options.params.filterRadius = info.radius;
        const Image image = filmToImage(renderReference(scene, options));
        float least = 0;
        for (std::uint32_t x = 0; x < kSide; ++x) {
            const double middle = x - (kSide - 1) / 2.0 + 0.9;
            EXPECT_NEAR(double{image.at(x, 0)[0]}, shareBeyond(info.id, double{info.radius}, -middle), 8e-3)
                << info.name << ' ' << x;
            EXPECT_EQ(image.at(x, 0)[3], middle > 0.5 + double{info.radius} ? 1 : image.at(x, 0)[3]);
            least = std::min(least, image.at(x, 0)[0]);
        }
        EXPECT_EQ(least < -0.005F, info.id == kFilterMitchell) << info.name;
    }
}

// A lens takes two dimensions more: what follows moves on, and without one nothing does.
TEST(ThinLens, BouncesTakeTheDimensionsBehindIt) {
    RenderOptions options = viewAlongZ(1, 1, 1, 1);
    const SceneArrays scene = SceneBuilder().build();
    Transport pinhole(scene, options.params);
    EXPECT_EQ(pinhole.dimension(2, kDimLight), kDimBounce + 2 * kDimBounceStride + kDimLight);
    options.params.lensRadius = 1;
    EXPECT_EQ(pinhole.dimension(2, kDimLight), kDimBounceBehindLens + 2 * kDimBounceStride + kDimLight);
    options.params.projection = kProjectionPanorama;
    EXPECT_FALSE(pinhole.hasLens());
}

}  // namespace
}  // namespace vkpt::reference
