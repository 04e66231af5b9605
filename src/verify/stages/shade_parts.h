// What a path does at a vertex, part by part, with the tolerance of each.
#pragma once
#include <optional>

#include "reference/path.h"
#include "verify/stages/rounding.h"

namespace vkpt {

/// As the device's shade kernel left it.
struct DeviceVertex {
    glm::dvec3 emitted{0};  ///< added to the path's sums
    std::optional<reference::DirectLight> direct;
    std::optional<reference::PathState> next;
};

[[nodiscard]] Parts partsOf(const DeviceVertex& vertex);
[[nodiscard]] Parts partsOf(const reference::PathVertex& vertex);

/// Something added to the film.
[[nodiscard]] Part contributionPart(std::string_view name, const glm::vec3& contribution);

}  // namespace vkpt
