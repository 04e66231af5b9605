"""punctual_lights and emissive_texture."""
import math

from .facts import Expectations
from .gltf import CLAMP, Gltf
from .measure import View, directional, meet_plane, point_light, quad_light
from .png import Picture
from .sampling import hue, lookup
from .shapes import floor, lathe, quad, rounded_box, sphere
from .vec import axis_angle, scale, sub

CLAY = (0.7, 0.62, 0.55)


def _stage(g):
    """The picture: three coloured spots on a wall, a bulb, a faint moon."""
    white = g.material("plaster", (0.78, 0.76, 0.73), roughness=0.85)
    nodes = [g.node("floor", mesh=g.mesh("floor", g.primitive(floor(12),
                                                              g.material("stage", (0.32, 0.3, 0.29),
                                                                         roughness=0.35)))),
             g.node("wall", mesh=g.mesh("wall", g.primitive(quad((-12, 0, -2.6), (24, 0, 0), (0, 10, 0)), white)))]
    ball = g.mesh("ball", g.primitive(sphere(0.5, 48, 24), white))
    gold = g.mesh("gold", g.primitive(sphere(0.34, 48, 24), g.material("gold", (1.0, 0.72, 0.3), 1.0, 0.22)))
    block = g.mesh("block", g.primitive(rounded_box((0.9, 0.9, 0.9), 0.08, 5), white))

    def vase(v):
        return (0.18 + 0.22 * math.sin(math.pi * (0.08 + 0.84 * v)) ** 2 * (1.25 - 0.6 * v) + 0.05 * v ** 6, 1.25 * v)
    urn = g.mesh("vase", g.primitive(lathe(vase, 48, 32), g.material("glaze", (0.12, 0.2, 0.34), roughness=0.2,
                                                                     doubleSided=True)))
    nodes += [g.node("ball", mesh=ball, translation=(-1.75, 0.5, 0.2)),
              g.node("gold", mesh=gold, translation=(0.75, 0.34, 0.95)),
              g.node("block", mesh=block, translation=(1.9, 0.45, -0.5), rotation=axis_angle((0, 1, 0), 28)),
              g.node("vase", mesh=urn, translation=(0, 0, -0.35))]
    for i, (color, x) in enumerate((((1.0, 0.28, 0.16), -2.3), ((1.0, 0.72, 0.25), 0.0), ((0.16, 0.55, 1.0), 2.3))):
        nodes.append(g.light(f"spot {i}", "spot", color, 85, (x * 0.75, 4.4, 2.4), target=(x, 1.25, -2.6),
                             spot={"innerConeAngle": 0.2, "outerConeAngle": 0.34}))
    nodes += [g.light("bulb", "point", (1.0, 0.78, 0.52), 2.2, (-0.85, 0.55, 1.15), range=12.0),
              g.light("moon", "directional", (0.6, 0.75, 1.0), 0.25, (3, 5, 4), target=(0, 0, 0))]
    g.scene("stage", *nodes, g.perspective("camera", (0.0, 1.9, 7.6), (0, 1.12, -0.4), 29.0))


def punctual_lights():
    """Point, spot, directional and range. Scenes 1 to 4 light a plane that is measured against closed forms."""
    g = Gltf()
    _stage(g)
    plane = g.mesh("plane", g.primitive(floor(3.0), g.material("clay", CLAY, roughness=0.8)))
    glossy = g.mesh("glossy plane", g.primitive(floor(3.0), g.material("brass", (0.9, 0.7, 0.4), 1.0, 0.5)))
    eye, aim = (0, 5.0, 2.0), (0, 0, 0)
    bulb, candela = (0.4, 1.2, -0.3), (6.0, 4.8, 3.0)
    beam_at, beam_to, inner, outer = (-1.2, 2.0, 0.8), (0.2, 0, 0), 0.3, 0.6
    travel = (0.5, -1.0, -0.4)
    clay, brass = (CLAY, 0.0, 0.8), ((0.9, 0.7, 0.4), 1.0, 0.5)
    lux = (4.0, 3.6, 2.8)
    axis = sub(beam_to, beam_at)
    cases = (
        ("point", plane, clay, dict(kind="point", color=scale(candela, 1 / 6), intensity=6, position=bulb),
         lambda m, p, n, wo: point_light(m, p, n, wo, bulb, candela)),
        ("range", plane, clay, dict(kind="point", color=scale(candela, 1 / 6), intensity=6, position=bulb, range=1.9),
         lambda m, p, n, wo: point_light(m, p, n, wo, bulb, candela, reach=1.9)),
        ("spot", plane, clay, dict(kind="spot", color=scale(candela, 1 / 6), intensity=6, position=beam_at,
                                   target=beam_to,
                                   spot={"innerConeAngle": inner, "outerConeAngle": outer}),
         lambda m, p, n, wo: point_light(m, p, n, wo, beam_at, candela, spot=(axis, inner, outer))),
        ("directional", glossy, brass, dict(kind="directional", color=scale(lux, 0.25), intensity=4,
                                            position=scale(travel, -3.0), target=(0, 0, 0)),
         lambda m, p, n, wo: directional(m, p, n, wo, travel, lux)),
    )
    e = Expectations("irradiance of each punctual light on a plane, through the BRDF, in closed form")
    e.parity_options("--max-depth", "4")
    view = View(eye, aim, (64, 48), ymag=1.5)
    for i, (name, mesh, material, light, formula) in enumerate(cases):
        g.scene(name, g.node(mesh=mesh), g.light(name, **light), g.orthographic(f"above {name}", eye, aim, 2.0, 1.5))
        r = e.render(f"{name} light", view.size, "--scene", str(i + 1), "--env", "none", "--max-depth", "1", spp=4)
        normal = (0, 1, 0)
        for x, z in ((-1.5, -1.0), (0.0, -1.0), (1.5, -1.0), (-1.5, 0.2), (0.3, -0.2), (1.0, 0.6), (-1.0, 1.2),
                     (1.6, 1.2)):
            def radiance(origin, direction):
                p = meet_plane(origin, direction, (0, 0, 0), normal)
                return formula(material, p, normal, scale(direction, -1))
            rect = view.around((x, 0, z), 0.07)
            r.region_mean(rect, view.average(rect, radiance, 16), 0.005,
                          f"{name} light at ({x:g}, 0, {z:g}), closed form")
        if name == "range":
            r.max_below(view.around((-1.7, 0, 1.3), 0.03), 0.0, "no light beyond the range")
        if name == "spot":
            r.max_below(view.around((-1.8, 0, 1.2), 0.03), 0.0, "no light outside the outer cone")
    return g, e


# ---- emissive_texture ----

SEEDS = [((i * 0.7548777 + 0.13 * math.sin(5 * i)) % 1, (i * 0.5698403 + 0.5) % 1) for i in range(34)]


def stained_glass(size=96):
    """Voronoi cells in jewel colours between leads."""
    def paint(u, v):
        reach = sorted((math.hypot(u - x, 0.75 * (v - y)), i) for i, (x, y) in enumerate(SEEDS))
        if reach[1][0] - reach[0][0] < 0.016 or min(u, v, 1 - u, 1 - v) < 0.02:
            return (0.015, 0.015, 0.02)
        i = reach[0][1]
        return hue((0.02, 0.1, 0.14, 0.52, 0.58, 0.62, 0.93)[i * 3 % 7], 0.78 if i % 5 else 0.35,
                   0.82 + 0.18 * (i % 3) / 2)
    return Picture(size, size, 3, paint)


def emissive_texture():
    """A lit window of stained glass over a polished floor. Scene 1 measures its light on the floor."""
    g = Gltf()
    picture, strength = stained_glass(), 5.0
    corner, right, up = (-1.6, 0.35, -1.6), (3.2, 0, 0), (0, 2.4, 0)
    glass = g.material("glass", (0, 0, 0), emissive=(1, 1, 1), strength=strength,
                       emissive_texture=g.texture_use(g.texture("stained_glass", picture, (CLAMP, CLAMP))))
    window = g.mesh("window", g.primitive(quad(corner, right, up), glass))
    stone = g.material("stone", (0.5, 0.48, 0.46), roughness=0.9)
    pillar = g.mesh("pillar", g.primitive(rounded_box((0.5, 3.4, 0.5), 0.06, 4), stone))
    beam = g.mesh("beam", g.primitive(rounded_box((4.2, 0.5, 0.5), 0.06, 4), stone))
    wall = g.mesh("wall", g.primitive(quad((-14, 0, -1.75), (28, 0, 0), (0, 9, 0)), stone))
    ground = g.mesh("floor", g.primitive(floor(14), g.material("polished", (0.22, 0.21, 0.2), roughness=0.22)))
    pearl = g.mesh("pearl", g.primitive(sphere(0.38, 48, 24), g.material("pearl", (0.88, 0.86, 0.84), roughness=0.3)))
    steel = g.mesh("steel", g.primitive(sphere(0.3, 48, 24), g.material("steel", (0.9, 0.9, 0.9), 1.0, 0.06)))
    g.scene("window", g.node("window", mesh=window), g.node("wall", mesh=wall), g.node("floor", mesh=ground),
            g.node("left pillar", mesh=pillar, translation=(-1.85, 1.7, -1.55)), g.node("right pillar", mesh=pillar,
                                                                                        translation=(1.85, 1.7,
                                                                                                     -1.55)),
            g.node("beam", mesh=beam, translation=(0, 3.0, -1.55)), g.node("sill", mesh=beam,
                                                                           translation=(0, 0.1, -1.55)),
            g.node("pearl", mesh=pearl, translation=(-0.95, 0.38, 0.6)), g.node("steel", mesh=steel,
                                                                                translation=(0.9, 0.3, 0.95)),
            g.light("moon", "directional", (0.55, 0.7, 1.0), 0.6, (2.5, 4, 3), target=(0, 0, 0)),
            g.perspective("camera", (0.9, 1.5, 6.2), (0, 1.22, -0.8), 36.0))

    base = (0.8, 0.75, 0.7)
    plane = g.mesh("matte floor", g.primitive(floor(4), g.material("matte", base, roughness=1.0)))
    eye, aim = (0, 4.0, 5.0), (0, 0.6, 0)
    g.scene("measured", g.node(mesh=window), g.node(mesh=plane), g.orthographic("above", eye, aim, 2.4, 2.4))
    e = Expectations("light of a textured emitter on a floor, by quadrature over its texels")
    e.parity_options("--max-depth", "4")
    view = View(eye, aim, (48, 48), ymag=2.4)
    r = e.render("direct light", view.size, "--scene", "1", "--env", "none", "--max-depth", "1", spp=128)

    def emitted(s, t):
        return scale(lookup(picture, s, 1 - t, (CLAMP, CLAMP)), strength)
    steps = 24
    table = {(i, j): scale(tuple(map(sum, zip(*(emitted((i + a / 4 + 0.125) / steps, (j + b / 4 + 0.125) / steps)
                                                 for a in range(4) for b in range(4))))), 1 / 16)
             for i in range(steps) for j in range(steps)}
    for x, z in ((-1.4, -0.6), (0.0, -0.8), (1.3, -0.5), (0.0, 0.8)):
        def radiance(origin, direction):
            p = meet_plane(origin, direction, (0, 0, 0), (0, 1, 0))
            return quad_light((base, 0.0, 1.0), p, (0, 1, 0), scale(direction, -1), corner, right, up,
                              lambda s, t: table[int(s * steps), int(t * steps)], steps)
        rect = view.around((x, 0, z), 0.11, 0.045)
        r.region_mean(rect, view.average(rect, radiance, 4), 0.015,
                      f"floor at ({x:g}, 0, {z:g}), by quadrature over the texels")
    for x, y in ((-0.8, 1.1), (0.8, 1.1), (-0.8, 2.1), (0.8, 2.1)):
        def shown(origin, direction):
            p = meet_plane(origin, direction, corner, (0, 0, 1))
            return emitted((p[0] - corner[0]) / right[0], (p[1] - corner[1]) / up[1])
        rect = view.around((x, y, corner[2]), 0.1, 0.06)
        r.region_mean(rect, view.average(rect, shown, 24), 0.012, "the window shows its texels")
    return g, e
