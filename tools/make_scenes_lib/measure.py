"""What a camera should see: rays, surfaces and direct light in closed form, averaged over a part of the frame."""
import math

from .brdf import evaluate
from .vec import add, cross, dot, length, lerp, mul, normalize, scale, sub


class View:
    """The camera of one render. Fractions of the frame: x to the right, y down."""

    def __init__(self, eye, target, size, degrees=None, ymag=None, up=(0, 1, 0)):
        back = normalize(sub(eye, target))
        if abs(dot(back, up)) > 0.9999:
            up = (0, 0, -1)
        right = normalize(cross(up, back))
        half = ymag if ymag else math.tan(math.radians(degrees) / 2)
        self.size = size
        self.eye, self.forward, self.orthographic = eye, scale(back, -1), ymag is not None
        self.right, self.up = scale(right, half * size[0] / size[1]), scale(cross(back, right), half)

    def ray(self, x, y):
        shift = add(scale(self.right, 2 * x - 1), scale(self.up, 1 - 2 * y))
        if self.orthographic:
            return add(self.eye, shift), self.forward
        return self.eye, normalize(add(self.forward, shift))

    def project(self, p):
        """Fractions of the frame where the point appears."""
        d = sub(p, self.eye)
        depth = 1.0 if self.orthographic else dot(d, self.forward)
        s = dot(d, self.right) / dot(self.right, self.right) / depth
        t = dot(d, self.up) / dot(self.up, self.up) / depth
        return (s + 1) / 2, (1 - t) / 2

    def around(self, p, half_x, half_y=None):
        """Whole pixels around the point's picture: [x0, x1, y0, y1] in fractions of the frame.

        The half widths are fractions of the frame's height.
        """
        x, y = self.project(p)
        width, height = self.size
        half_y = half_y or half_x
        edges = []
        for middle, half, count in ((x * width, half_x * height, width), (y * height, half_y * height, height)):
            low = round(middle - half)
            edges += [low / count, max(low + 1, round(middle + half)) / count]
        assert 0 <= min(edges) and max(edges) <= 1, f"{p} is out of the frame: {edges}"
        return edges

    def average(self, rect, radiance, steps=12):
        """Mean of radiance(origin, direction) over the rectangle [x0, x1, y0, y1]. Midpoint rule."""
        x0, x1, y0, y1 = rect
        total = (0.0, 0.0, 0.0)
        for j in range(steps):
            for i in range(steps):
                ray = self.ray(lerp(x0, x1, (i + 0.5) / steps), lerp(y0, y1, (j + 0.5) / steps))
                total = add(total, radiance(*ray))
        return scale(total, 1 / steps ** 2)


def meet_plane(origin, direction, point, normal):
    t = dot(sub(point, origin), normal) / dot(direction, normal)
    return add(origin, scale(direction, t))


def meet_sphere(origin, direction, centre, radius):
    """The nearer point, or None."""
    d = sub(origin, centre)
    b = dot(d, direction)
    root = b * b - dot(d, d) + radius * radius
    return add(origin, scale(direction, -b - math.sqrt(root))) if root >= 0 else None


def reflected(material, normal, wo, wi):
    """f |cos| for world directions."""
    side = (0, 0, 1) if abs(normal[2]) < 0.9 else (1, 0, 0)
    x = normalize(cross(side, normal))
    y = cross(normal, x)
    local = [(dot(w, x), dot(w, y), dot(w, normal)) for w in (wo, wi)]
    return scale(evaluate(material, *local), max(0.0, local[1][2]))


def directional(material, p, normal, wo, travel, lux):
    return mul(reflected(material, normal, wo, scale(normalize(travel), -1)), lux)


def point_light(material, p, normal, wo, position, candela, reach=0.0, spot=None):
    """`spot` is (direction, inner, outer): KHR_lights_punctual's angular falloff, angles in radians."""
    to = sub(position, p)
    d = length(to)
    wi = scale(to, 1 / d)
    gain = 1 / (d * d)
    if reach:
        gain *= max(min(1 - (d / reach) ** 4, 1), 0)
    if spot:
        axis, inner, outer = spot
        slope = 1 / max(0.001, math.cos(inner) - math.cos(outer))
        cosine = dot(scale(wi, -1), normalize(axis))
        gain *= max(0.0, min(1.0, (cosine - math.cos(outer)) * slope)) ** 2
    return scale(mul(reflected(material, normal, wo, wi), candela), gain)


def quad_light(material, p, normal, wo, corner, right, up, radiance, steps=16):
    """Unoccluded direct light of a one-sided parallelogram that faces cross(right, up).

    `radiance` is an RGB tuple or a function of (s, t) along right and up.
    """
    face = cross(right, up)
    area = length(face)
    face = scale(face, 1 / area)
    total = (0.0, 0.0, 0.0)
    for j in range(steps):
        for i in range(steps):
            s, t = (i + 0.5) / steps, (j + 0.5) / steps
            to = sub(add(corner, add(scale(right, s), scale(up, t))), p)
            d = length(to)
            wi = scale(to, 1 / d)
            emitted = radiance(s, t) if callable(radiance) else radiance
            weight = max(0.0, -dot(wi, face)) / (d * d) * area / steps ** 2
            total = add(total, scale(mul(reflected(material, normal, wo, wi), emitted), weight))
    return total


def sphere_light(material, p, normal, wo, centre, radius, radiance, steps=24):
    """Unoccluded direct light of a sphere, over the solid angle of its cone."""
    to = sub(centre, p)
    d = length(to)
    z = scale(to, 1 / d)
    x = normalize(cross((0, 0, 1) if abs(z[2]) < 0.9 else (1, 0, 0), z))
    y = cross(z, x)
    cap = 1 - math.sqrt(max(0.0, 1 - (radius / d) ** 2))
    total = (0.0, 0.0, 0.0)
    for j in range(steps):
        for i in range(steps):
            c = 1 - cap * (j + 0.5) / steps
            r, phi = math.sqrt(1 - c * c), 2 * math.pi * (i + 0.5) / steps
            wi = add(scale(z, c), add(scale(x, r * math.cos(phi)), scale(y, r * math.sin(phi))))
            total = add(total, reflected(material, normal, wo, wi))
    return scale(mul(total, radiance), 2 * math.pi * cap / steps ** 2)
