// What vkpt diff prints.
#pragma once
#include <string>

#include "base/json.h"
#include "compare/metrics.h"
#include "compare/perceptual.h"
#include "compare/verdict.h"

namespace vkpt {

struct Comparison {
    ImageDifference difference;
    PerceptualDifference perceptual;
    Verdict verdict;
};

/// A table, what is worth knowing beside it, and the verdict as the last line.
[[nodiscard]] std::string diffText(const Comparison& comparison, const Threshold& warn, const Threshold& fail);

/// Figures that are infinite or not defined are null.
[[nodiscard]] Json diffJson(const Comparison& comparison, const Threshold& warn, const Threshold& fail);

}  // namespace vkpt
