"""Sections of plots of light transport: directions, truncation, Russian roulette."""
import json
import pathlib
import tempfile

import matplotlib.pyplot as plt
import numpy as np

from make_scenes_lib.gltf import Gltf
from make_scenes_lib.shapes import quad

from . import bsdf_scenes, vkpt
from .page import Section, figure, table
from .transport_pictures import render

BLUE, ORANGE, GREEN, GREY = "#0072b2", "#d55e00", "#009e73", "#888"


# ---- directions -------------------------------------------------------------------------------------------------

def uniform_directions(u):
    """Of points in the unit square, by rows; density 1/2π."""
    z, phi = u[:, 1], 2 * np.pi * u[:, 0]
    return np.stack([np.cos(phi) * np.sqrt(1 - z ** 2), np.sin(phi) * np.sqrt(1 - z ** 2), z], 1)


def cosine_directions(u):
    """The concentric map to the disk, lifted to the hemisphere; density cos θ/π. [Shirley 97]"""
    a, b = 2 * u.T - 1
    flat = np.abs(a) > np.abs(b)
    radius = np.where(flat, a, b)
    with np.errstate(divide="ignore", invalid="ignore"):
        phi = np.pi / 4 * np.where(flat, b / a, 2 - a / b)
    phi = np.where(radius == 0, 0, phi)
    return np.stack([radius * np.cos(phi), radius * np.sin(phi), np.sqrt(np.maximum(0, 1 - radius ** 2))], 1)


TILT = np.radians(22)  # of the eye that looks at the hemisphere, above its floor


def projected(points):
    return points[:, 0], points[:, 2] * np.cos(TILT) + points[:, 1] * np.sin(TILT)


def dome(axes):
    """The floor, the outline and two parallels of the unit hemisphere."""
    turn = np.linspace(0, 2 * np.pi, 200)
    for polar in (30, 60, 90):
        r, z = np.sin(np.radians(polar)), np.cos(np.radians(polar))
        circle = np.stack([r * np.cos(turn), r * np.sin(turn), np.full_like(turn, z)], 1)
        axes.plot(*projected(circle), color="#bbb" if polar == 90 else "#e4e4e4", lw=0.9, zorder=0)
    axes.plot(np.cos(turn[:100]), np.sin(turn[:100]), color="#bbb", lw=0.9, zorder=0)
    axes.set(aspect="equal", xlim=(-1.06, 1.06), ylim=(-0.42, 1.06))
    axes.axis("off")


def directions_on(axes, directions, title):
    dome(axes)
    x, y = projected(directions)
    if len(directions) <= 4:
        for end in zip(x, y):
            axes.annotate("", end, (0, 0), arrowprops={"arrowstyle": "-|>", "color": BLUE, "shrinkA": 0, "shrinkB": 0})
    behind = directions[:, 1] > 0
    for which, color in ((behind, "#8cc3e6"), (~behind, BLUE)):
        axes.scatter(x[which], y[which], s=26 if len(directions) <= 4 else 9, color=color, linewidths=0)
    axes.set_title(title, fontsize=9)


def from_above(axes, directions):
    axes.add_patch(plt.Circle((0, 0), 1, fill=False, color="#bbb", lw=0.9))
    axes.scatter(directions[:, 0], directions[:, 1], s=7, color=BLUE, linewidths=0)
    axes.set(aspect="equal", xlim=(-1.05, 1.05), ylim=(-1.05, 1.05))
    axes.set_title("from above", fontsize=9)
    axes.axis("off")


def polar_angles(axes, kinds, quick):
    """Histograms of θ beside the densities: that of the solid angle times sin θ, 2π around."""
    u = vkpt.points("sobol", 1024 if quick else 16384)
    theta = np.linspace(0, 90, 181)
    exact = {"uniform": np.sin(np.radians(theta)), "cosine": np.sin(np.radians(2 * theta))}
    for (name, draw), color in zip(kinds, (ORANGE, BLUE)):
        found = np.degrees(np.arccos(draw(u)[:, 2]))
        axes.hist(found, 45, (0, 90), density=True, color=color, alpha=0.3)
        axes.plot(theta, exact[name] * np.pi / 180, color=color, lw=1.4, label=name)
    axes.set(xlabel="θ, degrees", title="density of θ: drawn and exact", yticks=[], xlim=(0, 90))
    axes.legend(fontsize=8, loc="upper left")


def hemisphere_directions(quick):
    kinds = (("uniform", uniform_directions), ("cosine", cosine_directions))
    plot, axes = plt.subplots(2, 4, figsize=(12.6, 5), width_ratios=(1.43, 1.43, 1.43, 1))
    for line, (name, draw) in zip(axes, kinds):
        for axis, count in zip(line, (1, 4, 256)):
            directions_on(axis, draw(vkpt.points("sobol", count, seed=2)), f"{name}, {count}")
        from_above(line[3], draw(vkpt.points("sobol", 256, seed=2)))
    plot.tight_layout()
    angles, axis = plt.subplots(figsize=(5.6, 2.8))
    polar_angles(axis, kinds, quick)
    return Section("Uniform and cosine-weighted directions",
                   "Uniform over the hemisphere, p = 1/2π, and cosine-weighted, p = cos θ/π (the slide writes cos θ, "
                   "without the factor that makes it a density): points in the unit square by the two maps that "
                   "--hemisphere uniform and cosine use. Cosine-weighted directions are points spread evenly over the "
                   "disk, lifted; few of them graze the surface, where light counts least. Seen from above, uniform "
                   "ones crowd at the rim.",
                   figure(plot) + figure(angles))


# ---- truncation -------------------------------------------------------------------------------------------------

WALL = 0.8  # albedo of the closed room
ENDLESS = 64  # bounces that are as good as all of them in the Cornell box


def closed_room(folder):
    """Path of a glTF file: a cube seen from inside whose walls reflect WALL and emit 1 nit, so that the radiance along
    every ray is 1 + WALL + WALL^2 + ..."""
    g = Gltf()
    wall = g.material("wall", emissive=(1, 1, 1), bsdf={"model": "lambert", "color": WALL})
    axes = np.eye(3)
    walls = []
    for k in range(3):
        for side in (1.0, -1.0):
            right, up = 2 * axes[(k + 1) % 3] * side, 2 * axes[(k + 2) % 3]
            corner = -side * axes[k] - (right + up) / 2  # faces cross(right, up) = 4 side axes[k], the middle
            walls.append(g.primitive(quad(*(tuple(map(float, v)) for v in (corner, right, up))), wall))
    g.scene("room", g.node("room", mesh=g.mesh("room", *walls)),
            g.perspective("inside", (0, 0, 0.5), (0.3, 0.2, -1), 60.0))
    return bsdf_scenes.write(folder, g)


ROULETTES = (("off", ("--rr", "off"), {"color": BLUE, "marker": "o", "ms": 9, "mfc": "none"}),
             ("throughput", ("--rr", "throughput", "--rr-depth", 1), {"color": ORANGE, "marker": "s", "ms": 5}),
             ("fixed:0.7", ("--rr", "fixed:0.7", "--rr-depth", 1), {"color": GREEN, "marker": "^", "ms": 3}))


def mean_and_rays(folder, scene, size, spp, depth, roulette, seeds, *options):
    """Mean radiance, its standard error over seeds, and rays that a path follows."""
    stats = pathlib.Path(folder) / "stats.json"
    means, rays = [], []
    for seed in range(seeds):
        image = render(folder, scene, size, spp, True, "--max-depth", depth, "--stats", stats, *roulette, *options,
                       seed=seed)
        report = json.loads(stats.read_text(encoding="utf-8"))
        means.append(image.mean())
        rays.append(report["pathRays"] / report["paths"])
    return np.mean(means), np.std(means, ddof=1) / np.sqrt(seeds), np.mean(rays)


def truncation(quick):
    depths = (0, 1, 2, 4, 8, 16) if quick else (0, 1, 2, 3, 4, 6, 8, 11, 15, 20, 26, 32)
    size, spp, seeds = (8, 16, 2) if quick else (24, 64, 8)
    plot, axes = plt.subplots(1, 3, figsize=(12.6, 3.7))
    with tempfile.TemporaryDirectory() as folder:
        room = closed_room(folder)
        # Of the same random numbers as what it is compared with: their noise is common, and cancels.
        endless = mean_and_rays(folder, "cornell_box", size, spp, ENDLESS, ROULETTES[0][1], seeds)[0]
        scenes = ((room, ("--strategy", "bsdf"), "closed room, walls reflect and emit", 1 / (1 - WALL)),
                  ("cornell_box", (), "cornell_box", endless))
        rows = []
        for axis, (scene, options, title, limit) in zip(axes, scenes):
            axis.axhline(limit, color=GREY, lw=0.9, ls="--", label="all bounces")
            for name, roulette, style in ROULETTES:
                found = [mean_and_rays(folder, scene, size, spp, d, roulette, seeds, *options) for d in depths]
                means, errors, rays = np.array(found).T
                axis.errorbar(depths, means, 2 * errors, **style, lw=1, capsize=2, label=f"--rr {name}")
                if scene == room:
                    axes[2].plot(depths, rays, **style, lw=1, label=f"--rr {name}")
                for depth in (2, 8, depths[-1]):
                    k = depths.index(depth)
                    rows.append([f"{title.split(',')[0]}, --rr {name}, --max-depth {depth}", f"{means[k]:.4f}",
                                 f"{errors[k]:.4f}", f"{round(means[k] / limit - 1, 4) + 0.0:+.2%}", f"{rays[k]:.2f}"])
            axis.set(xlabel="--max-depth", title=title, ylabel="mean radiance, nits", ylim=(0, None))
    exact = (1 - WALL ** (np.array(depths) + 1)) / (1 - WALL)
    axes[0].plot(depths, exact, color="#000", lw=0.8, ls=":", label="(1 − a^(D+1)) / (1 − a)", zorder=5)
    axes[0].legend(fontsize=7, loc="lower right")
    axes[2].set(xlabel="--max-depth", title="closed room: rays a path", ylim=(0, None))
    axes[2].legend(fontsize=7)
    plot.tight_layout()
    return Section("Where to stop: truncation is biased, Russian roulette is not",
                   f"A room whose walls reflect a = {WALL} and glow with 1 nit holds 1/(1 − a) = {1 / (1 - WALL):g} "
                   "nits. Paths cut off at a fixed depth fall short by what longer ones would bring, the same with "
                   "roulette and without: roulette by itself takes nothing away. But without it every path runs to the "
                   "end, and with it a path ends soon by itself, however large --max-depth is (right): so the depth "
                   "can be made as large as one likes, and the bias as small. Error bars: two standard errors over "
                   "seeds.",
                   figure(plot) + table(["mean radiance", "nits", "standard error", "bias", "rays a path"], rows))


# ---- efficiency of Russian roulette -----------------------------------------------------------------------------

SETTINGS = (("off", ("--rr", "off")), ("throughput, from 5", ("--rr", "throughput")),
            ("throughput, from 3", ("--rr", "throughput", "--rr-depth", 3)),
            ("throughput, from 1", ("--rr", "throughput", "--rr-depth", 1)),
            *((f"fixed:{p}, from 1", ("--rr", f"fixed:{p}", "--rr-depth", 1)) for p in (0.9, 0.7, 0.5, 0.3)))
PAINT = "lambert:color={0}/{0}/{0}"
ROOMS = (("as it is", ()), ("white walls, 0.95", [0.95] * 3), ("dark walls, 0.2", [0.2] * 3))


def painted(colors):
    options = []
    for material, color in zip(("white", "red", "green"), colors):
        options += ["--material", f"{material}={PAINT.format(color)}"]
    return options


def variances(folder, choices, size, spp, seeds):
    """Of one render by each choice of options, over the mean squared as relMSE is: the mean over pixels of the sample
    variance over seeds. All choices have one mean, which is taken over the renders of all."""
    images = np.array([[render(folder, "cornell_box", size, spp, True, *options, seed=seed) for seed in range(seeds)]
                       for options in choices])
    squared = images.mean(axis=(0, 1)) ** 2 + 0.01
    return np.array([np.mean(of_one.var(axis=0, ddof=1) / squared) for of_one in images])


def seconds(options, size, spp, quick):
    """CPU time of one render, start excluded, the least of the runs; and rays a path."""
    backend, repeat = ("cpu", 1) if quick else ("vulkan", 5)
    report = json.loads(vkpt.run("bench", "--backend", backend, "--size", f"{size}x{size}", "--spp", spp, "--repeat",
                                 repeat, "--json", *options))
    run = report["results"][0]
    return min(run["runCpuSeconds"]), (run["pathRays"] + run["shadowRays"]) / run["paths"]


def roulette_efficiency(quick):
    size, spp, seeds = (24, 16, 4) if quick else (96, 16, 12)
    depth = ("--max-depth", 64)
    plot, axes = plt.subplots(1, len(ROOMS), figsize=(12.6, 3.6), sharey=True)
    rows, ticks = [], (0.1, 0.3, 1, 3, 10, 30)
    with tempfile.TemporaryDirectory() as folder:
        for axis, (room, colors) in zip(axes, ROOMS):
            choices = [(*depth, *setting, *painted(colors)) for _, setting in SETTINGS]
            v = variances(folder, choices, size, spp, seeds)
            t, rays = np.array([seconds(options, size, spp, quick) for options in choices]).T
            v, t = v / v[0], t / t[0]
            place = np.arange(len(SETTINGS))[::-1]
            for offset, values, color, label in ((0.27, v, ORANGE, "variance"), (0, t, GREY, "time"),
                                                 (-0.27, 1 / (v * t), BLUE, "efficiency")):
                axis.barh(place + offset, values - 1, 0.25, left=1, color=color, label=label)
            axis.axvline(1, color="#000", lw=0.7)
            axis.set(title=f"cornell_box, {room}", xlabel="over that of --rr off", xscale="log", xlim=(0.08, 80),
                     yticks=place, yticklabels=[name for name, _ in SETTINGS])
            axis.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
            rows += [[f"{room}: {name}", f"{a:.2f}", f"{b:.2f}", f"{1 / (a * b):.2f}", f"{r:.2f}"]
                     for (name, _), a, b, r in zip(SETTINGS, v, t, rays)]
    axes[0].legend(fontsize=8)
    plot.tight_layout()
    return Section("Efficiency of Russian roulette",
                   "Efficiency is 1/(variance × time). Roulette always raises the variance and shortens the time. It "
                   "pays where what it skips would have brought little: by the throughput, where walls absorb; between "
                   "white walls every bounce still carries light, and there is next to nothing to gain. A fixed "
                   "probability P suits one albedo: 0.5 is good between dark walls and costs more than it saves in "
                   "the other rooms. Where the albedo's square exceeds P, weights grow faster than paths die, and only "
                   "--max-depth, 64 here, bounds the variance. Variance over seeds, CPU time of vkpt bench.",
                   figure(plot) + table(["over --rr off", "variance", "time", "efficiency", "rays a path"], rows))


SECTIONS = [hemisphere_directions, truncation, roulette_efficiency]
