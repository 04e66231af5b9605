"""Sections of pictures of BSDFs: one sphere, many models."""
import tempfile

import matplotlib.pyplot as plt
import numpy as np

from . import bsdf_scenes as scenes
from .bsdf_scenes import outside
from .page import Section, figure, table
from .renders import picture, shown

CELL = 2.14  # inches a picture and what is between two: SIZE pixels are shown as as many
STUDIO_EXPOSURE = 0.6


def sheet(rows, columns, labels=()):
    """Axes of a grid of square pictures; `labels` stand left of its rows."""
    plot, axes = plt.subplots(rows, columns, figsize=(CELL * columns, CELL * rows), squeeze=False)
    plot.subplots_adjust(wspace=0.04, hspace=0.04)
    for line, label in zip(axes, labels):
        line[0].text(-0.06, 0.5, label, transform=line[0].transAxes, rotation=90, ha="right", va="center", fontsize=9)
    return plot, axes


def fill(axes, entries, scene, which, quick, *options, exposure=1.0, titled=True):
    """A row of spheres: entries are (title, SPEC)."""
    for axis, (title, spec) in zip(axes, entries):
        picture(axis, shown(exposure * scenes.ball(scene, spec, which, quick, *options)), title if titled else "")


def under_both_lights(entries, quick):
    """A row in the studio and one between two lamps; of single scattering, as the formulas of the lecture are."""
    with tempfile.TemporaryDirectory() as folder:
        scene = scenes.sphere_file(folder, quick)
        plot, axes = sheet(2, len(entries), ("studio", "two small lamps"))
        fill(axes[0], entries, scene, scenes.STUDIO, quick, "--multiscatter", "off", exposure=STUDIO_EXPOSURE)
        fill(axes[1], entries, scene, scenes.LAMPS, quick, "--multiscatter", "off", titled=False)
    return figure(plot)


METALS = (("copper", "Cu"), ("iron", "Fe"), ("gold", "Au"), ("mercury", "Hg"))
DIELECTRICS = (("glass", "glass"), ("diamond", "diamond"))


def materials(alpha):
    return ([(name, f"conductor:metal={metal},alpha={alpha}") for name, metal in METALS] +
            [(name, f"dielectric:ior={ior},alpha={alpha}") for name, ior in DIELECTRICS])


def conductors_and_dielectrics(quick):
    with tempfile.TemporaryDirectory() as folder:
        scene = scenes.sphere_file(folder, quick)
        plot, axes = sheet(2, 6, ("smooth", "rough, α = 0.15"))
        for line, alpha in zip(axes, (0, 0.15)):
            fill(line, materials(alpha), scene, scenes.STUDIO, quick, exposure=STUDIO_EXPOSURE, titled=alpha == 0)
    return Section("Conductors against dielectrics, smooth against rough",
                   "A conductor absorbs what it does not reflect; its complex index of refraction gives the colour. A "
                   "dielectric transmits it: the floor is seen through the sphere, upside down. Roughness scatters "
                   "both about the directions of the smooth surface.", figure(plot))


# All of one width: Beckmann's alpha 0.25 has e = 2/alpha^2 - 2 = 30 about the half vector, a quarter of it about the
# mirror direction, whose angle is twice the half vector's. All reflect gold's colour along the normal.
WIDTH, GOLD = 0.25, "1/0.78/0.34"
LOBES = (("Phong, e = 7.5", f"phong:color={GOLD},exponent=7.5"),
         ("Blinn-Phong, e = 30", f"blinn_phong:color={GOLD},exponent=30"),
         ("Cook-Torrance", f"cook_torrance:metal=Au,alpha={WIDTH},weight=1,specular=1,diffuse=0,color=1"),
         ("Beckmann", f"conductor:metal=Au,alpha={WIDTH},distribution=beckmann"),
         ("GGX", f"conductor:metal=Au,alpha={WIDTH}"))
PAPER = (("copper plastic, 1981", "cook_torrance:preset=copper_plastic"),
         ("copper, 1981", "cook_torrance:preset=copper"))


def from_phong_to_ggx(quick):
    return Section("From Phong to GGX",
                   "Five models of gold whose highlights are about as wide: exponents and roughness are those of one "
                   "Gaussian of slopes, α = 0.25. Where light grazes (the lamp behind, on the right) Phong's lobe is "
                   "as wide as elsewhere and wraps round the rim; a half vector's grows narrow sideways, like lights on "
                   "a wet road. Facets add Fresnel's rise and masking; GGX has a narrow peak and a long tail. The last "
                   "two are the presets for the lecture's pictures of Cook and Torrance.",
                   under_both_lights(LOBES + PAPER, quick))


STRETCHES = (("GGX\n0.2, 0.2", "conductor:metal=Al,alpha=0.2"),
             ("GGX\n0.05, 0.4", "conductor:metal=Al,alpha=0.05/0.4"),
             ("GGX\n0.4, 0.05", "conductor:metal=Al,alpha=0.4/0.05"),
             ("Beckmann\n0.05, 0.4", "conductor:metal=Al,alpha=0.05/0.4,distribution=beckmann"),
             ("Ashikhmin-Shirley\n50, 50", "ashikhmin_shirley:color=0.3,diffuse=0.1/0.02/0.02,exponent=50/50"),
             ("Ashikhmin-Shirley\n1000, 10", "ashikhmin_shirley:color=0.3,diffuse=0.1/0.02/0.02,exponent=1000/10"))


def isotropic_and_anisotropic(quick):
    return Section("Isotropic against anisotropic",
                   "The first number is the roughness along the parallels of the sphere, the second along its "
                   "meridians; Ashikhmin and Shirley give exponents, which are large where a surface is smooth. A "
                   "highlight is long across the grooves. Theirs lies over a diffuse base.",
                   under_both_lights(STRETCHES, quick))


DIFFUSE = (("Lambert", "lambert:color=0.8", "#000000"),
           ("Oren-Nayar, σ = 0.5", "oren_nayar:color=0.8,sigma=0.5", "#0072b2"),
           ("Oren-Nayar, σ = 1", "oren_nayar:color=0.8,sigma=1", "#56b4e9"),
           ("EON, r = 0.5", "eon:color=0.8,roughness=0.5", "#d55e00"),
           ("EON, r = 1", "eon:color=0.8,roughness=1", "#e69f00"))
COSINES = (1.0, 0.7, 0.3, 0.1)
LIGHTS = ((scenes.FACING, "from the camera"), (scenes.SIDE, "from 75° aside"))


def profile(image):
    """Radiance along the equator against the place on the disk, -1 to 1."""
    size = image.shape[1]
    rows = image[size // 2 - 1:size // 2 + 1].mean(axis=(0, 2))
    place = ((np.arange(size) + 0.5) / size * 2 - 1) / scenes.FILL
    inside = np.abs(place) < 0.98  # at the rim pixels are partly empty
    return place[inside], rows[inside]


def white():
    """Energy that the white surface reflects, by `vkpt bsdf`."""
    rows = []
    for title, spec, _ in DIFFUSE:
        at = {round(a["cosine"], 3): a["energy"] for a in outside(spec.replace("0.8", "1"))["angles"]}
        rows.append([title] + [f"{at[c]:.3f}" for c in COSINES])
    return rows


def oren_nayar(quick):
    plot, axes = sheet(2, len(DIFFUSE), ("lit from the camera", "lit from the side"))
    curves, lines = plt.subplots(1, 2, figsize=(10.4, 3.4))
    with tempfile.TemporaryDirectory() as folder:
        scene = scenes.sphere_file(folder, quick)
        for row, line, (which, name) in zip(axes, lines, LIGHTS):
            for axis, (title, spec, color) in zip(row, DIFFUSE):
                image = scenes.ball(scene, spec, which, quick, "--max-depth", 1)
                picture(axis, shown(image), title if which == scenes.FACING else "")
                line.plot(*profile(image), color=color, lw=1.4, label=title)
            line.set(xlabel="place on the equator", ylabel="radiance, nits", title=f"lit {name}", ylim=(0, None))
    lines[0].legend(fontsize=8)
    curves.tight_layout()
    return Section("Oren-Nayar against Lambert",
                   "Facets that are Lambertian, not mirrors. They make the full moon flat: at its rim the eye sees the "
                   "facets that the light meets squarely. The table: what white surfaces reflect, by cosine; the full "
                   "model of 1994 loses energy, EON is built to keep it.",
                   figure(plot) + figure(curves) + table(["of white", *(f"cosine {c}" for c in COSINES)], white()))


SECTIONS = [conductors_and_dielectrics, from_phong_to_ggx, isotropic_and_anisotropic, oren_nayar]
