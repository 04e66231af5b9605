// Facts of expect.json, judged on replicates: renders of one scene that differ in their seeds alone.
#pragma once
#include <gtest/gtest.h>

#include <span>
#include <string>
#include <vector>

#include "base/image.h"
#include "base/json.h"

namespace vkpt {

/// What a fact demands of some numbers taken from an image.
struct Demand {
    enum class Relation { Equal, Greater, AtMost, AtLeast } relation = Relation::Equal;
    std::vector<double> expected;
    double tolerance = 0;  ///< error of `expected` itself; noise comes on top
    bool exact = false;    ///< noise is no excuse
};

/// The fact's demand, and the numbers it is about: as many as `expected` holds, the same for every image.
/// Throws std::invalid_argument for a fact of unknown type.
[[nodiscard]] Demand demandOf(const Json& fact, const Image& image);
[[nodiscard]] std::vector<double> numbersOf(const Json& fact, const Image& image);

/// Spread of each number over the replicates: standard deviation of one render.
[[nodiscard]] std::vector<double> spreadOf(const Json& fact, std::span<const Image> replicates);

/// Judges the mean of `images`, whose noise is `spread` for each single one. A deviation beyond tolerance and three
/// standard errors fails; so does noise so high that the fact could hardly fail.
[[nodiscard]] testing::AssertionResult holds(const Json& fact, std::span<const Image> images,
                                             std::span<const double> spread);

}  // namespace vkpt
