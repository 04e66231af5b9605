"""glTF 2.0, appendix B, as shaders/shared/estimator.md states it. Local frame, normal +z; f excludes the cosine.

A third, scalar implementation: the expectations of scenes/*/expect.json come from here, not from vkpt.
"""
import math

from .vec import add, dot, lerp, normalize, scale, sub

DELTA_ALPHA = 1e-4


def schlick(f0, c):
    return f0 + (1 - f0) * (1 - c) ** 5


def smith_lambda(alpha, z):
    return (math.sqrt(1 + alpha * alpha * (1 / (z * z) - 1)) - 1) / 2


def evaluate(material, wo, wi):
    """f as an RGB tuple. `material` is (base, metallic, roughness)."""
    base, metallic, roughness = material
    if wo[2] <= 0 or wi[2] <= 0:
        return (0.0, 0.0, 0.0)
    alpha = roughness ** 2
    wm = normalize(add(wo, wi))
    c = abs(dot(wo, wm))
    fd = schlick(0.04, c)
    lobe = 0.0
    if alpha >= DELTA_ALPHA:
        d = alpha ** 2 / (math.pi * (wm[2] ** 2 * (alpha ** 2 - 1) + 1) ** 2)
        g = 1 / (1 + smith_lambda(alpha, wo[2]) + smith_lambda(alpha, wi[2]))
        lobe = d * g / (4 * wo[2] * wi[2])
    return tuple((1 - metallic) * (1 - fd) * b / math.pi + lobe * lerp(fd, schlick(b, c), metallic) for b in base)


def visible_normal(wo, alpha, u0, u1):
    """A microfacet normal by spherical caps. [Dupuy 23]"""
    std = normalize((wo[0] * alpha, wo[1] * alpha, wo[2]))
    phi, z = 2 * math.pi * u0, (1 - u1) * (1 + std[2]) - std[2]
    r = math.sqrt(max(0.0, 1 - z * z))
    h = add((r * math.cos(phi), r * math.sin(phi), z), std)
    return normalize((h[0] * alpha, h[1] * alpha, h[2]))


def albedo(material, mu, steps=40):
    """Directional albedo: what a uniform environment of 1 returns towards cos(theta) = mu. Midpoint rule."""
    base, metallic, roughness = material
    alpha = roughness ** 2
    wo = (math.sqrt(1 - mu * mu), 0.0, mu)
    total = (0.0, 0.0, 0.0)
    for i in range(steps):
        for j in range(steps):
            u0, u1 = (i + 0.5) / steps, (j + 0.5) / steps
            total = add(total, _specular_weight(material, alpha, wo, u0, u1))
            if metallic < 1:
                r, phi = math.sqrt(u1), 2 * math.pi * u0
                wi = (r * math.cos(phi), r * math.sin(phi), math.sqrt(1 - u1))
                fd = schlick(0.04, abs(dot(wo, normalize(add(wo, wi)))))
                total = add(total, tuple((1 - metallic) * (1 - fd) * b for b in base))
    return scale(total, 1 / steps ** 2)


def _specular_weight(material, alpha, wo, u0, u1):
    base, metallic, _ = material
    delta = alpha < DELTA_ALPHA
    wm = (0.0, 0.0, 1.0) if delta else visible_normal(wo, alpha, u0, u1)
    c = dot(wo, wm)
    wi = sub(scale(wm, 2 * c), wo)
    if wi[2] <= 0:
        return (0.0, 0.0, 0.0)
    shadow = 1.0
    if not delta:
        lo, li = smith_lambda(alpha, wo[2]), smith_lambda(alpha, wi[2])
        shadow = (1 + lo) / (1 + lo + li)
    fd = schlick(0.04, c)
    return tuple(shadow * lerp(fd, schlick(b, c), metallic) for b in base)
