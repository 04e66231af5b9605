// Climbs the table of checks, rung by rung, up to the first that disagrees.
#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "base/json.h"
#include "verify/check.h"

namespace vkpt {

struct CheckResult {
    const Check* check = nullptr;
    Findings findings;
    double seconds = 0;

    [[nodiscard]] bool agrees() const { return !findings.disagreement(); }
};

struct LadderResult {
    std::vector<CheckResult> checks;

    /// The first check that disagrees, with which the climb ended; null where all agree.
    [[nodiscard]] const CheckResult* failure() const;
};

/// `before` and `after` are told of every check that runs.
struct LadderObserver {
    std::function<void(const Check&)> before{};
    std::function<void(const CheckResult&)> after{};
};

[[nodiscard]] LadderResult climb(VerifyContext& context, const LadderObserver& observer = {});

/// Every check with its figures, quantities and, where it disagrees, what and where.
[[nodiscard]] Json ladderJson(const LadderResult& result);

}  // namespace vkpt
