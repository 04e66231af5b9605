"""Sections that show point sets."""
import matplotlib.pyplot as plt
import numpy as np

from . import vkpt
from .page import Section, figure, table


def square(axes, points, title="", lines=None, size=None):
    axes.scatter(points[:, 0], points[:, 1], s=size or max(2, 700 / len(points)), color="#0072b2", linewidths=0,
                 clip_on=False)
    axes.set(xlim=(0, 1), ylim=(0, 1), aspect="equal", xticks=[], yticks=[])
    axes.set_title(title, fontsize=10)
    for k in range(1, lines or 0):
        axes.axvline(k / lines, color="#ddd", lw=0.6, zorder=0)
        axes.axhline(k / lines, color="#ddd", lw=0.6, zorder=0)


def row(count, width=3.1):
    plot, axes = plt.subplots(1, count, figsize=(width * count, width + 0.3), squeeze=False)
    return plot, axes[0]


def random_and_jittered(_quick):
    plot, axes = row(2, 4)
    square(axes[0], vkpt.points("random", 64), "random, 64", 8)
    square(axes[1], vkpt.points("jittered", 64), "jittered, 64", 8)
    return Section("Random against jittered", "Random samples clump and leave holes; jittered ones put one in each "
                   "of 64 cells.", figure(plot))


def n_rooks(_quick):
    n, rng = 8, np.random.default_rng(4)
    jitter = rng.random((n, 2))
    columns, rows = np.arange(n), np.arange(n)
    steps = [("initialise: the diagonal", columns, rows)]
    rows = rng.permutation(n)
    steps.append(("shuffle rows", columns, rows))
    columns = rng.permutation(n)
    steps.append(("shuffle columns", columns, rows))
    plot, axes = row(4)
    for axis, (title, x, y) in zip(axes, steps):
        square(axis, (np.stack([x, y], 1) + jitter) / n, title, n, 40)
    square(axes[3], vkpt.points("lhs", n), "sampler lhs, 8", n, 40)
    return Section("Latin hypercube (N-rooks), step by step", "One sample in every row and every column, whatever the "
                   "number of dimensions.", figure(plot))


def jittered_grid_variance(dims, k, trials):
    """Of the mean of a product over a grid of k^dims strata, one sample in each."""
    rng = np.random.default_rng(dims)
    corners = np.indices([k] * dims).reshape(dims, -1).T
    means = [np.mean(np.prod(1 + 1.2 * ((corners + rng.random(corners.shape)) / k - 0.5), axis=1))
             for _ in range(trials)]
    return np.mean((np.array(means) - 1) ** 2)


def projected_strata():
    """About as many samples in full grids of 1, 2, 4 and 8 dimensions: what is left of the strata in two of them."""
    rng = np.random.default_rng(8)
    plot, axes = row(4)
    for axis, (dims, k) in zip(axes, ((1, 64), (2, 8), (4, 3), (8, 2))):
        corners = np.indices([k] * dims).reshape(dims, -1).T
        points = (corners + rng.random(corners.shape)) / k
        if dims == 1:
            points = np.column_stack([points, np.full(k, 0.5)])
        square(axis, points[:, :2], f"{dims}D: {k ** dims} samples,\n{k} strata a dimension", size=11)
        for line in np.arange(1, k) / k:
            axis.axvline(line, color="#ddd", lw=0.6, zorder=0)
            if dims > 1:
                axis.axhline(line, color="#ddd", lw=0.6, zorder=0)
    return figure(plot)


def curse(quick):
    plot, axes = plt.subplots(figsize=(6.4, 4))
    most, trials = (600, 40) if quick else (7000, 200)
    for dims in (1, 2, 4, 8):
        sides = sorted({round(n ** (1 / dims)) for n in np.geomspace(4, most, 12)} - {0, 1})
        sides = [k for k in sides if k ** dims <= most]
        variances = [jittered_grid_variance(dims, k, trials) for k in sides]
        axes.loglog([k ** dims for k in sides], variances, marker=".", label=f"{dims}D, theory {-1 - 2 / dims:.2f}")
    counts = np.array([4, most])
    axes.loglog(counts, 0.3 / counts, ls="--", color="#888", lw=1, label="slope of random, -1")
    axes.set(xlabel="samples, one in each of k^d strata", ylabel="variance", title="jittered, product of d factors")
    axes.legend()
    rows = [[d, f"{64 ** (1 / d):.2f}", f"{2 ** d:,}", f"{8 ** d:,}"] for d in (1, 2, 4, 8)]
    study = vkpt.samples("--sampler", "jittered,lhs,sobol", "--convergence", "--count", 256)
    slopes = {(e["sampler"], e["integrand"]): e["slope"] for e in study}
    second = [[s] + [f"{slopes[(s, f)]:.2f}" for f in ("gaussian", "product4", "product8")]
              for s in ("jittered", "lhs", "sobol")]
    return Section("The curse of dimensionality", "A full grid of strata needs k to the power d of them, and variance "
                   "falls as N to the power -1 - 2/d: in 8 dimensions hardly faster than that of random samples. vkpt "
                   "jitters pairs of dimensions instead, which gains nothing more on functions that are not sums of "
                   "pairs: there too the slope goes back to -1.",
                   projected_strata() + figure(plot) +
                   table(["dimensions", "strata a dimension of 64 samples", "samples for 2 a dimension",
                          "samples for 8 a dimension"], rows) +
                   table(["slope", "2D Gaussian", "4D product", "8D product"], second))


def discrepancy(_quick):
    names = ["random", "jittered", "poissondisk"]
    study = vkpt.samples("--sampler", ",".join(names), "--count", 64, "--discrepancy")
    sets = vkpt.samples("--sampler", ",".join(names), "--count", 64)
    plot, axes = row(4)
    for axis, entry, points in zip(axes, study, sets):
        star = entry["star"]
        axis.add_patch(plt.Rectangle((0, 0), *star["box"], color="#d55e00", alpha=0.15))
        square(axis, np.array(points["points"]),
               f"{entry['sampler']}\n|{star['boxArea']:.3f} - {star['inside']}/{entry['count']}| = {star['value']:.3f}")
    four = np.array([[0.22, 0.2], [0.3, 0.75], [0.75, 0.35], [0.8, 0.8]])
    axes[3].add_patch(plt.Rectangle((0, 0), 0.3, 0.3, color="#0072b2", alpha=0.2))
    square(axes[3], four, "the lecture's box: area 0.09\n0.25 - 0.09 = 0.16", size=40)
    measured = vkpt.samples("--sampler", "random,jittered,poissondisk,hammersley,halton,sobol", "--count",
                            256, "--discrepancy")
    rows = [[e["sampler"], f"{e['star']['value']:.4f}", f"{e['l2Star']:.5f}"] for e in measured]
    rows.append(["expected of random", f"{measured[0]['random']['star']:.4f}",
                 f"{measured[0]['random']['l2Star']:.5f}"])
    return Section("Discrepancy", "How far the share of samples in a box at the origin can be from its area; the boxes "
                   "drawn attain it. The last is the lecture's example: one of four samples stands for 0.25, its box "
                   "has 0.09.", figure(plot) +
                   table(["256 points", "star", "L2 star"], rows))


def radical_inverse(_quick):
    study = vkpt.samples("--radical-inverse", 2, "--count", 8)
    rows = [[r["n"], r["number"], r["digits"], f"{r['inverse']} = {r['numerator']}/{r['denominator']}"]
            for r in study["rows"]]
    return Section("Radical inverse", "n = d1 + d2 b + d3 b^2 + ...; its radical inverse in base b is 0.d1 d2 d3 ...: the "
                   "digits, the lowest first, put behind the point. Halton's sequence takes another prime for every "
                   "dimension; Hammersley's set has i/N in the first.",
                   table(["n", "in base 2", "d1 d2 ...", "radical inverse"], rows))


def faure_permutation(base):
    if base == 1:
        return [0]
    if base % 2 == 0:
        half = faure_permutation(base // 2)
        return [2 * h for h in half] + [2 * h + 1 for h in half]
    middle, smaller = (base - 1) // 2, [e + (e >= (base - 1) // 2) for e in faure_permutation(base - 1)]
    return smaller[:middle] + [middle] + smaller[middle:]


def faure(_quick):
    plot, axes = row(4, 2.6)
    for axis, base in zip(axes, (7, 11, 29, 97)):
        permutation = faure_permutation(base)
        axis.scatter(range(base), permutation, s=300 / base, color="#0072b2", linewidths=0)
        axis.set(title=f"base {base}", xlabel="digit", ylabel="becomes", aspect="equal")
    plot.tight_layout()
    return Section("Faure's permutations", "They send neighbouring digits far apart: even bases interleave the "
                   "permutation of half the base, odd ones put the middle digit in the middle.", figure(plot))


def hammersley_and_halton(_quick):
    plot, axes = plt.subplots(2, 3, figsize=(9.3, 6.6))
    for line, sampler in zip(axes, ("hammersley", "halton")):
        for axis, count in zip(line, (64, 256, 512)):
            square(axis, vkpt.points(sampler, count, scramble="none"), f"{sampler}, {count}")
    return Section("Hammersley and Halton", "Hammersley's set is a little more even; Halton's sequence goes on for "
                   "ever.", figure(plot))


def projections(_quick):
    pairs = ((9, 10), (19, 20), (29, 30))
    plot, axes = plt.subplots(3, 3, figsize=(9.3, 9.8))
    for line, scramble in zip(axes, ("none", "faure", "owen")):
        for axis, pair in zip(line, pairs):
            square(axis, vkpt.points("halton", 256, pair, scramble), f"{pair}, {scramble}")
    return Section("Projections of Halton's sequence", "256 points: large bases are correlated until the digits are "
                   "permuted.", figure(plot))


def convergence(quick):
    samplers = "random,jittered,lhs,cmj,halton,sobol,sobol02,orthogonal"
    study = vkpt.samples("--sampler", samplers, "--convergence", "--count", 256 if quick else 4096)
    names = list(dict.fromkeys(e["integrand"] for e in study))
    plot, axes = plt.subplots(2, 3, figsize=(13, 8))
    for axis, name in zip(axes.flat, names):
        for entry in (e for e in study if e["integrand"] == name):
            axis.loglog([p["count"] for p in entry["estimates"]], [p["variance"] for p in entry["estimates"]],
                        marker=".", lw=1.2, label=f"{entry['sampler']} {entry['slope']:.2f}")
        axis.set(title=name, xlabel="samples", ylabel="variance")
        axis.legend(fontsize=7)
    plot.tight_layout()
    return Section("Convergence", "Variance against the number of samples, with fitted slopes.", figure(plot))


def spectra(quick):
    samplers = "random,jittered,poissondisk,sobol"
    study = vkpt.samples("--sampler", samplers, "--spectrum", "--count", 256 if quick else 1024)
    plot, axis = plt.subplots(figsize=(7, 3.6))
    for entry in study:
        axis.plot(range(1, len(entry["radialMean"]) + 1), entry["radialMean"], label=entry["sampler"], lw=1.3)
    axis.set(xlabel="frequency", ylabel="power", ylim=(0, None))
    axis.legend()
    return Section("Spectra of points", "Radial mean; random points have power 1 everywhere.", figure(plot))


SECTIONS = [random_and_jittered, n_rooks, curse, discrepancy, radical_inverse, faure, hammersley_and_halton,
            projections, convergence, spectra]
