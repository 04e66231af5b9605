#include "verify/findings.h"

#include <algorithm>
#include <limits>

namespace vkpt {

double Findings::shareOfTolerance(double actual, double expected, double absolute, double relative) {
    const double error = std::abs(actual - expected);
    if (error == 0) return 0;
    const double share = error / (absolute + relative * std::abs(expected));
    return std::isnan(share) ? std::numeric_limits<double>::infinity() : share;
}

Quantity& Findings::quantity(std::string_view name) {
    const auto found = std::ranges::find(quantities_, name, &Quantity::name);
    if (found != quantities_.end()) return *found;
    quantities_.push_back({std::string(name)});
    return quantities_.back();
}

bool Findings::count(std::string_view name, double share) {
    Quantity& q = quantity(name);
    ++q.compared;
    const bool inside = share <= 1;
    if (inside)
        q.worst = std::max(q.worst, share);
    else
        ++q.outside;
    return inside;
}

void Findings::excuse(std::string_view name) {
    Quantity& q = quantity(name);
    ++q.compared;
    ++q.excused;
}

void Findings::tally(std::string_view name, std::uint64_t compared, std::uint64_t excused) {
    Quantity& q = quantity(name);
    q.compared += compared;
    q.excused += excused;
}

bool Findings::atLeast(std::string_view what, double actual, double least) {
    if (actual >= least) return true;
    if (!disagreement_) disagree(what, "the whole check", fmt::format("{} where {} are needed", actual, least));
    return false;
}

bool Findings::atMost(std::string_view what, double actual, double most) {
    if (actual <= most) return true;
    if (!disagreement_) disagree(what, "the whole check", fmt::format("{} where {} are allowed", actual, most));
    return false;
}

void Findings::disagree(std::string_view name, std::string where, std::string what) {
    if (!disagreement_) disagreement_ = {std::string(name), std::move(where), std::move(what)};
}

void Findings::add(std::string_view prefix, const Findings& other) {
    for (Quantity q : other.quantities_) {
        q.name = fmt::format("{}: {}", prefix, q.name);
        quantities_.push_back(q);
    }
    figures_.insert(figures_.end(), other.figures_.begin(), other.figures_.end());
    if (const auto& d = other.disagreement_) disagree(fmt::format("{}: {}", prefix, d->quantity), d->where, d->what);
}

std::uint64_t Findings::compared() const {
    std::uint64_t sum = 0;
    for (const Quantity& q : quantities_) sum += q.compared;
    return sum;
}

std::uint64_t Findings::excused() const {
    std::uint64_t sum = 0;
    for (const Quantity& q : quantities_) sum += q.excused;
    return sum;
}

double Findings::worst() const {
    double worst = 0;
    for (const Quantity& q : quantities_) worst = std::max(worst, q.worst);
    return worst;
}

}  // namespace vkpt
