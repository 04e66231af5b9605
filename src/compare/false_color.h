// The colours of heat maps.
#pragma once
#include <algorithm>
#include <array>
#include <glm/glm.hpp>

namespace vkpt {

/// Black through purple and orange to light yellow, even steps to the eye, for t in [0, 1]: every 17th colour of
/// "magma" [Smith 15], straight lines between. Display-encoded.
[[nodiscard]] inline glm::vec3 falseColor(float t) {
    static constexpr std::array<std::array<float, 3>, 16> kMagma{{{0.001F, 0.000F, 0.014F},
                                                                  {0.044F, 0.034F, 0.142F},
                                                                  {0.124F, 0.067F, 0.296F},
                                                                  {0.232F, 0.060F, 0.438F},
                                                                  {0.341F, 0.081F, 0.493F},
                                                                  {0.445F, 0.123F, 0.507F},
                                                                  {0.550F, 0.161F, 0.506F},
                                                                  {0.658F, 0.196F, 0.490F},
                                                                  {0.767F, 0.234F, 0.458F},
                                                                  {0.869F, 0.288F, 0.409F},
                                                                  {0.944F, 0.378F, 0.365F},
                                                                  {0.981F, 0.498F, 0.370F},
                                                                  {0.994F, 0.624F, 0.427F},
                                                                  {0.997F, 0.748F, 0.517F},
                                                                  {0.993F, 0.870F, 0.626F},
                                                                  {0.987F, 0.991F, 0.750F}}};
    const float position = std::clamp(t, 0.0F, 1.0F) * (kMagma.size() - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(position), kMagma.size() - 2);
    const auto color = [](const std::array<float, 3>& c) { return glm::vec3(c[0], c[1], c[2]); };
    return glm::mix(color(kMagma[i]), color(kMagma[i + 1]), position - static_cast<float>(i));
}

}  // namespace vkpt
