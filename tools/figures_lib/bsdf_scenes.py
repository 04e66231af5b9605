"""What figures of BSDFs are made from: `vkpt bsdf`, and one sphere under several lights."""
import functools
import json
import pathlib

import numpy as np

from make_scenes_lib.gltf import Gltf
from make_scenes_lib.png import Picture
from make_scenes_lib.shapes import floor, quad, sphere
from make_scenes_lib.vec import add, cross, normalize, scale, sub

from . import vkpt

STUDIO, LAMPS, FACING, SIDE, BARE = range(5)  # scenes of the file
FILL = 0.93  # of the half picture is the sphere's radius under the lights that are measured
SPP, SIZE = 64, 176


def checker():
    return Picture(2, 2, 3, lambda u, v: (0.62,) * 3 if (u < 0.5) == (v < 0.5) else (0.22,) * 3)


def lamp(towards):
    """A square of 0.8 m that faces the origin from 4.5 m away."""
    right = scale(normalize(cross((0, 1, 0), towards)), 0.8)
    up = scale(normalize(cross(towards, right)), 0.8)
    corner = sub(scale(normalize(towards), 4.5), scale(add(right, up), 0.5))
    return quad(corner, right, up).reversed()


def sphere_file(folder, quick):
    """Path of a glTF file: the sphere on a chequered floor in the studio, between a lamp before and one behind it, lit
    from the camera, lit from the side, and bare."""
    g = Gltf()
    ball = g.node("ball", mesh=g.mesh("ball", g.primitive(sphere(1.0, *((96, 48) if quick else (256, 128)),
                                                                 tangents=True), g.material("ball"))))
    tiles = g.texture_use(g.texture("tiles", checker(), filtering=9728))
    ground = floor(24.0, -1.0).with_uv(lambda u, v: (24 * u, 24 * v))
    plane = g.node("floor", mesh=g.mesh("floor", g.primitive(ground, g.material("floor", texture=tiles))))
    glow = g.light_material("lamp", (30.0,) * 3)
    lamps = [g.node(mesh=g.mesh("lamp", g.primitive(lamp(towards), glow)))
             for towards in ((-0.62, 0.55, 0.56), (0.82, 0.25, -0.52))]
    near = g.perspective("near", (0, 0.9, 6.2), (0, 0, 0), 22.0)
    flat = g.orthographic("flat", (0, 0, 5), (0, 0, 0), 1 / FILL, 1 / FILL)
    g.scene("studio", ball, plane, near)
    g.scene("lamps", ball, *lamps, near)
    for name, position in (("lit from the camera", (0, 0, 5)), ("lit from the side", (5, 0, 1.34))):
        g.scene(name, ball, flat, g.light(name, "directional", (1, 1, 1), np.pi, position, target=(0, 0, 0)))
    g.scene("bare", ball, flat)
    return write(folder, g)


def write(folder, gltf):
    folder = pathlib.Path(folder)
    for name, data in gltf.output().items():
        (folder / name).write_bytes(data)
    return folder / "scene.gltf"


def render(scene, size, spp, quick, *options):
    """On the CPU where it is to be quick: shaders of many models need seconds to compile."""
    backend = ["--backend", "cpu"] if quick else []
    return vkpt.render(scene.parent, scene, size, spp, "sobol", 0, *backend, *options)


def ball(scene, spec, which, quick, *options):
    """The sphere of the BSDF `spec`, linear radiance. Light reaches what is seen through glass by chance only."""
    size, spp = (40, 8) if quick else (SIZE, 4 * SPP if spec.startswith("dielectric") else SPP)
    return render(scene, size, spp, quick, "--scene", which, "--material", f"ball={spec}", *options)


def study(spec, *options):
    """The JSON of `vkpt bsdf`, with as few draws as it takes: figures do not use what draws say."""
    return json.loads(vkpt.run("bsdf", spec, "--json", "--draws", 1000, *options))


@functools.cache
def outside(spec):
    """What `vkpt bsdf` says of a BSDF seen from outside: `reciprocityError`, and `angles`, a row for every cosine."""
    return study(spec)["sides"][0]
