#include "verify/stages/rounding.h"

#include <algorithm>

namespace vkpt {
namespace {

constexpr float kRounding = 2e-6F;  ///< relative: some 20 ulps
constexpr int kAttempts = 32;

bool sameParts(const Parts& a, const Parts& b) { return std::ranges::equal(a, b, {}, &Part::name, &Part::name); }

bool isInside(const Part& device, const Part& expected) {
    for (int i = 0; i < 3; ++i)
        if (!(Findings::shareOfTolerance(device.value[i], expected.value[i], expected.absolute, expected.relative) <=
              1))
            return false;
    return true;
}

bool agrees(const Parts& device, const Parts& expected) {
    return sameParts(device, expected) && std::ranges::equal(device, expected, isInside);
}

/// Least and greatest values of results with the same parts.
class Range {
public:
    void add(const Parts& parts) {
        if (low_.empty()) {
            low_ = high_ = parts;
            return;
        }
        for (std::size_t i = 0; i < parts.size(); ++i) {
            low_[i].value = glm::min(low_[i].value, parts[i].value);
            high_[i].value = glm::max(high_[i].value, parts[i].value);
        }
    }
    /// Tolerances come on top.
    [[nodiscard]] bool holds(const Parts& device) const {
        if (low_.empty()) return false;
        for (std::size_t i = 0; i < device.size(); ++i) {
            Part nearest = low_[i];
            nearest.value = glm::clamp(device[i].value, low_[i].value, high_[i].value);
            if (!isInside(device[i], nearest)) return false;
        }
        return true;
    }
    [[nodiscard]] bool isEmpty() const { return low_.empty(); }

private:
    Parts low_, high_;
};

bool isExcused(const Parts& device, const std::function<Parts(Jitter*)>& evaluate) {
    Jitter jitter(1);
    bool any = false;
    Range range;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        const Parts parts = evaluate(&jitter);
        if (!sameParts(parts, device)) continue;
        any = true;
        if (!device.empty()) range.add(parts);
    }
    return any && (device.empty() || range.holds(device));
}

std::string namesOf(const Parts& parts) {
    std::string names;
    for (const Part& part : parts) names += fmt::format("{}{}", names.empty() ? "" : ", ", part.name);
    return names.empty() ? "nothing" : names;
}

}  // namespace

glm::vec3 Jitter::shake(const glm::vec3& v) {
    const float size = kRounding * std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    return v + random_.inBox(glm::vec3(-size), glm::vec3(size));
}

reference::Ray Jitter::near(const reference::Ray& ray) { return {shake(ray.origin), shake(ray.direction)}; }

reference::PathState Jitter::near(const reference::PathState& state) {
    reference::PathState moved = state;
    moved.ray = near(state.ray);
    return moved;
}

reference::Hit Jitter::near(const reference::Hit& hit) {
    reference::Hit moved = hit;
    const float b1 = random_.between(-kRounding, kRounding), b2 = random_.between(-kRounding, kRounding);
    moved.t *= 1 + random_.between(-kRounding, kRounding);
    moved.barycentrics += glm::vec3(-b1 - b2, b1, b2);
    return moved;
}

bool compareParts(Findings& findings, std::string_view name, const Parts& device,
                  const std::function<Parts(Jitter*)>& evaluate) {
    const Parts expected = evaluate(nullptr);
    if (!agrees(device, expected) && isExcused(device, evaluate)) {
        findings.excuse(name);
        return true;
    }
    if (!sameParts(device, expected))
        return findings.holds(name, false, namesOf(device) + " instead of " + namesOf(expected));
    bool all = findings.holds(name, true);
    for (std::size_t i = 0; i < device.size(); ++i)
        all &= findings.near(device[i].name, device[i].value, expected[i].value, expected[i].absolute,
                             expected[i].relative);
    return all;
}

}  // namespace vkpt
