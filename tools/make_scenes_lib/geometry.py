"""instances, orthographic and vertex_attributes."""
import math

from .facts import Expectations
from .gltf import UNSIGNED_BYTE, UNSIGNED_SHORT, Gltf
from .measure import View, directional, meet_plane, meet_sphere
from .png import Picture
from .sampling import linear_from_srgb, lookup
from .shapes import floor, patch, quad, rounded_box, sphere
from .vec import axis_angle, lerp, mul, normalize, quaternion_product, rotate, scale, sub


def srgb(text):
    """Linear RGB of a hexadecimal sRGB colour."""
    return tuple(linear_from_srgb(int(text[i:i + 2], 16) / 255) for i in (0, 2, 4))


# ---- instances ----

def bud():
    """A twisted, ribbed bud of 5,400 triangles, 1 m high, its foot at the origin."""
    def surface(u, v):
        phi = 2 * math.pi * (u + 0.22 * v)
        ribs = 1 + 0.16 * math.cos(7 * 2 * math.pi * u) * math.sin(math.pi * v) ** 0.5
        r = 0.34 * ribs * math.sin(math.pi * (0.02 + 0.97 * v) ** 0.8) ** 0.9 + 1e-4
        return (r * math.sin(phi), v, r * math.cos(phi))
    return patch(lambda u, v: surface(u, 0.01 + 0.98 * v), 90, 30)


ELLIPSOIDS = [  # (centre, turn, scale, roughness)
    ((-1.5, 0.75, 0), ((0, 0, 1), 30), (0.7, 0.4, 0.5), 0.5), ((0.0, 0.75, 0), ((1, 1, 0), 50), (0.35, 0.7, 0.6),
                                                               0.5),
    ((1.5, 0.75, 0), ((0, 1, 0), 70), (0.3, 0.6, 0.7), 0.5), ((-1.5, -0.75, 0), ((1, 0, 0), -40), (-0.6, 0.5, 0.35),
                                                              0.5),
    ((0.0, -0.75, 0), ((0, 1, 1), 25), (0.7, -0.3, 0.6), 0.5), ((1.5, -0.75, 0), ((1, 2, 3), 200), (-0.4, -0.6, -0.7),
                                                                0.5)]


def instances():
    """Four hundred placements of one mesh. Scene 1 measures ellipsoids, instances of one ball."""
    g = Gltf()
    flower = g.mesh("bud", g.primitive(bud(), g.material("placeholder")))
    palette = [("ivory", (0.86, 0.82, 0.74), 0.0, 0.35), ("rose", (0.74, 0.2, 0.2), 0.0, 0.3),
               ("gold", (1.0, 0.74, 0.35), 1.0, 0.25),
               ("teal", (0.05, 0.33, 0.36), 0.0, 0.25), ("copper", (0.95, 0.55, 0.4), 1.0, 0.35)]
    kinds = [g.with_material(flower, g.material(n, base, metallic, roughness), n)
             for n, base, metallic, roughness in palette]
    nodes = []
    for n in range(400):
        r, phi = 0.36 * math.sqrt(n + 0.5), n * math.pi * (3 - math.sqrt(5))
        place = (r * math.sin(phi), 0.0, r * math.cos(phi))
        lean = axis_angle((math.cos(phi), 0, -math.sin(phi)), 9 * r)
        turn = quaternion_product(lean, axis_angle((0, 1, 0), 37.0 * n))
        width, height = 0.55 + 0.075 * r, (0.5 + 0.9 * math.exp(-(r / 3.2) ** 2)) * (0.9 + 0.2 * math.sin(1.7 * n))
        ring = (n * 5 // 8) % 13
        kind = 2 if r < 1.3 else (0, 3, 0, 1, 0, 3, 0, 0, 4, 0, 3, 1, 0)[ring]
        nodes.append(g.node(mesh=kinds[kind], translation=place, rotation=turn, scale=(width, height, width * 0.85)))
    ground = g.mesh("ground", g.primitive(floor(80), g.material("ground", (0.1, 0.105, 0.12), roughness=0.5)))
    g.scene("field", *nodes, g.node("ground", mesh=ground), g.perspective("camera", (0, 6.9, 9.4), (0, 0.0, 0.75),
                                                                          36.0))

    material = ((0.9, 0.6, 0.4), 0.5, 0.5)
    ball = g.mesh("ball", g.primitive(sphere(1.0, 96, 48), g.material("measured", *material)))
    placed = [g.node(mesh=ball, translation=c, rotation=axis_angle(*turn), scale=size)
              for c, turn, size, _ in ELLIPSOIDS]
    travel = (-0.4, -0.5, -0.9)
    g.scene("ellipsoids", *placed, g.light("sun", "directional", (1, 1, 1), 3, scale(travel, -1.0), target=(0, 0, 0)),
            g.orthographic("front", (0, 0, 5), (0, 0, 0), 2.4, 1.6))
    e = Expectations("normals of rotated, stretched and mirrored instances, against ellipsoids in closed form")
    e.parity_options("--env", "0.7,0.8,1", "--max-depth", "3")
    view = View((0, 0, 5), (0, 0, 0), (96, 64), ymag=1.6)
    r = e.render("ellipsoids", view.size, "--scene", "1", "--env", "none", "--max-depth", "1", spp=8)
    for centre, turn, size, _ in ELLIPSOIDS:
        q = axis_angle(*turn)
        inverse = (-q[0], -q[1], -q[2], q[3])
        shrink = tuple(1 / s for s in size)

        def radiance(origin, direction):
            o = mul(rotate(inverse, sub(origin, centre)), shrink)
            d = mul(rotate(inverse, direction), shrink)
            p = meet_sphere(o, normalize(d), (0, 0, 0), 1.0)
            n = normalize(rotate(q, mul(p, shrink)))
            return directional(material, p, n, scale(direction, -1), travel, (3.0,) * 3)
        rect = view.around(centre, 0.055)
        r.region_mean(rect, view.average(rect, radiance, 16), 0.01, f"ellipsoid turned {turn[1]}°, scaled {size}")
    return g, e


# ---- orthographic ----

def orthographic():
    """An isometric town. Scene 1 counts the area of squares at several depths."""
    g = Gltf()
    paints = [srgb(c) for c in ("F2E8CF", "E07A5F", "81B29A", "F2CC8F", "3D5A80", "98C1D9")]
    materials = [g.material(f"paint {i}", c, roughness=0.6) for i, c in enumerate(paints)]
    heights = (0.4, 0.8, 1.3, 1.9, 2.7)
    towers = [g.mesh(f"tower {h:g}", g.primitive(rounded_box((0.86, h, 0.86), 0.07, 3),
                                                 materials[0])) for h in heights]
    ball = g.mesh("dome", g.primitive(sphere(0.34, 40, 20), g.material("gilt", (1.0, 0.76, 0.36), 1.0, 0.2)))
    painted, nodes = {}, []
    for i in range(-9, 10):
        for j in range(-9, 10):
            noise = (math.sin(i * 12.9898 + j * 78.233) * 43758.5453) % 1
            hill = 4.4 * math.exp(-(i * i + j * j) / 14) + 1.5 * noise - 0.4
            if hill < 0:
                continue
            level, color = min(4, int(hill)), int(noise * 997) % 6
            key = level, color
            if key not in painted:
                painted[key] = g.with_material(towers[level], materials[color],
                                               f"tower {heights[level]:g}, paint {color}")
            nodes.append(g.node(mesh=painted[key], translation=(i * 0.96, heights[level] / 2, j * 0.96)))
            if int(noise * 89) % 11 == 0:
                nodes.append(g.node(mesh=ball, translation=(i * 0.96, heights[level] + 0.3, j * 0.96)))
    ground = g.mesh("ground", g.primitive(floor(60), g.material("ground", srgb("D8CFC0"), roughness=0.9)))
    sky = g.mesh("sky panel", g.primitive(quad((-30, 26, -44), (60, 0, 0), (0, 0, 46)),
                                          g.light_material("sky panel", (0.8, 0.95, 1.2))))
    g.scene("town", *nodes, g.node("ground", mesh=ground), g.node("sky panel", mesh=sky),
            g.light("sun", "directional", (1, 0.88, 0.7), 3.6, (-2.0, 6.2, 4.2), target=(0, 0, 0)),
            g.orthographic("isometric", (12, 9.8, 12), (0, 0.5, 0), 5.2 * 16 / 9, 5.2))

    red, cyan = (0.8, 0.2, 0.1), (0.1, 0.6, 0.7)
    near, far = (g.mesh(n, g.primitive(quad((-0.35, -0.35, 0), (0.7, 0, 0), (0, 0.7, 0)),
                                       g.material(n, c, unlit=True)))
                 for n, c in (("near", red), ("far", cyan)))
    g.scene("measured", g.node(mesh=near, translation=(-1.0, 0.1, 3)), g.node(mesh=far, translation=(1.0, 0.1, -40)),
            g.orthographic("window", (0, 0, 5), (0, 0, 0), 2.0, 1.0))
    e = Expectations("parallel projection: size does not depend on depth")
    e.parity_options("--max-depth", "3")
    view = View((0, 0, 5), (0, 0, 0), (64, 32), ymag=1.0)
    r = e.render("two squares", view.size, "--scene", "1", "--env", "none", "--max-depth", "1",
                 "--background", "transparent", spp=64)
    r.alpha_mean([0.0, 0.5, 0.0, 1.0], 0.49 / 4, 0.0005, "0.7 m × 0.7 m of a window of 2 m × 2 m, at 2 m")
    r.alpha_mean([0.5, 1.0, 0.0, 1.0], 0.49 / 4, 0.0005, "the same at 45 m")
    r.region_mean([0.0, 0.5, 0.0, 1.0], scale(red, 0.49 / 4), 0.005, "area times colour")
    r.region_mean([0.5, 1.0, 0.0, 1.0], scale(cyan, 0.49 / 4), 0.005, "area times colour")
    for x, color in ((-1.0, red), (1.0, cyan)):
        r.region_mean(view.around((x, 0.1, 0), 0.15), color, 1e-5, "ymag and xmag place the squares")
    return g, e


# ---- vertex_attributes ----

def _height(x, z):
    peak = 1.5 * math.exp(-((x + 0.8) ** 2 + (z + 0.7) ** 2) / 1.3)
    hill = 0.95 * math.exp(-((x - 1.4) ** 2 + (z - 0.2) ** 2) / 0.7)
    ridges = 0.13 * math.sin(2.3 * x + 0.6) * math.cos(2.9 * z - 0.4)
    ridges += 0.05 * math.sin(6.1 * x - 2 * z) * math.sin(5.3 * z + x)
    return peak + hill + ridges - 0.11 * (x * x + z * z) ** 0.9 + 0.22


def _ground_color(p, n):
    stops = ((-0.4, srgb("C9B27C")), (0.1, srgb("E4D3A0")), (0.2, srgb("7FA65A")), (0.7, srgb("3F7A48")),
             (0.95, srgb("8A7A6B")), (1.25, srgb("F4F4F2")))
    color = stops[0][1]
    for (low, a), (high, b) in zip(stops, stops[1:]):
        if p[1] >= low:
            color = lerp(a, b, min(1.0, (p[1] - low) / (high - low)))
    steep = max(0.0, min(1.0, (0.72 - n[1]) / 0.25)) if p[1] > 0.12 else 0.0
    return lerp(color, srgb("7B6D60"), steep)


def _sky(g):
    """Glow along the horizon and a blue cap; the sun shines through the gap between them."""
    def band(low, high):
        def surface(u, v):
            phi, up = -2 * math.pi * u, math.radians(low + (high - low) * v)
            return (58 * math.sin(phi) * math.cos(up), 58 * math.sin(up), 58 * math.cos(phi) * math.cos(up))
        return patch(surface, 32, 4)
    return g.mesh("sky", g.primitive(band(-1, 24), g.light_material("horizon", (0.62, 0.6, 0.62))),
                  g.primitive(band(48, 89), g.light_material("zenith", (0.2, 0.34, 0.6))))


def vertex_attributes():
    """An island painted by vertex colours. Scene 1 measures each type of COLOR_0, and TEXCOORD_1."""
    g = Gltf()
    island = patch(lambda u, v: (6 * u - 3, _height(6 * u - 3, 3 - 6 * v), 3 - 6 * v), 96, 96)
    island.uv0 = []
    paint = [tuple(round(255 * c) for c in _ground_color(p, n)) + (255,)
             for p, n in zip(island.positions, island.normals)]
    land = g.mesh("island", g.primitive(island, g.material("land", roughness=0.85), (UNSIGNED_BYTE, paint)))
    sea = g.mesh("sea", g.primitive(floor(60), g.material("sea", srgb("1E5C73"), roughness=0.12)))
    g.scene("island", g.node("island", mesh=land), g.node("sea", mesh=sea), g.node("sky", mesh=_sky(g)),
            g.light("sun", "directional", (1, 0.86, 0.66), 3.4, (4.5, 3.4, 2.2), target=(0, 0, 0)),
            g.perspective("camera", (0.6, 1.7, 6.6), (0, 0.5, 0), 32.0))

    factor = (0.9, 0.7, 0.5)
    tile = quad((-0.45, -0.45, 0), (0.9, 0, 0), (0, 0.9, 0))

    def affine(p):
        return (0.5 + 0.8 * p[0], 0.5 - 0.7 * p[1], 0.4 + 0.5 * p[0] + 0.3 * p[1])

    def rows(peak, wide):
        colors = [affine(p) + ((1.0,) if wide else ()) for p in tile.positions]
        return [tuple(round(peak * c) if peak else c for c in row) for row in colors]
    chart = Picture(8, 8, 3, lambda u, v: (0.2 + 0.7 * u, 0.9 - 0.6 * v, 0.3 + 0.4 * u * v))
    texture = g.texture("ramp", chart, filtering=9728)
    turned = tile.with_uv(lambda u, v: (v, 1 - u), "uv1")
    painted = g.material("painted", factor, unlit=True)
    kinds = [("float RGB", g.primitive(tile, painted, (5126, rows(0, False)))),
             ("byte RGBA", g.primitive(tile, painted, (UNSIGNED_BYTE, rows(255, True)))),
             ("short RGB", g.primitive(tile, painted, (UNSIGNED_SHORT, rows(65535, False)))),
             ("TEXCOORD_1", g.primitive(turned, g.material("uv1", factor, unlit=True,
                                                           texture=g.texture_use(texture, 1))))]
    nodes = [g.node(name, mesh=g.mesh(name, p), translation=(i - 1.5, 0, 0)) for i, (name, p) in enumerate(kinds)]
    g.scene("measured", *nodes, g.orthographic("front", (0, 0, 5), (0, 0, 0), 2.0, 0.5))
    e = Expectations("vertex colours of every component type, and the second set of texture coordinates")
    e.parity_options("--max-depth", "3")
    view = View((0, 0, 5), (0, 0, 0), (96, 24), ymag=0.5)
    r = e.render("unlit tiles", view.size, "--scene", "1", "--env", "none", "--max-depth", "1", spp=16)
    for i, (name, _) in enumerate(kinds):
        for x, y in ((-0.25, 0.25), (0.25, 0.25), (-0.25, -0.25), (0.25, -0.25)):
            def radiance(origin, direction):
                p = meet_plane(origin, direction, (0, 0, 0), (0, 0, 1))
                local = (p[0] - i + 1.5, p[1])
                if i < 3:
                    return mul(factor, affine(local))
                s, t = local[0] / 0.9 + 0.5, 0.5 - local[1] / 0.9
                return mul(factor, lookup(chart, t, 1 - s, filtering=9728))
            rect = view.around((i - 1.5 + x, y, 0), 0.15)
            r.region_mean(rect, view.average(rect, radiance, 12 if i < 3 else 64), 0.006, f"{name} at ({x:g}, {y:g})")
    return g, e
