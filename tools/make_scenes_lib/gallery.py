"""bsdf_gallery: a sphere of every BSDF model of VKPT_materials_bsdf, and lossless ones in a white furnace."""
from .facts import Expectations
from .gltf import Gltf
from .measure import View
from .shapes import floor, rounded_box, sphere

BLUE, SAND = (0.06, 0.2, 0.55), (0.75, 0.62, 0.45)

# Rows from the front, each from left to right: (name, VKPT_materials_bsdf).
ROWS = (
    [("lambert", {"model": "lambert", "color": SAND}),
     ("oren_nayar", {"model": "oren_nayar", "color": SAND, "sigma": 0.6}),
     ("eon", {"model": "eon", "color": SAND, "roughness": 1}),
     ("phong", {"model": "phong", "color": 0.4, "diffuse": BLUE, "exponent": 60}),
     ("blinn_phong", {"model": "blinn_phong", "color": 0.4, "diffuse": BLUE, "exponent": 240}),
     ("ashikhmin_shirley", {"model": "ashikhmin_shirley", "color": 0.15, "diffuse": BLUE, "exponent": [15, 600]}),
     ("copper plastic", {"model": "cook_torrance", "preset": "copper_plastic"})],
    [("mirror", {"model": "mirror", "color": 0.9}),
     ("mercury", {"model": "conductor", "metal": "Hg", "alpha": 0}),
     ("gold", {"model": "conductor", "metal": "Au", "alpha": 0.25}),
     ("aluminium", {"model": "conductor", "metal": "Al", "alpha": [0.08, 0.4], "distribution": "beckmann"}),
     ("silver", {"model": "conductor", "metal": "Ag", "alpha": 0.2, "distribution": "phong"}),
     ("iron", {"model": "torrance_sparrow", "metal": "Fe", "alpha": 0.3}),
     ("copper", {"model": "cook_torrance", "preset": "copper"})],
    [("glass", {"model": "dielectric", "ior": "glass"}),
     ("frosted glass", {"model": "dielectric", "ior": "glass", "alpha": 0.15}),
     ("etched glass", {"model": "dielectric", "ior": "glass", "alpha": 0.5, "distribution": "beckmann"}),
     ("diamond", {"model": "dielectric", "ior": "diamond"}),
     ("smooth plastic", {"model": "plastic", "diffuse": (0.6, 0.05, 0.05), "alpha": 0}),
     ("rough plastic", {"model": "plastic", "diffuse": (0.6, 0.05, 0.05), "alpha": 0.3}),
     ("glTF", {"model": "gltf", "color": (0.05, 0.35, 0.2), "metallic": 0, "roughness": 0.3})],
)

# What loses nothing must be invisible in a white furnace.
LOSSLESS = (
    ("white lambert", {"model": "lambert", "color": 1}),
    ("white eon", {"model": "eon", "color": 1, "roughness": 1}),
    ("white mirror", {"model": "mirror", "color": 1}),
    ("white plastic", {"model": "plastic", "diffuse": 1, "alpha": 0}),
    ("rough white plastic", {"model": "plastic", "diffuse": 1, "alpha": 0.4}),
    ("clear glass", {"model": "dielectric", "ior": "glass"}),
    ("rough glass", {"model": "dielectric", "ior": "glass", "alpha": 0.3}),
    ("very rough glass", {"model": "dielectric", "ior": "glass", "alpha": 0.8, "distribution": "beckmann"}),
    ("rough diamond", {"model": "dielectric", "ior": "diamond", "alpha": 0.3}),
    ("white metal", {"model": "gltf", "color": 1, "metallic": 1, "roughness": 0.8}),
    ("white glTF", {"model": "gltf", "color": 1, "metallic": 0, "roughness": 0.6}),
    ("water", {"model": "dielectric", "ior": "water", "alpha": 0.2, "distribution": "phong"}),
)


def bsdf_gallery():
    """Three steps of spheres under the studio; scene 1 is the furnace."""
    g = Gltf()
    ball = g.mesh("ball", g.primitive(sphere(0.42, 64, 32, tangents=True), g.material("placeholder")))
    step = g.mesh("step", g.primitive(rounded_box((7.6, 1.0, 1.0), 0.05, 4),
                                      g.material("plinth", (0.62, 0.6, 0.57), 0.0, 0.55)))
    ground = g.mesh("ground", g.primitive(floor(60.0), g.material("ground", (0.34, 0.35, 0.37), 0.0, 0.7)))
    nodes = []
    for j, row in enumerate(ROWS):
        height = 0.18 + 0.42 * j
        nodes.append(g.node(f"step {j}", mesh=step, translation=(0, height - 0.5, -1.0 * j)))
        for i, (name, bsdf) in enumerate(row):
            mesh = g.with_material(ball, g.material(name, bsdf=bsdf), name)
            nodes.append(g.node(name, mesh=mesh, translation=(1.02 * (i - 3), height + 0.42, -1.0 * j)))
    nodes.append(g.node("ground", mesh=ground))
    nodes.append(g.perspective("camera", (0.0, 3.6, 8.6), (0, 0.9, -0.9), 26.0))
    g.scene("gallery", *nodes)

    centres = [(1.0 * (i % 4) - 1.5, 1.0 - i // 4, 0.0) for i in range(len(LOSSLESS))]
    white = [g.node(name, mesh=g.with_material(ball, g.material(name, bsdf=bsdf), name), translation=centre)
             for (name, bsdf), centre in zip(LOSSLESS, centres)]
    g.scene("furnace", *white, g.orthographic("front", (0, 0, 5), (0, 0, 0), 2.0, 1.5))

    e = Expectations("what absorbs nothing cannot be seen in a white furnace, whatever its model")
    e.parity_options("--env", "0.5,0.6,0.8", "--max-depth", "4")
    view = View((0, 0, 5), (0, 0, 0), (96, 72), ymag=1.5)
    r = e.render("white furnace", view.size, "--scene", "1", "--env", "1,1,1", "--max-depth", "64", "--rr", "off",
                 spp=64, multiscatter=True)
    for (name, _), centre in zip(LOSSLESS, centres):
        r.region_mean(view.around(centre, 0.4 / 3), (1, 1, 1), 0.005, f"{name} gives back all that it gets")
    return g, e
