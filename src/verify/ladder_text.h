// The ladder as a table for people.
#pragma once
#include <string>

#include "verify/ladder.h"

namespace vkpt {

/// Digits in groups of three.
[[nodiscard]] std::string groupedDigits(std::uint64_t value);

[[nodiscard]] std::string ladderHeader();
/// One line; with `details` one more for each quantity it compared. The rung is named where `first` of its rung.
[[nodiscard]] std::string ladderRow(const CheckResult& row, bool first, bool details);
/// What came of it all: that everything agrees, or what the first disagreement is and where.
[[nodiscard]] std::string ladderVerdict(const LadderResult& result);

}  // namespace vkpt
