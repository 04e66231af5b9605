"""normal_map and negative_scale: tangent space, given, made and mirrored."""
import math

from .facts import Expectations
from .gltf import Gltf
from .measure import View, directional
from .png import Picture
from .shapes import Shape, floor, patch, quad, rounded_box, sphere
from .vec import add, axis_angle, cross, dot, normalize, scale


def from_height(size, height, strength):
    """Normal map of height(u, v), periodic; green points up the picture."""
    h = 0.5 / size

    def paint(u, v):
        du = (height(u + h, v) - height(u - h, v)) / (2 * h) * strength
        dv = (height(u, v + h) - height(u, v - h)) / (2 * h) * strength
        return tuple(0.5 + 0.5 * c for c in normalize((-du, dv, 1.0)))
    return Picture(size, size, 3, paint)


def studs(u, v):
    """Domes on a hexagonal grid, two rows a period."""
    best = 9.0
    for row in range(-1, 4):
        for column in range(-1, 3):
            x, y = column + 0.5 * (row % 2), 0.5 * row
            best = min(best, math.hypot(u - x, (v - y) * 0.8660254 * 1.1547))
    return math.sqrt(max(0.0, 1 - (best / 0.3) ** 2)) * 0.3 if best < 0.3 else 0.0


def weave(u, v):
    """Over-and-under ribbons."""
    x, y = u * 4, v * 4
    across, along = math.sin(math.pi * x) ** 2, math.sin(math.pi * y) ** 2
    return 0.06 * max(across * (0.6 + 0.4 * math.cos(math.pi * (y + math.floor(x) + 0.5))),
                      along * (0.6 - 0.4 * math.cos(math.pi * (x + math.floor(y) + 0.5))))


def normal_map():
    """Relief by normal maps, on planes with and without TANGENT, and on a ball. Scene 1 measures tilted normals."""
    g = Gltf()
    woven = g.texture_use(g.texture("weave", from_height(128, weave, 1.0)), scale=1.0)
    dotted = g.texture_use(g.texture("studs", from_height(96, studs, 1.0)), transform={"scale": (12, 6)})
    panel = quad((-0.85, -0.85, 0), (1.7, 0, 0), (0, 1.7, 0), tangents=True)
    bare = Shape(panel.positions, panel.normals, panel.uv0, panel.triangles)
    leather = g.material("woven, TANGENT given", (0.45, 0.2, 0.11), roughness=0.38, normal=woven)
    copy = g.material("woven, TANGENT made", (0.45, 0.2, 0.11), roughness=0.38, normal=woven)
    back = g.mesh("board", g.primitive(rounded_box((1.84, 1.84, 0.12), 0.04, 4),
                                       g.material("board", (0.16, 0.15, 0.15), roughness=0.4)))
    given, made = g.mesh("given", g.primitive(panel, leather)), g.mesh("made", g.primitive(bare, copy))
    ball = g.mesh("ball", g.primitive(sphere(0.9, 64, 32, tangents=True),
                                      g.material("studded", (0.95, 0.74, 0.42), 1.0, 0.26, normal=dotted)))
    nodes = [g.node("ball", mesh=ball, translation=(0, 0.9, 0))]
    for name, mesh, side in (("given", given, -1), ("made", made, 1)):
        turn = axis_angle((0, 1, 0), -24 * side)
        place = (1.95 * side, 0.93, -0.25)
        nodes += [g.node(name, mesh=mesh, translation=add(place, (-0.0271 * side, 0, 0.061)), rotation=turn),
                  g.node(mesh=back, translation=place, rotation=turn)]
    ground = g.mesh("ground", g.primitive(floor(50), g.material("ground", (0.4, 0.4, 0.41), roughness=0.5)))
    g.scene("relief", *nodes, g.node("ground", mesh=ground), g.perspective("camera", (0, 1.9, 7.2), (0, 0.84, 0),
                                                                           26.0))
    e = Expectations("shading normals of uniform normal maps, in closed form, with TANGENT given and made")
    e.parity_options("--env", "0.7,0.8,1", "--max-depth", "3")
    _tilted(g, e)
    return g, e


def _tilted(g, e):
    """Scene 1: six quads of one uniform normal map, whose frame the texture coordinates turn."""
    flat = Picture(4, 4, 3, lambda u, v: tuple(0.5 + 0.5 * c for c in normalize((0.45, 0.25, 0.9))))
    texture = g.texture("tilt", flat)
    texel = tuple(2 * c - 1 for c in flat.texel(0, 0))
    base, metallic, roughness = material = ((0.7, 0.6, 0.5), 0.3, 0.6)
    tile = quad((-0.45, -0.45, 0), (0.9, 0, 0), (0, 0.9, 0))
    turns = {"upright": (lambda u, v: (u, v), (1, 0, 0), 1), "turned": (lambda u, v: (v, 1 - u), (0, -1, 0), 1),
             "mirrored": (lambda u, v: (1 - u, v), (-1, 0, 0), -1)}
    travel, lux = (0.3, -0.5, -1.0), (3.0,) * 3
    view = View((0, 0, 5), (0, 0, 0), (96, 48), ymag=1.0)
    r = e.render("tilted normals", view.size, "--scene", "1", "--env", "none", "--max-depth", "1", spp=4)
    nodes, k = [], 0
    for normal_scale, given in ((1.0, True), (1.0, False), (0.5, True)):
        use = g.texture_use(texture, scale=normal_scale)
        shade = g.material(f"tilted, scale {normal_scale:g}, tangents {'given' if given else 'made'}", base, metallic,
                           roughness, normal=use)
        for name, (change, tangent, hand) in turns.items():
            if normal_scale < 1 and name == "turned":
                continue
            shape = tile.with_uv(change)
            if given:
                shape.tangents = [tangent + (hand,)] * 4
            centre = (k % 4 - 1.5, 0.5 - k // 4, 0.0)
            k += 1
            nodes.append(g.node(name, mesh=g.mesh(f"tilted {k}", g.primitive(shape, shade)), translation=centre))
            bitangent = scale(cross((0, 0, 1), tangent), hand)
            ns = normalize(add(add(scale(tangent, texel[0] * normal_scale),
                                   scale(bitangent, texel[1] * normal_scale)), (0, 0, texel[2])))
            value = directional(material, centre, ns, (0, 0, 1), travel, lux)
            r.region_mean(view.around(centre, 0.18), value, 0.003,
                          f"{name} texture frame, tangents {'given' if given else 'made'}, scale {normal_scale:g}")
    g.scene("tilted", *nodes, g.light("sun", "directional", (1, 1, 1), 3, scale(travel, -3.0), target=(0, 0, 0)),
            g.orthographic("front", (0, 0, 5), (0, 0, 0), 2.0, 1.0))


# ---- negative_scale ----

def shell():
    """A spiral shell that winds to one side, about 1.5 m high."""
    def centre(v):
        t = 0.02 + 0.98 * v
        phi, grow = 2 * math.pi * 3.1 * t, 0.72 * math.exp(2.6 * (t - 1))
        return (grow * math.cos(phi), 1.55 - 2.1 * grow, grow * math.sin(phi))

    def surface(u, v):
        h = 1e-3
        along = normalize(tuple(b - a for a, b in zip(centre(v - h), centre(v + h))))
        outward = centre(v)
        outward = normalize((outward[0], 0.0, outward[2]))
        outward = normalize(tuple(o - a * dot(outward, along) for o, a in zip(outward, along)))
        up = cross(along, outward)
        r = 0.64 * 0.72 * math.exp(2.6 * (0.02 + 0.98 * v - 1)) + 0.004
        phi = -2 * math.pi * u
        ridge = 1 + 0.1 * math.exp(-((u - 0.3) / 0.05) ** 2)
        return add(centre(v), add(scale(outward, r * ridge * math.cos(phi)), scale(up, r * ridge * math.sin(phi))))
    return surface


def negative_scale():
    """A shell and its mirror image by a negative scale: everything must mirror, the normal map included."""
    g = Gltf()
    def ridges(u, v):
        return 0.05 * abs(math.sin(2 * math.pi * (v + 0.25 * math.sin(2 * math.pi * u)))) ** 0.7
    ribs = g.texture("ribs", from_height(64, ridges, 1.0))
    glaze = Picture(64, 64, 3, lambda u, v: tuple(a + (b - a) * (0.5 + 0.5 * math.sin(2 * math.pi * (2 * v + u))) ** 3
                                                    for a, b in zip((0.97, 0.9, 0.8), (0.75, 0.36, 0.26))))
    body = patch(shell(), 40, 200).with_uv(lambda u, v: (u, 10 * v * (1.4 - 0.4 * v)))
    pearl = g.material("pearl", roughness=0.3, texture=g.texture_use(g.texture("glaze", glaze)),
                       normal=g.texture_use(ribs, scale=0.7), doubleSided=True)
    mesh = g.mesh("shell", g.primitive(body, pearl))
    turn = axis_angle((0, 1, 0), 35)
    mirrored = axis_angle((0, 1, 0), -35)
    ground = g.mesh("ground", g.primitive(floor(50), g.material("sand", (0.62, 0.55, 0.45), roughness=0.8)))
    pair = [g.node("shell", mesh=mesh, translation=(1.3, 0.5, 0), rotation=turn),
            g.node("mirrored shell", mesh=mesh, translation=(-1.3, 0.5, 0), rotation=mirrored, scale=(-1, 1, 1))]
    g.scene("shells", *pair, g.node("ground", mesh=ground), g.perspective("camera", (0, 2.6, 7.6), (0, 0.78, 0),
                                                                          27.0))
    g.scene("lit from the middle", *pair, g.light("bulb", "point", (1, 0.9, 0.8), 60, (0, 3.0, 4.0)),
            g.perspective("front", (0, 2.6, 7.6), (0, 0.9, 0), 27.0))
    e = Expectations("a mesh under a negative scale is the exact mirror image")
    e.parity_options("--env", "0.8,0.8,0.8", "--max-depth", "3")
    r = e.render("lit from the middle", (96, 54), "--scene", "1", "--env", "none", "--max-depth", "1", "--background",
                 "transparent", spp=32)
    r.mirror_symmetry("x", [12, 9], 0.004, "the scene is its own mirror image in x = 0")
    r.increasing([[0, 0.125, 0, 0.25], [0.25, 0.375, 0.25, 0.5]], "there is a shell to compare")
    r = e.render("uniform environment", (64, 36), "--scene", "1", "--env", "1,1,1", "--max-depth", "2", spp=32)
    r.mirror_symmetry("x", [8, 6], 0.01, "the scene is its own mirror image in x = 0")
    return g, e
