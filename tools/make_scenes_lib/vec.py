"""Vectors as tuples, quaternions as (x, y, z, w): glTF's order."""
import math


def add(a, b):
    return tuple(x + y for x, y in zip(a, b))


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def scale(a, s):
    return tuple(x * s for x in a)


def mul(a, b):
    return tuple(x * y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def length(a):
    return math.sqrt(dot(a, a))


def normalize(a):
    return scale(a, 1 / length(a))


def lerp(a, b, t):
    if isinstance(a, tuple):
        return tuple(x + (y - x) * t for x, y in zip(a, b))
    return a + (b - a) * t


def axis_angle(axis, degrees):
    half = math.radians(degrees) / 2
    x, y, z = scale(normalize(axis), math.sin(half))
    return (x, y, z, math.cos(half))


def quaternion_product(a, b):
    """Rotates by b, then by a."""
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return (aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw, aw * bw - ax * bx - ay * by - az * bz)


def rotate(q, v):
    u = q[:3]
    t = scale(cross(u, v), 2)
    return add(add(v, scale(t, q[3])), cross(u, t))


def quaternion_from_axes(x, y, z):
    """The rotation whose columns are the orthonormal, right-handed axes x, y, z. [Shepperd 78]"""
    trace = x[0] + y[1] + z[2]
    squares = (1 + 2 * x[0] - trace, 1 + 2 * y[1] - trace, 1 + 2 * z[2] - trace, 1 + trace)
    k = max(range(4), key=lambda i: squares[i])
    d = 2 * math.sqrt(squares[k])
    rows = ((d / 4, (y[0] + x[1]) / d, (x[2] + z[0]) / d, (y[2] - z[1]) / d),
            ((y[0] + x[1]) / d, d / 4, (z[1] + y[2]) / d, (z[0] - x[2]) / d),
            ((x[2] + z[0]) / d, (z[1] + y[2]) / d, d / 4, (x[1] - y[0]) / d),
            ((y[2] - z[1]) / d, (z[0] - x[2]) / d, (x[1] - y[0]) / d, d / 4))
    return rows[k]


def look_at(eye, target, up=(0, 1, 0)):
    """The rotation that turns -Z towards the target: what cameras and lights need."""
    back = normalize(sub(eye, target))
    if abs(dot(back, normalize(up))) > 0.9999:
        up = (0, 0, -1)
    right = normalize(cross(up, back))
    return quaternion_from_axes(right, cross(back, right), back)
