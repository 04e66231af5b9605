"""Triangle meshes with smooth normals. Counter-clockwise fronts; texture V runs down the surface's own v."""
import math
from dataclasses import dataclass, field, replace

from .vec import add, cross, dot, normalize, rotate, scale, sub


@dataclass
class Shape:
    positions: list = field(default_factory=list)
    normals: list = field(default_factory=list)
    uv0: list = field(default_factory=list)
    triangles: list = field(default_factory=list)
    tangents: list = field(default_factory=list)
    uv1: list = field(default_factory=list)
    colors: list = field(default_factory=list)

    def with_uv(self, change, which="uv0"):
        return replace(self, **{which: [change(u, v) for u, v in self.uv0]})

    def with_colors(self, color):
        return replace(self, colors=[color(p, n) for p, n in zip(self.positions, self.normals)])

    def moved(self, offset, turn=(0, 0, 0, 1)):
        return replace(self, positions=[add(rotate(turn, p), offset) for p in self.positions],
                       normals=[rotate(turn, n) for n in self.normals])

    def reversed(self):
        return replace(self, normals=[scale(n, -1.0) for n in self.normals],
                       triangles=[(a, c, b) for a, b, c in self.triangles])


def merged(*shapes):
    out = Shape()
    for shape in shapes:
        base = len(out.positions)
        for name in ("positions", "normals", "uv0", "tangents", "uv1", "colors"):
            getattr(out, name).extend(getattr(shape, name))
        out.triangles.extend(tuple(i + base for i in t) for t in shape.triangles)
    return out


def quad(corner, right, up, tangents=False):
    """A parallelogram that faces cross(right, up); `corner` is its lower left, where uv = (0, 1)."""
    normal = normalize(cross(right, up))
    return Shape([corner, add(corner, right), add(add(corner, right), up), add(corner, up)], [normal] * 4,
                 [(0, 1), (1, 1), (1, 0), (0, 0)], [(0, 1, 2), (0, 2, 3)],
                 [normalize(right) + (1,)] * 4 if tangents else [])


def floor(half, y=0.0):
    """A square in the plane of `y`, facing up."""
    return quad((-half, y, half), (2 * half, 0, 0), (0, 0, -2 * half))


def patch(surface, columns, rows, normal=None, tangents=False):
    """surface(u, v) over the unit square; the front is where u runs right and v up."""
    out = Shape()
    h = 1e-4
    for j in range(rows + 1):
        for i in range(columns + 1):
            u, v = i / columns, j / rows
            du = sub(surface(u + h, v), surface(u - h, v))
            dv = sub(surface(u, v + h), surface(u, v - h))
            n = normal(u, v) if normal else normalize(cross(du, dv))
            out.positions.append(surface(u, v))
            out.normals.append(n)
            out.uv0.append((u, 1 - v))
            if tangents:
                flat = sub(du, scale(n, dot(du, n)))
                out.tangents.append(normalize(flat) + (1,))
    for j in range(rows):
        for i in range(columns):
            a = j * (columns + 1) + i
            b = a + columns + 1
            corners = out.positions
            for t in ((a, a + 1, b + 1), (a, b + 1, b)):
                x, y, z = (corners[k] for k in t)
                if dot(cross(sub(y, x), sub(z, x)), cross(sub(y, x), sub(z, x))) > 1e-20:
                    out.triangles.append(t)
    return out


def sphere(radius=1.0, columns=48, rows=24, tangents=False):
    """Around the origin; u runs counter-clockwise seen from above."""
    def direction(u, v):
        phi, theta = 2 * math.pi * u, math.pi * (1 - v)
        return (math.sin(theta) * math.sin(phi), math.cos(theta), math.sin(theta) * math.cos(phi))
    out = patch(lambda u, v: scale(direction(u, v), radius), columns, rows, direction)
    if tangents:
        out.tangents = [(math.cos(2 * math.pi * u), 0.0, -math.sin(2 * math.pi * u), 1.0) for u, v in out.uv0]
    return out


def rounded_box(size, radius, steps=4):
    """Around the origin, with edges rounded to `radius`."""
    half = scale(size, 0.5)
    tangents = [math.tan(math.pi / 4 * k / steps) for k in range(steps + 1)]
    out = Shape()
    for axis in range(3):
        for sign in (-1, 1):
            a, b = (axis + 1) % 3, (axis + 2) % 3
            spans = [[-(half[k] - radius) - radius * t for t in reversed(tangents)]
                     + [half[k] - radius + radius * t for t in tangents] for k in (a, b)]
            first = len(out.positions)
            for y in spans[1]:
                for x in spans[0]:
                    point = [0.0, 0.0, 0.0]
                    point[axis], point[a], point[b] = sign * half[axis], x, y
                    core = tuple(max(radius - h, min(h - radius, p)) for p, h in zip(point, half))
                    n = normalize(sub(tuple(point), core))
                    out.positions.append(add(core, scale(n, radius)))
                    out.normals.append(n)
                    out.uv0.append((0.5 + sign * x / size[a], 0.5 - y / size[b]))
            count = len(spans[0])
            for j in range(count - 1):
                for i in range(count - 1):
                    p = first + j * count + i
                    for t in ((p, p + 1, p + count + 1), (p, p + count + 1, p + count)):
                        out.triangles.append(t if sign > 0 else (t[0], t[2], t[1]))
    return out


def lathe(profile, columns, rows):
    """profile(v) -> (radius, height), turned about +y; the outside is the front where v runs upwards."""
    def surface(u, v):
        r, y = profile(v)
        phi = 2 * math.pi * u
        return (r * math.sin(phi), y, r * math.cos(phi))
    return patch(surface, columns, rows)

