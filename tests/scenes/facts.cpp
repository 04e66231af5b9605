#include "facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace vkpt {
namespace {

using Relation = Demand::Relation;

/// Student's t with 7 degrees of freedom at the level of three standard deviations, 0.27 %.
constexpr double kThreeSigma = 4.53;
/// About a thousand comparisons at 0.27 % in all; their pooled spread is as good as known.
constexpr double kThreeSigmaOfMany = 4.8;
/// Noise may hide no more than this part of what is measured.
constexpr double kMostNoise = 0.04;

struct Pixels {
    std::uint32_t x0, x1, y0, y1;
};

/// A rectangle in fractions of the frame, whose edges lie on pixel boundaries.
Pixels pixelsOf(const Json& rect, const Image& image) {
    const auto edge = [&](int i, std::uint32_t count) {
        return static_cast<std::uint32_t>(std::lround(rect.at(i).get<double>() * count));
    };
    const Pixels p{edge(0, image.width), edge(1, image.width), edge(2, image.height), edge(3, image.height)};
    if (p.x0 >= p.x1 || p.y0 >= p.y1 || p.x1 > image.width || p.y1 > image.height)
        throw std::invalid_argument("rect " + rect.dump() + " holds no pixel");
    return p;
}

double channelMean(const Image& image, Pixels p, int channel) {
    double sum = 0;
    for (std::uint32_t y = p.y0; y < p.y1; ++y)
        for (std::uint32_t x = p.x0; x < p.x1; ++x) sum += double{image.at(x, y)[channel]};
    return sum / ((p.x1 - p.x0) * (p.y1 - p.y0));
}

std::vector<double> colorMean(const Image& image, Pixels p) {
    return {channelMean(image, p, 0), channelMean(image, p, 1), channelMean(image, p, 2)};
}

double luminanceMean(const Image& image, Pixels p) {
    const auto c = colorMean(image, p);
    return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
}

std::vector<double> everyChannel(const Image& image, Pixels p) {
    std::vector<double> values;
    for (std::uint32_t y = p.y0; y < p.y1; ++y)
        for (std::uint32_t x = p.x0; x < p.x1; ++x)
            for (int c = 0; c < 3; ++c) values.push_back(double{image.at(x, y)[c]});
    return values;
}

/// Tile means of the left half less those of the mirrored right half, in parts of their own and the frame's mean.
std::vector<double> mirrorDifferences(const Json& fact, const Image& image) {
    const auto columns = fact.at("tiles").at(0).get<std::uint32_t>(),
               rows = fact.at("tiles").at(1).get<std::uint32_t>();
    const double scale = luminanceMean(image, {0, image.width, 0, image.height});
    const std::uint32_t w = image.width / columns, h = image.height / rows;
    std::vector<double> differences;
    for (std::uint32_t j = 0; j < rows; ++j)
        for (std::uint32_t i = 0; i < columns / 2; ++i) {
            const auto left = colorMean(image, {i * w, (i + 1) * w, j * h, (j + 1) * h});
            const auto right = colorMean(image, {image.width - (i + 1) * w, image.width - i * w, j * h, (j + 1) * h});
            for (int c = 0; c < 3; ++c)
                differences.push_back((left[c] - right[c]) / ((left[c] + right[c]) / 2 + scale));
        }
    return differences;
}

}  // namespace

std::vector<double> numbersOf(const Json& fact, const Image& image) {
    const std::string type = fact.at("type");
    if (type == "mirror_symmetry") return mirrorDifferences(fact, image);
    if (type == "increasing") {
        std::vector<double> steps;
        for (std::size_t i = 1; i < fact.at("rects").size(); ++i)
            steps.push_back(luminanceMean(image, pixelsOf(fact["rects"][i], image)) -
                            luminanceMean(image, pixelsOf(fact["rects"][i - 1], image)));
        return steps;
    }
    const Pixels pixels = pixelsOf(fact.at("rect"), image);
    if (type == "region_mean") return colorMean(image, pixels);
    if (type == "alpha_mean") return {channelMean(image, pixels, 3)};
    if (type == "max_below" || type == "min_above" || type == "region_uniform") return everyChannel(image, pixels);
    throw std::invalid_argument("expect.json: no fact of type '" + type + "'");
}

Demand demandOf(const Json& fact, const Image& image) {
    const std::string type = fact.at("type");
    const std::size_t count = numbersOf(fact, image).size();
    const double tolerance = fact.value("tolerance", 0.0);
    if (type == "region_mean") return {Relation::Equal, fact.at("value").get<std::vector<double>>(), tolerance, false};
    if (type == "increasing") return {Relation::Greater, std::vector<double>(count, 0.0), 0, false};
    if (type == "mirror_symmetry") return {Relation::Equal, std::vector<double>(count, 0.0), tolerance, false};
    if (type == "region_uniform")
        return {Relation::Equal, std::vector<double>(count, numbersOf(fact, image).front()), tolerance, true};
    const std::vector<double> expected(count, fact.at("value").get<double>());
    if (type == "alpha_mean") return {Relation::Equal, expected, tolerance, false};
    return {type == "max_below" ? Relation::AtMost : Relation::AtLeast, expected, 0, true};
}

std::vector<double> spreadOf(const Json& fact, std::span<const Image> replicates) {
    std::vector<double> sum, squares;
    for (const Image& image : replicates) {
        const auto numbers = numbersOf(fact, image);
        sum.resize(numbers.size());
        squares.resize(numbers.size());
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            sum[i] += numbers[i];
            squares[i] += numbers[i] * numbers[i];
        }
    }
    const auto n = static_cast<double>(replicates.size());
    for (std::size_t i = 0; i < sum.size(); ++i)
        sum[i] = std::sqrt(std::max(0.0, squares[i] - sum[i] * sum[i] / n) / (n - 1));
    return sum;
}

testing::AssertionResult holds(const Json& fact, std::span<const Image> images, std::span<const double> spread) {
    const Demand demand = demandOf(fact, images.front());
    const std::size_t count = demand.expected.size();
    std::vector<double> mean(count);
    for (const Image& image : images) {
        const auto numbers = numbersOf(fact, image);
        for (std::size_t i = 0; i < count; ++i) mean[i] += numbers[i] / static_cast<double>(images.size());
    }
    const bool many = count > 100;
    double pooled = 0, largest = 1e-2;
    for (std::size_t i = 0; i < count; ++i) {
        pooled += spread[i] * spread[i] / static_cast<double>(count);
        largest = std::max(largest, std::abs(many ? 1.0 : demand.expected[i]));
    }
    for (std::size_t i = 0; i < count; ++i) {
        const double single =
            many ? kThreeSigmaOfMany * std::max(std::sqrt(pooled), spread[i]) : kThreeSigma * spread[i];
        const double noise = demand.exact ? 0 : single / std::sqrt(static_cast<double>(images.size()));
        const double excess = mean[i] - demand.expected[i];
        const bool good = demand.relation == Relation::Equal     ? std::abs(excess) <= demand.tolerance + noise
                          : demand.relation == Relation::Greater ? excess > noise
                          : demand.relation == Relation::AtMost  ? excess <= 0
                                                                 : excess >= 0;
        if (!good)
            return testing::AssertionFailure() << fmt::format(
                       "number {} is {:.6g}, expected {:.6g} (tolerance {:.2g}, three standard errors {:.2g})", i,
                       mean[i], demand.expected[i], demand.tolerance, noise);
        if (demand.relation == Relation::Equal && noise > std::max(kMostNoise * largest, 4 * demand.tolerance))
            return testing::AssertionFailure()
                   << fmt::format("three standard errors are {:.2g}, too much to tell: raise --spp", noise);
    }
    return testing::AssertionSuccess();
}

}  // namespace vkpt
