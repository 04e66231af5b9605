// The colours of FLIP: opponent space for its filters, Hunt-adjusted CIELAB for its distance. [Andersson 20, sec. 4.1]
#pragma once
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

namespace vkpt {

/// Linear sRGB to CIE XYZ relative to the white (1, 1, 1): primaries of sRGB, white D65 at x = 0.31271, y = 0.32902,
/// the columns divided by the white's XYZ.
inline const glm::mat3 kWhiteXyzFromRgb{0.43389539F, 0.21263682F, 0.01775242F, 0.37624237F, 0.71518298F,
                                        0.10946563F, 0.18986224F, 0.07218020F, 0.87278195F};
inline const glm::mat3 kRgbFromWhiteXyz = glm::inverse(kWhiteXyzFromRgb);

/// Linear sRGB to Y, Cx, Cz: linear in light, luminance and two opponent channels.
[[nodiscard]] inline glm::vec3 opponentFromRgb(const glm::vec3& rgb) {
    const glm::vec3 xyz = kWhiteXyzFromRgb * rgb;
    return {116 * xyz.y - 16, 500 * (xyz.x - xyz.y), 200 * (xyz.y - xyz.z)};
}

[[nodiscard]] inline glm::vec3 rgbFromOpponent(const glm::vec3& yCxCz) {
    const float y = (yCxCz.x + 16) / 116;
    return kRgbFromWhiteXyz * glm::vec3(y + yCxCz.y / 500, y, y - yCxCz.z / 200);
}

/// Of a positive number, within 3e-7: a guess that divides the exponent by three, then Halley's iteration twice. Five
/// times as fast as std::cbrt, which took half the time of FLIP.
[[nodiscard]] inline float cubeRoot(float x) {
    float root = std::bit_cast<float>(std::bit_cast<std::uint32_t>(x) / 3 + 0x2a5119f2U);
    for (int i = 0; i < 2; ++i) {
        const float cube = root * root * root;
        root *= (cube + 2 * x) / (2 * cube + x);
    }
    return root;
}

/// CIELAB's lightness curve f, with its linear start.
[[nodiscard]] inline float labCurve(float t) {
    constexpr float delta = 6.0F / 29;
    return t > delta * delta * delta ? cubeRoot(t) : t / (3 * delta * delta) + 4.0F / 29;
}

/// Linear sRGB to CIELAB with chroma scaled by L*/100, as it fades in the dark.
[[nodiscard]] inline glm::vec3 huntLabFromRgb(const glm::vec3& rgb) {
    const glm::vec3 xyz = kWhiteXyzFromRgb * rgb;
    const float x = labCurve(xyz.x), y = labCurve(xyz.y), z = labCurve(xyz.z);
    const float lightness = 116 * y - 16, hunt = 0.01F * lightness;
    return {lightness, hunt * 500 * (x - y), hunt * 200 * (y - z)};
}

/// HyAB: city block in lightness, Euclidean in chroma.
[[nodiscard]] inline float hyab(const glm::vec3& a, const glm::vec3& b) {
    const glm::vec3 d = a - b;
    return std::abs(d.x) + std::sqrt(d.y * d.y + d.z * d.z);
}

/// A HyAB distance to [0, 1]: its power of 0.7, redistributed so that the lower 40 % of the range (it ends at the
/// distance of green from blue) fill 95 % of it.
[[nodiscard]] inline float flipFromHyab(float distance) {
    constexpr float exponent = 0.7F, lowerShare = 0.4F, lowerTarget = 0.95F;
    static const float largest =
        std::pow(hyab(huntLabFromRgb(glm::vec3(0, 1, 0)), huntLabFromRgb(glm::vec3(0, 0, 1))), exponent);
    const float raised = std::pow(distance, exponent), knee = lowerShare * largest;
    if (raised < knee) return raised * (lowerTarget / knee);
    return lowerTarget + (raised - knee) / (largest - knee) * (1 - lowerTarget);
}

}  // namespace vkpt
