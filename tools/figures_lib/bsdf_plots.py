"""Sections of measured curves of BSDFs: what microfacets are made of, and what becomes of the energy."""
import functools
import tempfile

import matplotlib.pyplot as plt
import numpy as np

from . import bsdf_scenes as scenes
from .bsdf_pictures import fill, sheet
from .bsdf_scenes import outside, study
from .page import Section, figure, table

WHITE = "eta=0.01,k=20"  # a metal that reflects 99.99 % at all angles
COLORS = {"ggx": "#0072b2", "beckmann": "#d55e00", "phong": "#009e73"}


@functools.cache
def facets(spec):
    return {name: np.array(values) for name, values in study(spec, "--facets")["facets"].items()}


def distributions(_quick):
    plot, axes = plt.subplots(1, 3, figsize=(12.6, 3.7))
    for name, color in COLORS.items():
        for alpha, style in ((0.2, "-"), (0.5, "--"), (0.8, ":")):
            f = facets(f"torrance_sparrow:alpha={alpha},distribution={name}")  # which needs no table of its albedo
            tilt = f["degrees"] >= 0
            label = f"{name}, α = {alpha}"
            axes[0].plot(f["degrees"][tilt], f["D"][tilt], color=color, ls=style, lw=1.3, label=label)
            axes[1].semilogy(f["degrees"][tilt], f["D"][tilt], color=color, ls=style, lw=1.3)
    along = (facets(f"torrance_sparrow:distribution=ggx,alpha={a}") for a in ("0.2/0.8", "0.8/0.2"))
    for f, label in zip(along, ("along α = 0.2", "along α = 0.8")):
        axes[2].plot(f["degrees"], f["D"], label=label, lw=1.3)
    axes[0].set(xlabel="tilt of the facet, degrees", ylabel="D", title="D", xlim=(0, 90), ylim=(0, None))
    axes[1].set(xlabel="tilt of the facet, degrees", title="D, logarithmic: the tails", xlim=(0, 90), ylim=(1e-5, 20))
    axes[2].set(xlabel="tilt of the facet, degrees", title="ggx, anisotropic 0.2, 0.8", xlim=(-90, 90), ylim=(0, None))
    axes[0].legend(fontsize=7)
    axes[2].legend(fontsize=8)
    plot.tight_layout()
    return Section("The distribution of facets, D",
                   "Density of facets over solid angle, such that D times the cosine integrates to 1. Beckmann's "
                   "slopes are Gaussian, and phong's exponent is matched to them; GGX has the same height at the "
                   "normal and a tail that the others lack.", figure(plot))


MASKINGS = (("Smith, correlated", "conductor:alpha={},distribution={}", "-"),
            ("Smith, separable", "conductor:alpha={},distribution={},masking=smith_separable", "--"))


def masking(_quick):
    plot, axes = plt.subplots(1, 3, figsize=(12.6, 3.7))
    for alpha, width in ((0.2, 0.9), (0.5, 1.5), (0.8, 2.1)):
        for name in ("ggx", "beckmann"):
            f = facets(f"conductor:alpha={alpha},distribution={name}")
            tilt = f["degrees"] >= 0
            axes[0].plot(f["degrees"][tilt], f["G1"][tilt], color=COLORS[name], lw=width,
                         label=f"{name}, α = {alpha}")
    for name in ("ggx", "beckmann"):
        for label, spec, style in MASKINGS:
            f = facets(spec.format(0.5, name))
            tilt = f["degrees"] >= 0
            axes[1].plot(f["degrees"][tilt], f["G2"][tilt], color=COLORS[name], ls=style, label=f"{name}: {label}")
            axes[2].plot(f["degrees"], f["G2From60"], color=COLORS[name], ls=style)
    f = facets("torrance_sparrow:alpha=0.5")
    tilt = f["degrees"] >= 0
    axes[1].plot(f["degrees"][tilt], f["G2"][tilt], color="#444", lw=1.3, label="V-grooves")
    axes[2].plot(f["degrees"], f["G2From60"], color="#444", lw=1.3)
    axes[2].axvline(-60, color="#bbb", lw=0.8, zorder=0)
    axes[2].text(-58, 0.04, "ωo", color="#777")
    axes[0].set(xlabel="angle of the direction, degrees", title="G1, Smith", xlim=(0, 90), ylim=(0, 1.03))
    axes[1].set(xlabel="angle of ωo and of its mirror image, degrees", title="G of a mirrored pair, α = 0.5",
                xlim=(0, 90), ylim=(0, 1.03))
    axes[2].set(xlabel="angle of ωi, degrees; ωo is at −60", title="G, α = 0.5, ωo fixed", xlim=(-90, 90),
                ylim=(0, 1.03))
    axes[0].legend(fontsize=7)
    axes[1].legend(fontsize=7, loc="lower left")
    plot.tight_layout()
    return Section("Masking and shadowing, G",
                   "Smith's G depends on the distribution and treats all facets alike; correlated heights count once "
                   "what hides a facet from both directions. V-grooves never hide a facet that faces the normal; "
                   "others they hide from one direction at a time, masked or shadowed, hence the corners.",
                   figure(plot))


# ---- energy ---------------------------------------------------------------------------------------------------

EMPIRICAL = (("Phong", "phong:color=1,exponent={}", "#0072b2"),
             ("Blinn-Phong, (e+2)/2π", "blinn_phong:color=1,exponent={},normalization=lecture", "#d55e00"),
             ("Blinn-Phong, conserving", "blinn_phong:color=1,exponent={}", "#009e73"))


def normal_gain(exponent):
    """Albedo along the normal of (e+2)/2π (h.n)^e: the integral over the half sphere in closed form."""
    return 4 * (exponent + 2 ** (-exponent / 2)) / (exponent + 4)


def empirical_energy(quick):
    exponents = (1, 5, 20, 100)
    plot, axes = plt.subplots(1, 4, figsize=(12.6, 3.4), sharey=True)
    rows = []
    for axis, exponent in zip(axes, exponents):
        row = [f"e = {exponent}"]
        for label, spec, color in EMPIRICAL:
            at = outside(spec.format(exponent))["angles"]
            axis.plot([a["cosine"] for a in at], [a["energy"] for a in at], color=color, marker=".", lw=1.3,
                      label=label)
            row += [f"{at[0]['energy']:.3f}"]
        axis.axhline(1, color="#bbb", lw=0.8, zorder=0)
        axis.set(title=f"e = {exponent}", xlabel="cosine of ωo", xlim=(0, 1))
        rows.append(row[:3] + [f"{normal_gain(exponent):.3f}"] + row[3:])
    axes[0].set(ylabel="reflected share", ylim=(0, None))
    axes[0].legend(fontsize=7, loc="upper left")
    plot.tight_layout()
    with tempfile.TemporaryDirectory() as folder:
        scene = scenes.sphere_file(folder, quick)
        spheres, cells = sheet(1, 4)
        entries = [(label.replace(", ", "\n"), spec.format(20)) for label, spec, _ in EMPIRICAL]
        entries.append(("GGX metal, α = 0.6\nwith multiscatter", f"conductor:{WHITE},alpha=0.6"))
        fill(cells[0], entries, scene, scenes.BARE, quick, "--env", "0.2,0.2,0.2")
    worst = max(outside(spec.format(e))["reciprocityError"] for _, spec, _ in EMPIRICAL for e in exponents)
    header = ["along the normal", "Phong", "Blinn-Phong, lecture", "4(e + 2^(-e/2))/(e+4)", "conserving"]
    return Section("Energy that empirical models gain and lose",
                   "Share of the light that a white surface reflects, measured by vkpt bsdf. The lecture's factor "
                   "(e+2)/2π is right for the angle to the mirror direction; about the half vector the lobe fills four "
                   "times the solid angle, and up to four times the light comes out. Phong gains nothing and loses "
                   f"what its lobe sends below the horizon. All are reciprocal in this form (worst error {worst:.0e}). "
                   "Last, e = 20 in a uniform furnace: what keeps the energy cannot be seen.",
                   figure(plot) + table(header, rows) + figure(spheres))


SURFACES = (("white metal, GGX", f"conductor:{WHITE},alpha={{}}"),
            ("white metal, Beckmann", f"conductor:{WHITE},distribution=beckmann,alpha={{}}"),
            ("gold, GGX", "conductor:metal=Au,alpha={}"), ("glass, GGX", "dielectric:alpha={}"))
COSINES = ((1.0, "#0072b2"), (0.5, "#d55e00"), (0.1, "#009e73"))


def lost_and_regained(quick):
    alphas = (0.2, 0.8) if quick else (0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1)
    plot, axes = plt.subplots(1, len(SURFACES), figsize=(12.6, 3.5), sharey=True)
    for axis, (title, spec) in zip(axes, SURFACES):
        at = [{round(a["cosine"], 3): a for a in outside(spec.format(alpha))["angles"]} for alpha in alphas]
        for cosine, color in COSINES:
            axis.plot(alphas, [a[cosine]["energy"] for a in at], color=color, lw=1.4, label=f"cosine {cosine}, on")
            axis.plot(alphas, [a[cosine]["energyWithoutMultiscatter"] for a in at], color=color, lw=1.4, ls="--",
                      label=f"cosine {cosine}, off")
        axis.set(title=title, xlabel="α", xlim=(0, 1), ylim=(0.2, 1.02))
    axes[0].set(ylabel="reflected and transmitted share")
    axes[0].legend(fontsize=7)
    plot.tight_layout()
    return Section("Energy lost and regained",
                   "Facets of a rough surface reflect light at one another. A model of single scattering drops that "
                   "light: dashed. --multiscatter on, the default, gives it back: a white metal and clear glass keep "
                   "all, gold absorbs a little at every reflection and grows more saturated.",
                   figure(plot) + furnace(quick))


def furnace(quick):
    """White metal and glass in a uniform environment, with interreflection and without."""
    entries = [(f"{kind}, α = {alpha}", spec.format(alpha)) for kind, spec in
               (("metal", SURFACES[0][1]), ("glass", SURFACES[3][1])) for alpha in (0.2, 0.6, 1)]
    with tempfile.TemporaryDirectory() as folder:
        scene = scenes.sphere_file(folder, quick)
        plot, axes = sheet(2, len(entries), ("multiscatter off", "on"))
        for line, switch in zip(axes, ("off", "on")):
            fill(line, entries, scene, scenes.BARE, quick, "--env", "0.5,0.5,0.5", "--multiscatter", switch,
                 "--max-depth", 64, titled=switch == "off")
    return figure(plot)


SECTIONS = [distributions, masking, empirical_energy, lost_and_regained]
