"""Texture lookups as shaders/shared/estimator.md states them, for expectations."""
import math

from .gltf import CLAMP, LINEAR, MIRROR, NEAREST, REPEAT
from .vec import lerp


def linear_from_srgb(c):
    return c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4


def hue(h, saturation=0.6, value=1.0):
    """An sRGB colour of hue h in turns."""
    return tuple(value * (1 - saturation * (1 - max(0.0, min(1.0, abs((h + s) % 1 * 6 - 3) - 1)))) for s in (1, 2 / 3,
                                                                                                             1 / 3))


def transformed(u, v, offset=(0, 0), rotation=0.0, scale=(1, 1)):
    """KHR_texture_transform: translation x rotation x scale."""
    u, v = u * scale[0], v * scale[1]
    c, s = math.cos(rotation), math.sin(rotation)
    return c * u + s * v + offset[0], -s * u + c * v + offset[1]


def _wrapped(i, size, mode):
    if mode == CLAMP:
        return min(max(i, 0), size - 1)
    if mode == MIRROR:
        m = i % (2 * size)
        return m if m < size else 2 * size - 1 - m
    assert mode == REPEAT
    return i % size


def lookup(picture, u, v, wrap=(REPEAT, REPEAT), filtering=LINEAR):
    """Linear RGB of an sRGB picture, decoded before filtering."""
    def texel(i, j):
        rgb = picture.texel(_wrapped(i, picture.width, wrap[0]), _wrapped(j, picture.height, wrap[1]))[:3]
        return tuple(linear_from_srgb(c) for c in rgb)
    if filtering == NEAREST:
        return texel(math.floor(u * picture.width), math.floor(v * picture.height))
    x, y = u * picture.width - 0.5, v * picture.height - 0.5
    i, j = math.floor(x), math.floor(y)
    upper = lerp(texel(i, j), texel(i + 1, j), x - i)
    lower = lerp(texel(i, j + 1), texel(i + 1, j + 1), x - i)
    return lerp(upper, lower, y - j)
