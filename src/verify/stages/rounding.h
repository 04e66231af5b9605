// Results of one step on both sides, equal up to what rounding of its input may do.
#pragma once
#include <functional>
#include <string_view>
#include <vector>

#include "reference/path.h"
#include "verify/findings.h"
#include "verify/inputs/random_inputs.h"

namespace vkpt {

/// One number or vector that a step yields, and how far off rounding within the step may bring it.
struct Part {
    std::string_view name;
    glm::dvec3 value;
    double absolute = 0, relative = 0;
};
/// What a step yields; a step that yields less (no light sample, no next ray) has fewer parts.
using Parts = std::vector<Part>;

/// Inputs that differ from a given one by a few ulps: where the reference itself takes other decisions for them, so may
/// the device.
class Jitter {
public:
    explicit Jitter(std::uint32_t seed) : random_(seed) {}
    [[nodiscard]] reference::Ray near(const reference::Ray& ray);
    [[nodiscard]] reference::PathState near(const reference::PathState& state);
    [[nodiscard]] reference::Hit near(const reference::Hit& hit);

private:
    [[nodiscard]] glm::vec3 shake(const glm::vec3& v);
    RandomInputs random_;
};

/// Compares what the device made of an input with what the reference makes of it. `evaluate(nullptr)` is the
/// reference's result; evaluate(jitter) that for an input near by, which is asked for only where the first is not it:
/// the device is excused, under `name`, where its values lie within those of such results that have the same parts.
/// Returns whether it agrees or is excused.
bool compareParts(Findings& findings, std::string_view name, const Parts& device,
                  const std::function<Parts(Jitter*)>& evaluate);

}  // namespace vkpt
