// From scene light to the display on which FLIP compares. [Andersson 21, sec. 3.1]
#pragma once
#include <cmath>
#include <glm/glm.hpp>

namespace vkpt {

/// Narkowicz's fit of the ACES curve with its exposure of 0.6 taken back: (k0 x^2 + k1 x) / (k3 x^2 + k4 x + k5).
inline constexpr float kAces0 = 0.36F * 2.51F, kAces1 = 0.6F * 0.03F, kAces3 = 0.36F * 2.43F, kAces4 = 0.6F * 0.59F,
                       kAces5 = 0.14F;

/// The smallest positive value that the curve maps to t < 1.
[[nodiscard]] inline double acesInverse(double t) {
    const double a = kAces0 - t * kAces3, b = kAces1 - t * kAces4, c = -t * kAces5;
    return (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a);
}

/// How linear light becomes the linear colour shown: as it is, or multiplied by `scale` and tone mapped.
struct FlipDisplay {
    bool toneMapped = false;
    float scale = 1;

    /// For a float or a vec3 of values that are not negative; the result lies in [0, 1].
    template <class T>
    [[nodiscard]] T operator()(const T& light) const {
        if (!toneMapped) return light;
        const T x = light * scale;
        return glm::clamp(x * (kAces0 * x + kAces1) / (x * (kAces3 * x + kAces4) + kAces5), T(0), T(1));
    }
};

}  // namespace vkpt
