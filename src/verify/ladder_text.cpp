#include "verify/ladder_text.h"

namespace vkpt {
namespace {

std::string rungName(Rung rung) {
    const auto i = static_cast<std::size_t>(rung);
    return fmt::format("{} {}", i + 1, kRungs[i].name);
}

std::string outcome(const CheckResult& row) {
    if (!row.agrees()) return "DISAGREES";
    return row.findings.refusal().empty() ? "agrees" : "refused";
}

/// The worst error as a share of its tolerance; nothing where all was equality.
std::string worstText(double share) { return share > 0 ? fmt::format("{:.1f} %", 100 * share) : "-"; }

}  // namespace

std::string groupedDigits(std::uint64_t value) {
    const std::string digits = fmt::format("{}", value);
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0) text += ' ';
        text += digits[i];
    }
    return text;
}

std::string ladderHeader() {
    return fmt::format("{:<14}{:<16}{:>12}{:>9}{:>10}{:>9}  {}\n", "rung", "check", "compared", "excused", "worst",
                       "time", "result");
}

std::string ladderRow(const CheckResult& row, bool first, bool details) {
    const Findings& f = row.findings;
    std::string text =
        fmt::format("{:<14}{:<16}{:>12}{:>9}{:>10}{:>7.2f} s  {}\n", first ? rungName(row.check->rung) : "",
                    row.check->name, groupedDigits(f.compared()), f.excused() == 0 ? "-" : groupedDigits(f.excused()),
                    worstText(f.worst()), row.seconds, outcome(row));
    for (const Figure& figure : f.figures()) text += fmt::format("{:14}  {}: {}\n", "", figure.name, figure.text);
    if (!f.refusal().empty()) text += fmt::format("{:14}  {}\n", "", f.refusal());
    if (!details) return text;
    for (const Quantity& q : f.quantities())
        text += fmt::format("{:14}  {:<32}{:>11}{:>9}{:>10}\n", "", q.name, groupedDigits(q.compared),
                            q.excused == 0 ? "-" : groupedDigits(q.excused), worstText(q.worst));
    return text;
}

std::string ladderVerdict(const LadderResult& result) {
    if (const CheckResult* failure = result.failure()) {
        const Disagreement& d = *failure->findings.disagreement();
        return fmt::format("disagreement at rung {}, {}: {}\n  {}{}\n", rungName(failure->check->rung),
                           failure->check->name, d.quantity, d.what, d.where.empty() ? "" : "\n  " + d.where);
    }
    std::size_t refused = 0;
    for (const CheckResult& row : result.checks) refused += row.findings.refusal().empty() ? 0 : 1;
    return fmt::format("{} checks agree{}\n", result.checks.size() - refused,
                       refused == 0 ? "" : fmt::format(", {} could not judge", refused));
}

}  // namespace vkpt
