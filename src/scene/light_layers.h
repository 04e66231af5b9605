// Layers that sort the picture's light: by the length of its paths, and by the group of lights that it comes from.
// estimator.md, Layers of light.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace vkpt {

inline constexpr std::uint32_t kMostLengthLayers = 16;  ///< the last of so many takes all longer paths
inline constexpr std::uint32_t kMostLightGroups = 64;

/// Which of them a film gathers.
struct LightLayers {
    std::uint32_t lengths = 0;        ///< layers by length, at most kMostLengthLayers: layer i has i scatterings
    std::vector<std::string> groups;  ///< names, at most kMostLightGroups

    [[nodiscard]] bool empty() const { return lengths == 0 && groups.empty(); }
    friend bool operator==(const LightLayers&, const LightLayers&) = default;
};

/// Layers by length that paths of at most `depth` scatterings fill.
[[nodiscard]] std::uint32_t lengthLayers(std::uint32_t depth);

/// "emission", "direct", "bounce1", ... of layers by length; the last that there can be says that it takes the rest.
[[nodiscard]] std::string lengthLayerName(std::uint32_t layer);

/// Group names as EXR files may hold them: "light_" and letters, digits, '-' and '_'; a number behind those that would
/// be the same.
[[nodiscard]] std::vector<std::string> groupLayerNames(const std::vector<std::string>& groups);

}  // namespace vkpt
