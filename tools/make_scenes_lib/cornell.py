"""cornell_box and mis_plates: the two classics."""
from .facts import Expectations
from .gltf import Gltf
from .measure import View, meet_plane, quad_light, sphere_light
from .shapes import merged, quad, sphere
from .vec import add, cross, dot, normalize, scale, sub

# ---- cornell_box: dimensions as measured at Cornell, in metres. ----

WHITE, RED, GREEN = (0.73, 0.71, 0.68), (0.62, 0.062, 0.05), (0.13, 0.44, 0.09)
LIGHT = (44.0, 34.0, 23.0)
WIDTH, HEIGHT, DEPTH = 0.5528, 0.5488, 0.5592
SHORT = ((0.130, 0.065), (0.082, 0.225), (0.240, 0.272), (0.290, 0.114), 0.165)
TALL = ((0.423, 0.247), (0.265, 0.296), (0.314, 0.456), (0.472, 0.406), 0.330)


def _place(x, y, z):
    """Cornell's coordinates (camera towards +z, x to the left) to glTF's, the box centred on the z axis."""
    return (WIDTH / 2 - x, y, -z)


def _prism(corners_and_height):
    *corners, height = corners_and_height
    low = [_place(x, 0.0, z) for x, z in corners]
    high = [_place(x, height, z) for x, z in corners]
    middle = scale(add(add(low[0], low[1]), add(low[2], low[3])), 0.25)
    top = quad(high[0], sub(high[1], high[0]), sub(high[3], high[0]))
    top.positions[:] = high
    sides = [_facing(top, (0, 1, 0))]
    for i in range(4):
        j = (i + 1) % 4
        side = quad(low[i], sub(low[j], low[i]), (0, height, 0))
        sides.append(_facing(side, sub(scale(add(low[i], low[j]), 0.5), middle)))
    return merged(*sides)


def _facing(side, outward):
    return side if dot(side.normals[0], outward) > 0 else side.reversed()


def cornell_box():
    """The Cornell box with its two blocks."""
    g = Gltf()
    white = g.material("white", WHITE, 0.0, 1.0)
    near, far = _place(0, 0, 0)[2], _place(0, 0, DEPTH)[2]
    left, right = WIDTH / 2 - 0.5528, WIDTH / 2
    deep, wide, tall = (0, 0, far - near), (right - left, 0, 0), (0, HEIGHT, 0)
    walls = merged(quad((left, 0, near), wide, deep), quad((left, HEIGHT, far), wide, scale(deep, -1.0)),
                   quad((left, 0, far), wide, tall))
    parts = {
        "walls": (walls, white),
        "red wall": (quad((left, 0, near), deep, tall), g.material("red", RED, 0.0, 1.0)),
        "green wall": (quad((right, 0, far), scale(deep, -1.0), tall), g.material("green", GREEN, 0.0, 1.0)),
        "short block": (_prism(SHORT), white),
        "tall block": (_prism(TALL), white),
    }
    light_corner = _place(0.343, HEIGHT - 0.0005, 0.227)
    light_right, light_up = (0.130, 0, 0), (0, 0, -0.105)
    lamp = quad(add(light_corner, light_up), light_right, scale(light_up, -1.0))
    parts["light"] = (lamp, g.light_material("light", LIGHT))
    nodes = [g.node(name, mesh=g.mesh(name, g.primitive(shape, material)))
             for name, (shape, material) in parts.items()]
    eye, target = (0.0, 0.2744, 0.8), (0.0, 0.2744, 0.0)
    g.scene("cornell box", *nodes, g.perspective("camera", eye, target, 37.9, 1.0))

    e = Expectations("direct light on floor and walls by quadrature; colours bleed from the walls", "diffuse")
    e.parity_options("--max-depth", "5")
    view = View(eye, target, (64, 64), degrees=37.9)
    r = e.render("direct light", view.size, "--max-depth", "1", spp=16)
    face = scale(light_up, -1.0)
    for base, point, normal, why in (
            (WHITE, (-0.17, 0.0, -0.05), (0, 1, 0), "the floor in front of the blocks"),
            (RED, (left, 0.3, -0.12), (1, 0, 0), "the red wall"),
            (GREEN, (right, 0.3, -0.12), (-1, 0, 0), "the green wall"),
            (WHITE, (0.15, 0.45, far), (0, 0, 1), "the back wall")):
        def radiance(origin, direction):
            p = meet_plane(origin, direction, point, normal)
            return quad_light((base, 0.0, 1.0), p, normal, scale(direction, -1), add(light_corner, light_up),
                              light_right, face, LIGHT)
        rect = view.around(point, 0.014)
        r.region_mean(rect, view.average(rect, radiance, 4), 0.01,
                      f"direct light of the lamp on {why}, by quadrature")
    lamp_view = view.around((0.0, HEIGHT, -0.2795), 0.03, 0.008)
    r.region_mean(lamp_view, LIGHT, 0.002, "the lamp itself shows its radiance")
    r = e.render("emission alone", view.size, "--max-depth", "0", spp=4)
    r.max_below([0.0, 1.0, 0.3, 1.0], 0.0, "nothing but the lamp emits")
    r = e.render("global light", view.size, "--max-depth", "6", spp=16)
    r.increasing([view.around((0.05, HEIGHT, -0.05), 0.02, 0.01), view.around((-0.17, 0.0, -0.05), 0.02)],
                 "the ceiling gets light at second hand, less than the floor")
    r.max_below([0.0, 1.0, 0.3, 1.0], 8.0, "no pixel away from the lamp nears its radiance")
    return g, e


# ---- mis_plates: after the scene of [Veach 97, fig. 9.2]. ----

PLATE_ROUGHNESS = (0.09, 0.17, 0.28, 0.42)
LIGHT_RADII = (0.05, 0.16, 0.45, 1.0)
LIGHT_X = (-4.2, -1.7, 1.0, 4.3)
LIGHT_COLORS = ((1.0, 0.62, 0.38), (1.0, 0.83, 0.6), (0.72, 0.86, 1.0), (0.5, 0.68, 1.0))
STEEL = (0.86, 0.85, 0.83)
POWER = 12.0  # radiance x radius^2 of every lamp
EYE, AIM, FOV = (0.0, 3.4, 17.0), (0.0, 2.25, 0.0), 27.5


def mis_plates():
    """Four plates of rising roughness mirror four lamps of equal power and rising size."""
    g = Gltf()
    nodes, planes = [], []
    lamps_middle = (0.0, 4.9, -2.2)
    for i, roughness in enumerate(PLATE_ROUGHNESS):
        centre = (0.0, 0.12 + 0.4 * (3 - i) ** 1.3, 5.2 - 1.8 * (3 - i))
        normal = normalize(add(normalize(sub(EYE, centre)), normalize(sub(lamps_middle, centre))))
        back = normalize(cross((1, 0, 0), normal))  # up the plate
        corner = sub(centre, add((5.2, 0, 0), scale(back, 0.8)))
        plate = quad(corner, (10.4, 0, 0), scale(back, 1.6))
        material = g.material(f"steel, roughness {roughness:g}", STEEL, 1.0, roughness, doubleSided=True)
        nodes.append(g.node(f"plate {i}", mesh=g.mesh(f"plate {i}", g.primitive(plate, material))))
        planes.append((centre, normal, roughness))
    lamps = []
    for i, (x, radius, color) in enumerate(zip(LIGHT_X, LIGHT_RADII, LIGHT_COLORS)):
        luminance = dot(color, (0.2126, 0.7152, 0.0722))
        radiance = scale(color, POWER / (radius * radius * luminance * 4))
        columns = (12, 16, 24, 32)[i]
        facets = columns, columns // 2
        lamp = sphere(radius, *facets)
        centre = (x, lamps_middle[1], lamps_middle[2])
        nodes.append(g.node(f"lamp {i}", mesh=g.mesh(f"lamp {i}",
                                                     g.primitive(lamp, g.light_material(f"lamp {i}", radiance))),
                            translation=centre))
        lamps.append((centre, radius, radiance))
    grey = g.material("backdrop", (0.35, 0.35, 0.37), 0.0, 0.9)
    room = merged(quad((-16, -0.4, 18), (32, 0, 0), (0, 0, -23)), quad((-16, -0.4, -5), (32, 0, 0), (0, 14, 0)))
    nodes.append(g.node("backdrop", mesh=g.mesh("backdrop", g.primitive(room, grey))))
    g.scene("plates", *nodes, g.perspective("camera", EYE, AIM, FOV))

    e = Expectations("lamps of equal power in rough mirrors: both sampling strategies are needed, and must agree")
    e.parity_options("--max-depth", "2")
    view = View(EYE, AIM, (128, 72), degrees=FOV)
    r = e.render("direct light", view.size, "--max-depth", "1", spp=32)
    for centre, radius, radiance in lamps[2:]:
        rect = view.around(centre, 0.012, 0.02)
        r.region_mean(rect, radiance, 0.001, "a lamp shows its radiance")
    for (centre, normal, roughness), x in ((planes[3], 0.0), (planes[3], 3.0), (planes[2], 0.66)):
        def reflection(origin, direction):
            p = meet_plane(origin, direction, centre, normal)
            total = (0.0, 0.0, 0.0)
            for lamp in lamps:
                total = add(total, sphere_light((STEEL, 1.0, roughness), p, normal, scale(direction, -1), *lamp,
                                                steps=20))
            return total
        rect = view.around(add(centre, (x, 0, 0)), 0.06, 0.02)
        r.region_mean(rect, view.average(rect, reflection, 4), 0.03,
                      f"all four lamps in the plate of roughness {roughness:g}, by quadrature over their cones")
    return g, e
