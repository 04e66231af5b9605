// Orthonormal frame around a direction.
#pragma once
#include "reference/real.h"

namespace vkpt::reference {

/// Right-handed frame whose z is the unit vector it was made from: the branchless construction of [Duff 17].
template <class Real>
struct Frame {
    Vec3<Real> x, y, z;

    explicit Frame(const Vec3<Real>& n) : z(n) {
        const Real sign = n.z >= 0 ? Real(1) : Real(-1);
        const Real a = -1 / (sign + n.z);
        const Real b = n.x * n.y * a;
        x = {1 + sign * n.x * n.x * a, sign * b, -sign * n.x};
        y = {b, sign + n.y * n.y * a, -n.y};
    }

    /// Frame around n with x along the part of `tangent` across n; any where that has no length.
    Frame(const Vec3<Real>& n, const Vec3<Real>& tangent) : Frame(n) {
        const Vec3<Real> across = tangent - n * glm::dot(tangent, n);
        if (!(glm::dot(across, across) > 0)) return;
        x = glm::normalize(across);
        y = glm::cross(z, x);
    }

    [[nodiscard]] Vec3<Real> toLocal(const Vec3<Real>& v) const {
        return {glm::dot(v, x), glm::dot(v, y), glm::dot(v, z)};
    }
    [[nodiscard]] Vec3<Real> toWorld(const Vec3<Real>& v) const { return x * v.x + y * v.y + z * v.z; }
};

}  // namespace vkpt::reference
