// Vectors over a chosen precision: function files compile as float (what is rendered) and as double (their truth).
#pragma once
#include <cmath>
#include <glm/glm.hpp>

namespace vkpt::reference {

template <class Real>
using Vec2 = glm::vec<2, Real, glm::defaultp>;
template <class Real>
using Vec3 = glm::vec<3, Real, glm::defaultp>;

template <class Real>
inline constexpr Real kPiOf = Real(3.14159265358979323846264338327950288L);

/// Luminance of linear Rec. 709.
template <class Real>
[[nodiscard]] Real luminance(const Vec3<Real>& color) {
    return glm::dot(color, Vec3<Real>(Real(0.2126), Real(0.7152), Real(0.0722)));
}

template <class Real>
[[nodiscard]] bool isBlack(const Vec3<Real>& color) {
    return color.x == 0 && color.y == 0 && color.z == 0;
}

}  // namespace vkpt::reference
