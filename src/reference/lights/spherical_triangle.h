// Emissive triangles as a point sees them: spherical triangles, by the sides and the angle that meet at the first
// corner. Half-angle tangents throughout, so that neither small triangles nor hemispheres lose digits.
#pragma once
#include <algorithm>

#include "reference/angle.h"

namespace vkpt::reference {

/// tan(t/2) of the angle t between two vectors of any length; finite where they are opposite, too.
template <class Real>
[[nodiscard]] Real tangentOfHalf(const Vec3<Real>& u, const Vec3<Real>& v) {
    const Real lengths = glm::length(u) * glm::length(v);
    return glm::length(glm::cross(u, v)) / std::max(lengths + glm::dot(u, v), Real(1e-14) * lengths);
}

template <class Real>
class SphericalTriangle {
public:
    /// Corners relative to the point, metres.
    SphericalTriangle(const Vec3<Real>& a, const Vec3<Real>& b, const Vec3<Real>& c) : a_(a), b_(b), c_(c) {
        const Vec3<Real> n = glm::cross(b - a, c - a);
        const Real volume = glm::dot(a, n), y = glm::length(a) * std::abs(volume),
                   x = glm::dot(glm::cross(a, b), glm::cross(a, c));
        if (!(y > 0)) return;
        const Real length = std::hypot(x, y);
        height_ = -volume / glm::length(n);
        cosA_ = x / length;
        sinA_ = y / length;
        tanAB_ = tangentOfHalf(a, b);
        const Real product = tanAB_ * tangentOfHalf(a, c);
        solidAngle_ = 2 * arcTangent2(product * sinA_, 1 + product * cosA_);
    }

    /// Steradians, from 0 to 2 pi; 0 where the triangle is seen edge-on. tan(E/2) = tan(b/2) tan(c/2) sin A /
    /// (1 + tan(b/2) tan(c/2) cos A) [Todhunter 86].
    [[nodiscard]] Real solidAngle() const { return solidAngle_; }
    /// Metres from its plane to the point, above 0 where its corners run counter-clockwise.
    [[nodiscard]] Real height() const { return height_; }

    /// Barycentrics (b0, b1, b2) of the point that u has, uniform in solid angle. [Arvo 95]
    [[nodiscard]] Vec3<Real> point(const Vec2<Real>& u) const {
        // The side from a to x for which (a, b, x) has the share u.x of the solid angle: the formula above, solved.
        const Vec2<Real> half = cosSinTurns(u.x * solidAngle_ / (4 * kPiOf<Real>));
        const Real tanAX = half.y / (tanAB_ * (sinA_ * half.x - cosA_ * half.y));
        const Vec2<Real> onAC = onArc(a_, c_, tanAX);
        const Vec3<Real> x = onAC.x * a_ + onAC.y * c_;
        // 1 - cos t = 2 sin^2(t/2) is u.y of that of the side from b to x.
        const Real whole = tangentOfHalf(b_, x), sine2 = u.y * whole * whole / (1 + whole * whole);
        const Vec2<Real> onBX = onArc(b_, x, std::sqrt(sine2 / (1 - sine2)));
        const Vec3<Real> weights = glm::max(Vec3<Real>(onBX.y * onAC.x, onBX.x, onBX.y * onAC.y), Vec3<Real>(0));
        return weights / (weights.x + weights.y + weights.z);
    }

private:
    /// How much of u and of v makes the unit direction t away from u towards v, by tan(t/2).
    static Vec2<Real> onArc(const Vec3<Real>& u, const Vec3<Real>& v, Real tangent) {
        const Vec3<Real> normal = glm::cross(u, v);
        const Real cosine = (1 - tangent * tangent) / (1 + tangent * tangent),
                   sine = 2 * tangent / (1 + tangent * tangent);
        const Real lengthU = glm::length(u), area = glm::length(normal);
        if (!(area > 0)) return {1 / lengthU, 0};  // a triangle seen edge-on: the arc has no length
        const Real part = sine / area;
        return {cosine / lengthU - part * glm::dot(u, v) / lengthU, part * lengthU};
    }

    Vec3<Real> a_, b_, c_;
    Real height_ = 0, cosA_ = 1, sinA_ = 0, tanAB_ = 0, solidAngle_ = 0;
};

}  // namespace vkpt::reference
