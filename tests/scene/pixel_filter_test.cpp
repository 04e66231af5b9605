// Tables of pixel filters against the filters themselves.
#include "scene/pixel_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/render_options.h"

namespace vkpt {
namespace {

std::vector<FilterCell> tableOf(std::uint32_t filter, float radius) {
    RenderParams params = defaultParams();
    params.pixelFilter = filter;
    params.filterRadius = radius;
    return filterTable(params);
}

/// Mean of weight x position^k of what is drawn from the table.
double momentOf(const std::vector<FilterCell>& cells, int k) {
    double sum = 0;
    for (const FilterCell& c : cells) {  // the mean of x^k over [begin, end], exactly
        const double begin = double{c.begin}, end = double{c.end};
        const double mean = (std::pow(end, k + 1) - std::pow(begin, k + 1)) / ((k + 1) * (end - begin));
        sum += double{c.weight} * mean;
    }
    return sum / static_cast<double>(cells.size());
}

/// Second moment of the filter over its radius, in closed form.
double secondMoment(std::uint32_t filter) {
    constexpr double pi = std::numbers::pi;
    switch (filter) {
        case kFilterTent:
            return 1.0 / 6;
        case kFilterGaussian: {  // sigma 1/3, less its value at 1
            const double s = 1.0 / 3, end = std::exp(-1 / (2 * s * s));
            const double area = s * std::sqrt(2 * pi) * std::erf(1 / (s * std::numbers::sqrt2));
            return (s * s * (area - 2 * end) - 2 * end / 3) / (area - 2 * end);
        }
        case kFilterBlackmanHarris:  // a0 + a1 cos(pi x) + a2 cos(2 pi x) + a3 cos(3 pi x)
            return 1.0 / 3 + 2 / (pi * pi) * (-0.48829 + 0.14128 / 4 - 0.01168 / 9) / 0.35875;
        case kFilterMitchell:  // B/3 pixels^2 over a radius of 2 pixels
            return 1.0 / 9 / 4;
        default:
            return 1.0 / 3;
    }
}

TEST(PixelFilter, MomentsAreThoseOfTheFilter) {
    for (const FilterInfo& info : kFilters)
        for (const float radius : {info.radius, 3.0F}) {
            SCOPED_TRACE(info.name);
            const auto cells = tableOf(info.id, radius);
            if (info.id == kFilterBox && radius == 0.5F) {
                EXPECT_TRUE(cells.empty()) << "the box of one pixel needs no table";
                continue;
            }
            ASSERT_EQ(cells.size(), kFilterSteps);
            const double r2 = double{radius} * double{radius};
            EXPECT_NEAR(momentOf(cells, 0), 1, 1e-6);
            EXPECT_NEAR(momentOf(cells, 1), 0, 1e-6 * double{radius});
            EXPECT_NEAR(momentOf(cells, 2), secondMoment(info.id) * r2, 2e-4 * secondMoment(info.id) * r2);
            EXPECT_NEAR(momentOf(cells, 3), 0, 1e-6 * r2 * double{radius});
        }
}

/// Weight of what is drawn below x, of the whole.
double drawnBelow(const std::vector<FilterCell>& cells, double x) {
    double sum = 0;
    for (const FilterCell& c : cells) {
        const double begin = double{c.begin}, end = double{c.end};
        sum += double{c.weight} * std::clamp((x - begin) / (end - begin), 0.0, 1.0);
    }
    return sum / static_cast<double>(cells.size());
}

TEST(PixelFilter, DrawsFollowTheFilterFromEndToEnd) {
    for (const FilterInfo& info : kFilters) {
        SCOPED_TRACE(info.name);
        const auto cells = tableOf(info.id, 2);
        constexpr int kSteps = 20000;
        const auto at = [&](int i) { return 2 * (i + 0.5) / kSteps - 1; };
        double whole = 0, below = 0;
        for (int i = 0; i < kSteps; ++i) whole += filterValue(info.id, at(i));
        for (int i = 0; i < kSteps; ++i) {
            below += filterValue(info.id, at(i));
            if (i % 100 != 99) continue;
            EXPECT_NEAR(drawnBelow(cells, 2 * at(i)), below / whole, 1e-3) << at(i);
        }
        for (const FilterCell& c : cells) {
            EXPECT_LT(c.begin, c.end);
            EXPECT_GE(c.begin, -2.0001F);
            EXPECT_LE(c.end, 2.0001F);
        }
    }
}

TEST(PixelFilter, OnlyMitchellsHasLobesBelowZero) {
    for (const FilterInfo& info : kFilters) {
        bool below = false;
        for (const FilterCell& cell : tableOf(info.id, 2)) below |= cell.weight < 0;
        EXPECT_EQ(below, info.id == kFilterMitchell) << info.name;
    }
}

TEST(PixelFilter, MitchellSumsToOneOverAnyGridOfPixels) {
    for (const double offset : {0.0, 0.3, 0.5, 0.9}) {
        double sum = 0;
        for (int pixel = -3; pixel <= 3; ++pixel) sum += filterValue(kFilterMitchell, (pixel + offset) / 2);
        EXPECT_NEAR(sum, 1, 1e-12) << offset;
    }
}

}  // namespace
}  // namespace vkpt
