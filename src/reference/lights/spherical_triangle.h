// Emissive triangles as a point sees them: spherical triangles, by the sides and the angle that meet at the first
// corner. Half-angle tangents throughout: they keep their digits where a triangle is small, and where two corners are
// nearly opposite, as from beside an edge.
#pragma once
#include <algorithm>
#include <cmath>

#include "reference/angle.h"

namespace vkpt::reference {

/// tan(t/2) of an angle by its sine and cosine, both times the same length; infinite where it is half a turn.
template <class Real>
[[nodiscard]] Real tangentOfHalf(Real sine, Real cosine) {
    const Real length = std::hypot(sine, cosine);
    return cosine < 0 ? (length - cosine) / sine : sine / (length + cosine);
}

template <class Real>
class SphericalTriangle {
public:
    /// Of the corners a, b, c, as seen from a point; metres.
    SphericalTriangle(const Vec3<Real>& from, const Vec3<Real>& a, const Vec3<Real>& b, const Vec3<Real>& c)
        : a_(a - from), b_(b - from), c_(c - from) {
        // Sides as they are, not differences of directions, which have few digits where the triangle is far away.
        const Vec3<Real> ab = b - a, ac = c - a, n = glm::cross(ab, ac), toB = glm::cross(a_, ab),
                         toC = glm::cross(a_, ac);
        const Real volume = glm::dot(a_, n), y = glm::length(a_) * std::abs(volume), x = glm::dot(toB, toC);
        if (!(y > 0)) return;
        const Real length = std::hypot(x, y);
        height_ = -volume / glm::length(n);
        cosA_ = x / length;
        sinA_ = y / length;
        tanAB_ = tangentOfHalf(glm::length(toB), glm::dot(a_, b_));
        const Real product = tanAB_ * tangentOfHalf(glm::length(toC), glm::dot(a_, c_));
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
        const Real whole = tangentOfHalf(glm::length(glm::cross(b_, x)), glm::dot(b_, x)),
                   sine2 = u.y / (1 + 1 / (whole * whole));
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
