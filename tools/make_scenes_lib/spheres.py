"""furnace and material_grid: spheres of every material."""
import math

from . import brdf
from .facts import Expectations
from .gltf import Gltf
from .measure import View, directional, meet_sphere
from .shapes import floor, quad, rounded_box, sphere
from .vec import add, dot, scale, sub

GOLD = (0.94, 0.5, 0.2)


# ---- furnace ----

FURNACE_ROWS = (  # (base, metallic, roughness) from left to right, top row first
    [((1.0,) * 3, 1.0, r) for r in (0.0, 0.25, 0.5, 0.75, 1.0)],
    [((1.0,) * 3, 0.0, r) for r in (0.0, 0.25, 0.5, 0.75, 1.0)],
    [((0.5,) * 3, 1.0, 0.0), (GOLD, 1.0, 0.4), ((0.0,) * 3, 0.0, 0.0), ((0.0,) * 3, 0.0, 0.5),
     ((0.18, 0.3, 0.6), 0.0, 1.0)],
)


def furnace():
    """Spheres in a uniform environment: each must show its own directional albedo."""
    g = Gltf()
    ball = g.mesh("ball", g.primitive(sphere(1.0, 64, 32), g.material("placeholder")))
    nodes, placed = [], []
    for j, row in enumerate(FURNACE_ROWS):
        for i, (base, metallic, roughness) in enumerate(row):
            name = f"base {base[0]:g} metallic {metallic:g} roughness {roughness:g}"
            mesh = g.with_material(ball, g.material(name, base, metallic, roughness), name)
            centre = (2.4 * (i - 2), 2.4 * (1 - j), 0.0)
            nodes.append(g.node(name, mesh=mesh, translation=centre))
            placed.append((centre, (base, metallic, roughness)))
    g.scene("furnace", *nodes, g.orthographic("front", (0, 0, 5), (0, 0, 0), 6.4, 3.6))

    e = Expectations("tiles and a ball in a uniform environment show their directional albedo, and none gains energy")
    e.parity_options("--env", "1,1,1", "--max-depth", "2")
    _furnace_tiles(g, e, [material for _, material in placed])
    chrome = g.with_material(ball, 1, "mirror")
    g.scene("mirror", g.node(mesh=chrome), g.orthographic("before the mirror", (0, 0, 5), (0, 0, 0), 1.2, 1.2))
    r = e.render("a mirror alone", (32, 32), "--scene", "2", "--env", "1,1,1", "--max-depth", "1", spp=16)
    r.region_uniform([0, 1, 0, 1], 1e-4, "a perfect mirror in a uniform environment cannot be seen, its rim included")
    return g, e


def _furnace_tiles(g, e, materials):
    """Scene 1: the same materials on coplanar tiles, which do not see each other, under three angles of view."""
    tile = g.mesh("tile", g.primitive(quad((-0.45, -0.45, 0), (0.9, 0, 0), (0, 0.9, 0)), 0))
    centres = [(i % 5 - 2.0, 1.0 - i // 5, 0.0) for i in range(len(materials))]
    nodes = [g.node(mesh=g.with_material(tile, i + 1, f"tile {i}"), translation=c) for i, c in enumerate(centres)]
    cameras = []
    for degrees in (0, 45, 75):
        angle = math.radians(degrees)
        eye, ymag = (0, -9 * math.sin(angle), 9 * math.cos(angle)), 1.5 * math.cos(angle)
        cameras.append(g.orthographic(f"{degrees} degrees", eye, (0, 0, 0), 2.5, ymag))
        view = View(eye, (0, 0, 0), (100, round(100 * ymag / 2.5)), ymag=ymag)
        r = e.render(f"tiles seen at {degrees}°", view.size, "--scene", "1", "--camera", f"{degrees} degrees",
                     "--env", "1,1,1", "--max-depth", "1", spp=8)
        for centre, material in zip(centres, materials):
            base, metallic, roughness = material
            half = 0.34 / (2 * ymag)
            r.region_mean(view.around(centre, half, half * math.cos(angle)),
                          brdf.albedo(material, math.cos(angle), 48),
                          0.006, f"albedo of base {base[0]:g}, metallic {metallic:g}, roughness {roughness:g}")
    g.scene("tiles", *nodes, *cameras)


# ---- material_grid ----

GRID_METALLIC = (0.0, 0.25, 0.5, 0.75, 1.0)
GRID_ROUGHNESS = (0.0, 0.15, 0.3, 0.45, 0.6, 0.8, 1.0)


def material_grid():
    """Metallic (front row 0, back row 1) against roughness (left 0, right 1). Scene 1 measures the same spheres."""
    g = Gltf()
    ball = g.mesh("ball", g.primitive(sphere(0.42, 64, 32), g.material("placeholder")))
    step = g.mesh("step", g.primitive(rounded_box((7.6, 1.0, 1.0), 0.05, 4),
                                      g.material("plinth", (0.62, 0.6, 0.57), 0.0, 0.55)))
    ground = g.mesh("ground", g.primitive(floor(60.0), g.material("ground", (0.34, 0.35, 0.37), 0.0, 0.7)))
    picture, measured, placed = [], [], []
    for j, metallic in enumerate(GRID_METALLIC):
        height = 0.18 + 0.32 * j
        picture.append(g.node(f"step {j}", mesh=step, translation=(0, height - 0.5, -1.0 * j)))
        for i, roughness in enumerate(GRID_ROUGHNESS):
            name = f"metallic {metallic:g} roughness {roughness:g}"
            mesh = g.with_material(ball, g.material(name, GOLD, metallic, roughness), name)
            picture.append(g.node(name, mesh=mesh, translation=(1.02 * (i - 3), height + 0.42, -1.0 * j)))
            centre = (1.0 * (i - 3), 1.0 * (j - 2), 0.0)
            measured.append(g.node(name, mesh=mesh, translation=centre))
            placed.append((centre, (GOLD, metallic, roughness)))
    picture.append(g.node("ground", mesh=ground))
    picture.append(g.perspective("camera", (0.0, 4.9, 8.6), (0, 0.86, -1.6), 26.0))
    g.scene("grid", *picture)
    toward = (0.6, 0.7, 0.4)
    sun = g.light("sun", "directional", (1, 1, 1), 3, (0, 0, 0), target=scale(toward, -1.0))
    g.scene("measured", *measured, sun, g.orthographic("front", (0, 0, 5), (0, 0, 0), 4.8, 2.7))

    e = Expectations("the BRDF under one directional light equals glTF 2.0, appendix B, evaluated by tools/make_scenes")
    e.parity_options("--env", "0.5,0.6,0.8", "--max-depth", "4")
    view = View((0, 0, 5), (0, 0, 0), (192, 108), ymag=2.7)
    r = e.render("one directional light", view.size, "--scene", "1", "--env", "none", "--max-depth", "1", spp=4)
    half = scale(add(scale(toward, 1 / math.sqrt(dot(toward, toward))), (0, 0, 1)), 0.5)
    for centre, material in placed:
        def radiance(origin, direction):
            p = meet_sphere(origin, direction, centre, 0.42)
            return directional(material, p, scale(sub(p, centre), 1 / 0.42), scale(direction, -1),
                               scale(toward, -1.0), (3.0,) * 3)
        spots = [("the middle", centre, 12)]
        if material[2] >= 0.45:
            shift = scale(half, 0.42 / math.sqrt(dot(half, half)))
            spots.append(("the highlight", add(centre, (shift[0], shift[1], 0)), 24))
        for place, p, steps in spots:
            rect = view.around(p, 0.1 / 5.4)
            r.region_mean(rect, view.average(rect, radiance, steps), 0.02,
                          f"closed form at {place}: metallic {material[1]:g}, roughness {material[2]:g}")
    return g, e
