"""texture_transform and texture_wrap: walls of tiles, each one setting."""
import math

from .facts import Expectations
from .gltf import CLAMP, LINEAR, MIRROR, NEAREST, REPEAT, Gltf
from .measure import View, meet_plane
from .png import Picture
from .sampling import hue, lookup, transformed
from .shapes import floor, quad, rounded_box

CREAM = (0.96, 0.93, 0.86)
INK = (0.16, 0.18, 0.24)


def chart(size):
    """A picture without any symmetry: hue runs over a checker, an F in the middle, a dot in the first corner."""
    def paint(u, v):
        if (u - 0.17) ** 2 + (v - 0.17) ** 2 < 0.09 ** 2:
            return INK
        stem = 0.34 < u < 0.44 and 0.2 < v < 0.8
        if stem or 0.34 < u < 0.72 and 0.2 < v < 0.3 or 0.34 < u < 0.62 and 0.45 < v < 0.55:
            return CREAM
        odd = (int(u * 4) + int(v * 4)) % 2
        return hue(0.02 + 0.62 * (0.65 * u + 0.35 * v), 0.66 if odd else 0.5, 0.72 if odd else 0.88)
    return Picture(size, size, 3, paint)


class Gallery:
    """Tiles of 1 m on a wall, in columns and rows; scene 0 lit, scene 1 unlit before a parallel camera."""

    def __init__(self, columns, rows):
        self.g = Gltf()
        self.columns, self.rows = columns, rows
        self.lit, self.plain, self.placed = [], [], []
        self.frame = self.g.mesh("frame", self.g.primitive(rounded_box((1.1, 1.1, 0.12), 0.03, 3),
                                                           self.g.material("frame", (0.9, 0.88, 0.84), 0.0, 0.35)))

    def centre(self, column, row):
        return (1.22 * (column - (self.columns - 1) / 2), 1.22 * ((self.rows - 1) / 2 - row), 0.0)

    def tile(self, column, row, name, shape, texture):
        g, centre = self.g, self.centre(column, row)
        lit = g.mesh(name, g.primitive(shape, g.material(name, roughness=0.5, texture=texture)))
        flat = g.with_material(lit, g.material(f"{name}, unlit", texture=texture, unlit=True), f"{name}, unlit")
        self.lit += [g.node(name, mesh=lit, translation=(centre[0], centre[1], 0.065)),
                     g.node(mesh=self.frame, translation=centre)]
        self.plain.append(g.node(name, mesh=flat, translation=(centre[0], centre[1], 0.065)))
        self.placed.append((name, centre))

    def finish(self, about):
        """Adds the room and cameras; returns expectations, the parallel view and its render."""
        g, wide, tall = self.g, 1.22 * self.columns, 1.22 * self.rows
        wall = g.mesh("wall", g.primitive(quad((-20, -tall / 2 - 0.35, -0.06), (40, 0, 0), (0, 12, 0)),
                                          g.material("wall", (0.45, 0.47, 0.5), 0.0, 0.9)))
        ground = g.mesh("ground", g.primitive(floor(20, -tall / 2 - 0.35),
                                              g.material("ground", (0.26, 0.22, 0.19), 0.0, 0.4)))
        eye, aim = (-0.27 * wide, 0.2, 1.13 * wide), (-0.04 * wide, -0.06, 0)
        g.scene("gallery", *self.lit, g.node("wall", mesh=wall), g.node("ground", mesh=ground),
                g.perspective("camera", eye, aim, 37.0))
        size = (32 * self.columns, 32 * self.rows)
        ymag = tall / 2
        g.scene("measured", *self.plain, g.orthographic("front", (0, 0, 5), (0, 0, 0), wide / 2, ymag))
        e = Expectations(about)
        e.parity_options("--env", "0.7,0.8,1", "--max-depth", "3")
        view = View((0, 0, 5), (0, 0, 0), size, ymag=ymag)
        return e, view, e.render("unlit tiles", size, "--scene", "1", "--env", "none", "--max-depth", "1", spp=16)

    def expect(self, view, render, name, color, steps=24):
        """Means over the four quarters of a tile; color(s, t) with t down."""
        centre = dict(self.placed)[name]
        for quarter in range(4):
            at = (centre[0] - 0.22 + 0.44 * (quarter % 2), centre[1] + 0.22 - 0.44 * (quarter // 2), 0)

            def radiance(origin, direction):
                p = meet_plane(origin, direction, (0, 0, 0.065), (0, 0, 1))
                return color(p[0] - centre[0] + 0.5, centre[1] - p[1] + 0.5)
            rect = view.around(at, 0.2 / (1.22 * self.rows))
            render.region_mean(rect, view.average(rect, radiance, steps), 0.012,
                               f"{name}: texels looked up by tools/make_scenes, quarter {quarter}")


TRANSFORMS = (
    ("identity", {}), ("offset", {"offset": (0.25, 0.125)}), ("rotation 30°", {"rotation": math.pi / 6}),
    ("scale 2 × 3", {"scale": (2, 3)}), ("negative scale", {"scale": (-1, 1)}),
    ("rotation about the middle", {"offset": (0.316987, -0.183013), "rotation": -math.pi / 6}),
    ("all three", {"offset": (0.3, -0.2), "rotation": -0.7, "scale": (1.5, 0.75)}),
    ("TEXCOORD_1 by texCoord", {"scale": (1.5, 1.5)}),
)


def texture_transform():
    """KHR_texture_transform: offset, rotation, scale, their order, and the choice of the uv set."""
    gallery = Gallery(4, 2)
    g, picture = gallery.g, chart(96)
    texture = g.texture("chart", picture)
    square = quad((-0.5, -0.5, 0), (1, 0, 0), (0, 1, 0))
    both = square.with_uv(lambda u, v: (1 - v, u), "uv1")
    colors = {}
    for i, (name, transform) in enumerate(TRANSFORMS):
        second = name.startswith("TEXCOORD_1")
        extension = dict(transform, texCoord=1) if second else transform
        gallery.tile(i % 4, i // 4, name, both if second else square,
                     g.texture_use(texture, transform=extension or None))
        colors[name] = lambda s, t, second=second, transform=transform: lookup(
            picture, *transformed(*((1 - t, s) if second else (s, t)), **transform))
    e, view, render = gallery.finish("texture transforms move texels where the extension says")
    for name, _ in TRANSFORMS:
        gallery.expect(view, render, name, colors[name])
    return g, e


MODES = (("repeat", REPEAT), ("clamp", CLAMP), ("mirror", MIRROR))


def texture_wrap():
    """Wrap modes: S by column, T by row, filtered; the last column repeats the diagonal unfiltered."""
    gallery = Gallery(4, 3)
    g, picture = gallery.g, chart(16)
    square = quad((-0.5, -0.5, 0), (1, 0, 0), (0, 1, 0)).with_uv(lambda u, v: (2.5 * u - 0.75, 2.5 * v - 0.75))
    colors = {}
    for row, (down, t_mode) in enumerate(MODES):
        for column, (across, s_mode) in enumerate(MODES + (("nearest", MODES[row][1]),)):
            name = f"{across} × {down}"
            filtering = NEAREST if column == 3 else LINEAR
            gallery.tile(column, row, name, square, g.texture_use(g.texture("chart", picture, (s_mode, t_mode),
                                                                            filtering)))
            colors[name] = lambda s, t, wrap=(s_mode, t_mode), filtering=filtering: lookup(
                picture, 2.5 * s - 0.75, 2.5 * t - 0.75, wrap, filtering)
    e, view, render = gallery.finish("wrap modes and filters put every texel where glTF says")
    for name in colors:
        gallery.expect(view, render, name, colors[name], 64 if name.startswith("nearest") else 24)
    return g, e
