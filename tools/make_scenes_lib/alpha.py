"""alpha_modes and double_sided: what rays pass through."""
import math

from .facts import Expectations
from .gltf import CLAMP, Gltf
from .measure import View, meet_plane, point_light
from .png import Picture
from .sampling import hue
from .shapes import floor, lathe, patch, quad, rounded_box, sphere
from .vec import add, axis_angle, scale


def lattice(size=128):
    """A leafy cut-out: alpha is the pattern."""
    def paint(u, v):
        x, y = u * 5 % 1 - 0.5, v * 5 % 1 - 0.5
        petals = 0.27 + 0.17 * math.cos(4 * math.atan2(y, x))
        hole = math.hypot(x, y) < petals
        frame = min(u, v, 1 - u, 1 - v) < 0.03
        return (*hue(0.4 + 0.12 * v, 0.5, 0.62), 1.0 if frame or not hole else 0.0)
    return Picture(size, size, 4, paint)


def gradient(size=64):
    """Stained glass: hue runs across, opacity down."""
    return Picture(size, size, 4, lambda u, v: (*hue(0.95 + 0.6 * u, 0.72, 0.95), 0.12 + 0.76 * v))


def alpha_modes():
    """OPAQUE, MASK and BLEND sheets and their shadows; scene 1 and 2 hold sheets of exactly one half."""
    g = Gltf()
    sheet = quad((-0.8, 0.05, 0), (1.6, 0, 0), (0, 1.9, 0))
    leaves, glass = g.texture("lattice", lattice(), (CLAMP, CLAMP)), g.texture("gradient", gradient(), (CLAMP, CLAMP))
    kinds = [
        ("opaque", dict(texture=g.texture_use(glass), roughness=0.5)),
        ("mask", dict(texture=g.texture_use(leaves), roughness=0.5, alphaMode="MASK", alphaCutoff=0.5)),
        ("blend", dict(texture=g.texture_use(glass), roughness=0.5, alphaMode="BLEND")),
    ]
    nodes = []
    post = g.mesh("post", g.primitive(rounded_box((1.76, 0.1, 0.16), 0.03, 3),
                                      g.material("oak", (0.4, 0.26, 0.16), roughness=0.5)))
    for i, (name, material) in enumerate(kinds):
        mesh = g.mesh(name, g.primitive(sheet, g.material(name, doubleSided=True, **material)))
        turn = axis_angle((0, 1, 0), 12.0 * (i - 1))
        place = (2.05 * (i - 1), 0.0, -0.25 * abs(i - 1) + 0.2)
        nodes += [g.node(name, mesh=mesh, translation=place, rotation=turn),
                  g.node(mesh=post, translation=add(place, (0, 0.04, 0)), rotation=turn),
                  g.node(mesh=post, translation=add(place, (0, 1.98, 0)), rotation=turn)]
    ball = g.mesh("ball", g.primitive(sphere(0.42, 40, 20), g.material("porcelain", (0.85, 0.84, 0.82),
                                                                       roughness=0.25)))
    nodes += [g.node("ball", mesh=ball, translation=(x, 0.42, -1.3)) for x in (-2.3, 0.0, 2.3)]
    ground = g.mesh("ground", g.primitive(floor(40), g.material("ground", (0.62, 0.58, 0.53), roughness=0.8)))
    lamp = g.mesh("sky panel", g.primitive(quad((-6, 7, 2), (12, 0, 0), (0, 0, 8)),
                                           g.light_material("sky panel", (0.8, 1.0, 1.4))))
    sun = g.light("sun", "directional", (1.0, 0.9, 0.76), 4.0, (2.2, 5.0, -4.2), target=(0, 0, 0))
    wall = g.mesh("wall", g.primitive(quad((-40, 0, -12), (80, 0, 0), (0, 7, 0)),
                                      g.material("wall", (0.32, 0.36, 0.42), roughness=0.9)))
    g.scene("sheets", *nodes, g.node("ground", mesh=ground), g.node("wall", mesh=wall),
            g.node("sky panel", mesh=lamp), sun,
            g.perspective("camera", (0.0, 2.5, 7.4), (0, 0.72, 0.35), 32.0))
    e = Expectations("sheets of alpha one half, crossed once, twice, and by shadow rays")
    e.parity_options("--max-depth", "4")
    _half_sheets(g, e)
    _half_shadow(g, e)
    return g, e


def _half_sheets(g, e):
    """Scene 1, seen along -z, three columns: two sheets over a wall; two sheets over nothing; one before a mirror."""
    red, blue, white = (0.8, 0.1, 0.05), (0.1, 0.2, 0.9), (0.9, 0.9, 0.9)
    column = quad((-0.45, -0.9, 0), (0.9, 0, 0), (0, 1.8, 0))
    parts = [("red half", column, (*red, 0.5), dict(unlit=True, alphaMode="BLEND")),
             ("blue half", column, (*blue, 0.5), dict(unlit=True, alphaMode="BLEND")),
             ("black half", column, (0, 0, 0, 0.5), dict(unlit=True, alphaMode="BLEND", doubleSided=True)),
             ("unlit white", column, white, dict(unlit=True)),
             ("mirror", column, (1, 1, 1), dict(metallic=1.0, roughness=0.0)),
             ("masked out", column, (*red, 0.49), dict(unlit=True, alphaMode="MASK", alphaCutoff=0.5)),
             ("masked in", column, (*red, 0.5), dict(unlit=True, alphaMode="MASK", alphaCutoff=0.5))]
    mesh = {name: g.mesh(name, g.primitive(shape, g.material(name, base, **more)))
            for name, shape, base, more in parts}
    layout = [(-2, ("red half", "blue half", "unlit white")), (-1, ("red half", "blue half")),
              (0, ("black half", "mirror")),
              (1, ("masked out", "blue half")), (2, ("masked in", "unlit white"))]
    nodes = [g.node(mesh=mesh[name], translation=(x, 0, -0.5 * depth))
             for x, names in layout for depth, name in enumerate(names)]
    g.scene("one half", *nodes, g.orthographic("front", (0, 0, 5), (0, 0, 0), 2.5, 1.0))

    view = View((0, 0, 5), (0, 0, 0), (80, 32), ymag=1.0)
    areas = {x: view.around((x, 0, 0), 0.2, 0.42) for x, _ in layout}
    r = e.render("half sheets", view.size, "--scene", "1", "--env", "2,2,2", "--max-depth", "3",
                 "--background", "transparent", spp=64)
    over = add(add(scale(red, 0.5), scale(blue, 0.25)), scale(white, 0.25))
    r.region_mean(areas[-2], over, 1e-4, "half red, then half blue, then white: 1/2, 1/4, 1/4")
    r.alpha_mean(areas[-2], 1.0, 1e-6, "the wall behind closes the view")
    r.region_mean(areas[-1], add(scale(red, 0.5), scale(blue, 0.25)), 1e-4, "nothing behind the two sheets")
    r.alpha_mean(areas[-1], 0.75, 1e-4, "1 - 1/2 × 1/2")
    r.region_mean(areas[0], (0.5, 0.5, 0.5), 1e-4,
                  "one sheet crossed before and after a mirror: 2 × 1/2 × 1/2; the segments decide independently")
    r.region_mean(areas[1], scale(blue, 0.5), 1e-4, "alpha below the cutoff is absent")
    r.alpha_mean(areas[1], 0.5, 1e-4, "alpha below the cutoff is absent")
    r.region_mean(areas[2], red, 1e-5, "alpha at the cutoff is opaque")


def _half_shadow(g, e):
    """Scene 2: a point light over a plane, one half of it under two sheets of one half."""
    base = (0.7, 0.6, 0.5)
    plane = g.mesh("plane", g.primitive(floor(4.0), g.material("plane", base, roughness=1.0)))
    cover = quad((0.0, 1.2, 0.6), (1.2, 0, 0), (0, 0, -1.2))
    half = g.mesh("half cover", g.primitive(cover, g.material("half cover", (0, 0, 0, 0.5), alphaMode="BLEND",
                                                              doubleSided=True)))
    nodes = [g.node("plane", mesh=plane), g.node(mesh=half), g.node(mesh=half, translation=(0, 0.2, 0))]
    lamp = g.light("bulb", "point", (1, 0.9, 0.8), 6.0, (0, 2.0, 0))
    eye, aim = (0.0, 1.75, 5.0), (0.0, 0.0, 0.0)
    g.scene("half shadow", *nodes, lamp, g.orthographic("slanted", eye, aim, 1.5, 0.75))
    view = View(eye, aim, (48, 24), ymag=0.75)
    r = e.render("half shadows", view.size, "--scene", "2", "--env", "none", "--max-depth", "1", spp=128)
    for x, share in ((0.5, 0.25), (1.1, 0.25), (-0.6, 1.0)):
        def radiance(origin, direction):
            p = meet_plane(origin, direction, (0, 0, 0), (0, 1, 0))
            return scale(point_light((base, 0.0, 1.0), p, (0, 1, 0), scale(direction, -1), (0, 2.0, 0),
                                     (6.0, 5.4, 4.8)), share)
        rect = view.around((x, 0, 0), 0.15)
        r.region_mean(rect, view.average(rect, radiance, 12), 0.002,
                      "shadow rays pass two half sheets one time in four" if share < 1 else "no sheet in the way")


def double_sided():
    """A Möbius band and bowls: back faces absent, or shaded like fronts. Scene 1 measures quads."""
    g = Gltf()

    def moebius(u, v):
        phi, w = 2 * math.pi * u, 0.42 * (v - 0.5) * 2
        r = 1.0 + w * math.cos(phi / 2)
        return (r * math.cos(phi), w * math.sin(phi / 2), r * math.sin(phi))

    def bowl(v):
        angle = math.pi * (0.5 + 0.4995 * (1 - v))
        return (math.sin(angle) * 0.62 + 1e-5, 0.62 + 0.62 * math.cos(angle))
    band = g.mesh("band", g.primitive(patch(moebius, 160, 12),
                                      g.material("enamel", (0.85, 0.2, 0.12), roughness=0.25, doubleSided=True)))
    shape = lathe(bowl, 64, 24)
    teal, ochre = (0.05, 0.38, 0.42), (0.85, 0.55, 0.13)
    both = g.mesh("both sides", g.primitive(shape, g.material("both sides", ochre, roughness=0.35, doubleSided=True)))
    inside = g.mesh("inside only", g.primitive(shape.reversed(), g.material("inside only", teal, roughness=0.35)))
    outside = g.mesh("outside only", g.primitive(shape, g.material("outside only", (0.4, 0.42, 0.6), roughness=0.35)))
    ground = g.mesh("ground", g.primitive(floor(40), g.material("ground", (0.55, 0.52, 0.5), roughness=0.6)))
    g.scene("band and bowls", g.node("band", mesh=band, translation=(0, 1.08, -0.9),
                                     rotation=axis_angle((1, 0, 0.25), 38)),
            g.node("both sides", mesh=both, translation=(-1.65, 0, 0.55)), g.node("inside only", mesh=inside,
                                                                                  translation=(0, 0, 1.0)),
            g.node("outside only", mesh=outside, translation=(1.65, 0, 0.55)), g.node("ground", mesh=ground),
            g.perspective("camera", (0.0, 2.7, 6.6), (0, 0.86, 0), 31.0))

    base = (0.6, 0.4, 0.2)
    tile = quad((-0.45, -0.45, 0), (0.9, 0, 0), (0, 0.9, 0))
    two, one = (g.mesh(n, g.primitive(tile, g.material(n, base, roughness=1.0, doubleSided=d))) for n,
                d in (("two-sided", True), ("one-sided", False)))
    back = axis_angle((0, 1, 0), 180)
    g.scene("measured", g.node(mesh=two, translation=(-1.5, 0, 0)),
            g.node(mesh=two, translation=(-0.5, 0, 0), rotation=back),
            g.node(mesh=one, translation=(0.5, 0, 0)), g.node(mesh=one, translation=(1.5, 0, 0), rotation=back),
            g.light("bulb", "point", (1, 1, 1), 20.0, (0, 0, 3)), g.orthographic("front", (0, 0, 5), (0, 0, 0), 2.0,
                                                                                 0.5))
    e = Expectations("backs are absent, or shaded like fronts")
    e.parity_options("--max-depth", "4", "--env", "0.6,0.7,0.9")
    view = View((0, 0, 5), (0, 0, 0), (64, 16), ymag=0.5)
    r = e.render("fronts and backs", view.size, "--scene", "1", "--env", "none", "--max-depth", "1",
                 "--background", "transparent", spp=8)
    areas = [view.around((x, 0, 0), 0.3) for x in (-1.5, -0.5, 0.5, 1.5)]
    for x, area in zip((-1.5, -0.5, 0.5), areas):
        def radiance(origin, direction):
            return point_light((base, 0.0, 1.0), (origin[0], origin[1], 0), (0, 0, 1), (0, 0, 1), (0, 0, 3),
                               (20.0,) * 3)
        r.region_mean(area, view.average(area, radiance), 0.002, "a point light 3 m before the quads, closed form")
        r.alpha_mean(area, 1.0, 1e-6, "the face is there")
    r.alpha_mean(areas[3], 0.0, 1e-6, "a back face of a one-sided material is absent")
    r.max_below(areas[3], 0.0, "and adds nothing")
    return g, e
