"""Section on levels of detail: a height field of mirror triangles beside the BRDF of its slopes."""
import pathlib
import tempfile

import matplotlib.pyplot as plt
import numpy as np

from make_scenes_lib.gltf import Gltf
from make_scenes_lib.shapes import Shape, floor

from . import bsdf_scenes as scenes
from .bsdf_pictures import sheet
from .page import Section, figure
from .renders import picture, shown

FACETS, BRDF = range(2)  # scenes of the file
REACH = 20  # tiles each way
BUMP = 3.0  # cells: heights are correlated as exp(-(distance / BUMP)^2)
LAMP_ANGLE, LAMP_RADIUS = 50.0, 6.0  # degrees from the normal, of the disk
WHITE = {"model": "conductor", "eta": 0.01, "k": 20}


def gaussian_heights(cells):
    """A periodic Gaussian random field on cells x cells points."""
    frequency = 2 * np.pi * np.fft.fftfreq(cells)
    amplitude = np.exp(-BUMP ** 2 * (frequency[:, None] ** 2 + frequency ** 2) / 8)
    noise = np.random.default_rng(3).standard_normal((cells, cells))
    return np.fft.ifft2(np.fft.fft2(noise) * amplitude).real


def slopes(heights):
    """Of both triangles of every cell, along x and along z, in heights a cell."""
    right, down = np.roll(heights, -1, 1), np.roll(heights, -1, 0)
    corner = np.roll(right, -1, 0)
    return np.stack([right - heights, corner - down]), np.stack([down - heights, corner - right])


def tile(cells, alpha):
    """One square metre whose slopes have the variance alpha^2 / 2 each way, which is Beckmann's. [Walter 07]"""
    heights = gaussian_heights(cells)
    variance = np.mean([np.mean(s ** 2) for s in slopes(heights)])
    heights *= alpha / np.sqrt(2 * variance) / cells
    z, x = np.mgrid[:cells + 1, :cells + 1]
    y = heights[z % cells, x % cells]
    points = np.stack([x / cells - 0.5, y, z / cells - 0.5], 2).reshape(-1, 3)
    a = (z * (cells + 1) + x)[:-1, :-1].ravel()
    b, c, d = a + 1, a + cells + 1, a + cells + 2
    triangles = np.concatenate([np.stack([a, c, b], 1), np.stack([b, c, d], 1)])
    return Shape(positions=points.tolist(), triangles=triangles.tolist())


def surface_file(folder, cells, alpha, angles):
    """Path of a glTF file: many tiles of mirror triangles, and a plane in their place; a camera for every angle that
    sees exactly one tile."""
    folder.mkdir()
    g = Gltf()
    mesh = g.mesh("facets", g.primitive(tile(cells, alpha), g.material("facets", bsdf={"model": "mirror"})))
    places = range(-REACH, REACH + 1)
    tiles = [g.node(mesh=mesh, translation=(x, 0, z)) for x in places for z in places]
    rough = g.material("statistics", bsdf=WHITE | {"distribution": "beckmann", "alpha": alpha})
    plane = g.node("plane", mesh=g.mesh("plane", g.primitive(floor(REACH), rough)))
    cameras = []
    for angle in angles:
        theta = np.radians(angle)
        eye = (0.0, float(8 * np.cos(theta)), float(8 * np.sin(theta)))
        up = (0.0, float(np.sin(theta)), float(-np.cos(theta)))
        cameras.append(g.orthographic(f"{angle:g}", eye, (0, 0, 0), 0.5, 0.5 * float(np.cos(theta)), up))
    g.scene("facets", *tiles, *cameras)
    g.scene("statistics", plane, *cameras)
    return scenes.write(folder, g)


def write_sky(path, lamp, sky, radius=LAMP_RADIUS):
    """A disk of radiance `lamp` beyond -Z, LAMP_ANGLE from the zenith, on a sky that grows lighter downwards, `sky` at
    the horizon; equirectangular, as Radiance's RGBE."""
    height = 256
    v, u = (np.mgrid[:height, :2 * height] + 0.5) / [[[height]], [[2 * height]]]
    phi, theta = 2 * np.pi * (u - 0.5), np.pi * v
    tilt = np.radians(LAMP_ANGLE)
    towards = -np.sin(theta) * np.sin(phi) * np.sin(tilt) + np.cos(theta) * np.cos(tilt)
    color = np.array(sky) * (0.3 + 0.7 * np.sin(theta)[..., None] ** 4)
    color = np.where(towards[..., None] > np.cos(np.radians(radius)), lamp, color)
    mantissa, exponent = np.frexp(np.maximum(color.max(2), 1e-9))
    texels = np.concatenate([color * (256 * mantissa / np.maximum(color.max(2), 1e-9))[..., None],
                             (exponent + 128)[..., None]], 2)
    header = f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {height} +X {2 * height}\n"
    path.write_bytes(header.encode() + np.floor(texels).astype(np.uint8).tobytes())
    return path


# ---- from near and from afar ------------------------------------------------------------------------------------

VIEWED_ALPHA = 0.12
DISTANCES = (0.1, 0.5, 14.0)


def seen_from(scene, which, distance, sky, quick):
    angle = np.radians(LAMP_ANGLE)
    eye = distance * np.cos(angle), distance * np.sin(angle)
    size, spp = (40, 8) if quick else (scenes.SIZE, 2 * scenes.SPP)
    return scenes.render(scene, size, spp, quick, "--scene", which, "--eye", f"0,{eye[0]:.5f},{eye[1]:.5f}", "--target",
                         "0,0,0", "--fov", 40, "--env", sky)


def views(folder, cells, quick):
    scene = surface_file(folder / "views", cells, VIEWED_ALPHA, ())
    sky = write_sky(folder / "sky.hdr", 4.0, (0.3, 0.45, 0.7))
    plot, axes = sheet(2, len(DISTANCES), ("mirror triangles", "BRDF of their slopes"))
    for which, line in zip((FACETS, BRDF), axes):
        for axis, distance in zip(line, DISTANCES):
            picture(axis, shown(0.6 * seen_from(scene, which, distance, sky, quick)),
                    f"from {distance:g} m" if which == FACETS else "")
    return plot


# ---- the lobe ---------------------------------------------------------------------------------------------------

SERIES = (("once", "off", "--max-depth 1", "#0072b2"), ("all reflections", "on", "--max-depth 16 --rr off", "#d55e00"))


def lobe(scene, sky, which, angles, quick, *options):
    """Mean radiance of a tile from every angle."""
    size, spp = (16, 128) if quick else (16, 1024)
    return [scenes.render(scene, size, spp, quick, "--scene", which, "--camera", f"{angle:g}", "--env", sky,
                          *options).mean() for angle in angles]


def lobes(axis, scene, sky, angles, quick):
    """Draws the radiance of both surfaces. For every series the rms of their difference over that of the BRDF."""
    misses = []
    for name, multiscatter, depth, color in SERIES:
        facets = np.array(lobe(scene, sky, FACETS, angles, quick, *depth.split()))
        brdf = np.array(lobe(scene, sky, BRDF, angles, quick, "--multiscatter", multiscatter, "--max-depth", 1))
        misses.append(np.sqrt(np.sum((facets - brdf) ** 2) / np.sum(brdf ** 2)))
        axis.plot(angles, facets, "o", ms=4, color=color, label=f"triangles, {name}")
        axis.plot(angles, brdf, color=color, lw=1.3, label=f"BRDF, multiscatter {multiscatter}")
    axis.axvline(LAMP_ANGLE, color="#bbb", lw=0.8, zorder=0)
    return misses


def levels_of_detail(quick):
    cells, alphas = (160, (0.5,)) if quick else (384, (0.2, 0.7))
    angles = (-20, 20, 50) if quick else (*range(-75, 30, 15), *range(30, 80, 5))
    plot, axes = plt.subplots(1, len(alphas), figsize=(5.4 * len(alphas), 3.8), squeeze=False)
    misses = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        lamp = write_sky(folder / "lamp.hdr", 40.0, (0, 0, 0))
        for axis, alpha in zip(axes[0], alphas):
            scene = surface_file(folder / f"{alpha}", cells, alpha, angles)
            misses.append(lobes(axis, scene, lamp, angles, quick))
            axis.set(xlabel="viewing angle, degrees", title=f"α = {alpha}", ylim=(0, None))
        pictures = views(folder, cells, quick)
    axes[0][0].set_ylabel("radiance, nits")
    axes[0][0].legend(fontsize=7, loc="upper left")
    plot.tight_layout()
    apart = "; ".join(f"α = {alpha}: {one:.1%} and {every:.1%}" for alpha, (one, every) in zip(alphas, misses))
    return Section("Levels of detail",
                   "Up close the surface is geometry: mirror triangles, a random height field of Gaussian slopes. From "
                   "afar a pixel averages thousands, and the conductor whose Beckmann distribution has their slopes, "
                   "α = √2 times their root mean square, gives the same picture. Below, the radiance of a tile against "
                   f"the viewing angle, a lamp {LAMP_ANGLE:g}° from the normal on the other side: rough surfaces are "
                   "brightest beyond the mirror direction (grey), as Torrance and Sparrow explained. Light that leaves "
                   "after one reflection is what a model of single scattering has. The lobe of --multiscatter on has "
                   "the energy of the rest, but spreads it, where facets send it on forwards. Difference from the "
                   f"BRDF, root mean square over all angles, of light reflected once and of all: {apart}.",
                   figure(pictures) + figure(plot))


SECTIONS = [levels_of_detail]
