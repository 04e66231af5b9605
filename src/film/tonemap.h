// From scene radiance to what a display shows: exposure, tone mapping, sRGB encoding.
#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <string_view>

#include "base/image.h"

namespace vkpt {

enum class ToneMap : std::uint8_t { Neutral, Aces, Agx, None };

struct ToneMapInfo {
    ToneMap id;
    std::string_view name, help;
};

inline constexpr auto kToneMaps = std::to_array<ToneMapInfo>({
    {ToneMap::Neutral, "neutral", "Khronos PBR Neutral: colours below 0.8 stay true"},
    {ToneMap::Aces, "aces", "ACES filmic, Hill's fit, at the exposure three.js gives it"},
    {ToneMap::Agx, "agx", "AgX, Wrensch's minimal fit, base look"},
    {ToneMap::None, "none", "clip at 1"},
});

/// Non-negative linear Rec. 709 to linear Rec. 709 in [0, 1].
[[nodiscard]] glm::vec3 toneMap(ToneMap map, glm::vec3 color);

/// Piecewise sRGB transfer function [IEC 61966-2-1]; clamps to [0, 1] first.
[[nodiscard]] float srgbEncode(float linear);

/// How a picture for the screen is made.
struct Display {
    ToneMap toneMap = ToneMap::Neutral;
    float exposure = 0;        ///< EV: radiance is multiplied by 2^exposure
    bool transparent = false;  ///< keep alpha, straight; else three channels, as seen over black
};

/// Linear premultiplied RGBA, what is below 0 as 0, to sRGB-encoded values in [0, 1], 3 or 4 channels.
[[nodiscard]] Image displayImage(const Image& linear, const Display& display);

}  // namespace vkpt
