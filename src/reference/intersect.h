// Watertight ray-triangle and conservative ray-box tests. [Woop 13], [Ize 13]
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "reference/hit.h"

namespace vkpt::reference {

/// A ray sheared so that it runs along +z from the origin. [Woop 13, sec. 3]
class ShearedRay {
public:
    explicit ShearedRay(const Ray& ray) : origin_(ray.origin) {
        const glm::vec3 size = glm::abs(ray.direction);
        kz_ = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        kx_ = (kz_ + 1) % 3;
        ky_ = (kz_ + 2) % 3;
        if (ray.direction[kz_] < 0) std::swap(kx_, ky_);
        sx_ = ray.direction[kx_] / ray.direction[kz_];
        sy_ = ray.direction[ky_] / ray.direction[kz_];
        sz_ = 1.0F / ray.direction[kz_];
    }

    struct TriangleHit {
        float t = 0;
        glm::vec3 barycentrics{0};
        bool front = false;  ///< counter-clockwise as the ray sees it
    };

    /// The hit with the plane's t in (0, infinity), edges and corners included: of two triangles that share an edge
    /// at least one is hit. t is in units of the ray's direction.
    [[nodiscard]] std::optional<TriangleHit> intersect(const glm::vec3& v0, const glm::vec3& v1,
                                                       const glm::vec3& v2) const {
        const glm::vec3 a = shear(v0), b = shear(v1), c = shear(v2);
        float u = c.x * b.y - c.y * b.x;
        float v = a.x * c.y - a.y * c.x;
        float w = b.x * a.y - b.y * a.x;
        if (u == 0 || v == 0 || w == 0) {  // on an edge as far as float can tell: decide in double
            u = edge(c, b);
            v = edge(a, c);
            w = edge(b, a);
        }
        if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return std::nullopt;
        const float det = u + v + w;
        if (det == 0) return std::nullopt;
        const float t = (u * (sz_ * a.z) + v * (sz_ * b.z) + w * (sz_ * c.z)) / det;
        if (!(t > 0)) return std::nullopt;
        return TriangleHit{t, glm::vec3(u, v, w) / det, det > 0};
    }

private:
    [[nodiscard]] glm::vec3 shear(const glm::vec3& vertex) const {
        const glm::vec3 p = vertex - origin_;
        return {p[kx_] - sx_ * p[kz_], p[ky_] - sy_ * p[kz_], p[kz_]};
    }
    [[nodiscard]] static float edge(const glm::vec3& p, const glm::vec3& q) {
        return static_cast<float>(double{p.x} * double{q.y} - double{p.y} * double{q.x});
    }

    glm::vec3 origin_;
    int kx_, ky_, kz_;
    float sx_, sy_, sz_;
};

/// A ray prepared for boxes within `reach` of its origin. Boxes are grown by `pad`, which bounds the rounding of the
/// box test and of the sheared triangle test for all that lies within reach, so no hit of the latter is culled.
/// [Woop 13, app. A: 5 ulps of the distances along two axes]; far distances grow as in [Ize 13].
struct BoxRay {
    glm::vec3 origin, inverse;
    float pad;

    BoxRay(const Ray& ray, float reach) : origin(ray.origin), pad(reach * 0x1p-20F) {
        // A zero component becomes tiny: 0 x inf would be NaN, and the padded slab decides as it should.
        for (int i = 0; i < 3; ++i) {
            const float d = ray.direction[i];
            inverse[i] = 1.0F / (std::abs(d) > 1e-30F ? d : std::copysign(1e-30F, d));
        }
    }
};

/// Distances below which Ize's factor, 1 + 2 gamma(3), keeps a box from being missed by rounding.
inline constexpr float kRobustFar = 1.0F + 2.0F * 3.0F * 0x1p-24F / (1.0F - 3.0F * 0x1p-24F);

}  // namespace vkpt::reference
