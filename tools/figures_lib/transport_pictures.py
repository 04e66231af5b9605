"""Sections of pictures of light transport: strategies, directions by the cosine, lengths of paths, double counting."""
import pathlib
import tempfile

import matplotlib.pyplot as plt
import numpy as np

from . import vkpt
from .page import Section, figure, table
from .renders import picture, shown

REFERENCE_SEED = 999


def render(folder, scene, size, spp, on_cpu, *options, seed=0):
    """`on_cpu` for small pictures: a device compiles kernels for every combination of options first."""
    backend = ["--backend", "cpu"] if on_cpu else []
    return vkpt.render(folder, scene, size, spp, "sobol", seed, *backend, *options)


def sheet(rows, columns, size, width=3.0):
    """Axes of a grid of pictures of `size` (width, height), each `width` inches wide."""
    height, title = width * size[1] / size[0], 0.3
    plot, axes = plt.subplots(rows, columns, figsize=(width * columns, (height + title) * rows), squeeze=False)
    plot.subplots_adjust(wspace=0.03, hspace=title / height, left=0, right=1, bottom=0, top=1)
    return plot, axes


# ---- strategies -------------------------------------------------------------------------------------------------

STRATEGIES = (("bsdf", "BSDF sampling"), ("light", "light sampling"), ("mis-balance", "MIS, balance heuristic"),
              ("mis-power", "MIS, power heuristic"))


def blurred(image, radius):
    """Mean over squares; the edge is repeated."""
    n = 2 * radius + 1
    padded = np.pad(image, radius, mode="edge")
    return np.mean([padded[y:y + image.shape[0], x:x + image.shape[1]] for y in range(n) for x in range(n)], axis=0)


def which_is_better(folder, size, reference, quick):
    """log2 of the squared error of BSDF sampling over that of light sampling, a pixel; 0 where neither has any."""
    seeds = range(3 if quick else 16)
    errors = []
    for strategy in ("bsdf", "light"):
        images = (render(folder, "mis_plates", size, 4, quick, "--strategy", strategy, seed=seed) for seed in seeds)
        squares = sum(np.mean((image - reference) ** 2, axis=2) for image in images) / len(seeds)
        errors.append(blurred(blurred(squares, 2), 2))  # a tent: spots of single fireflies have soft edges
    floor = 1e-6
    return np.log2((errors[0] + floor) / (errors[1] + floor))


def multiple_importance(quick):
    size, reference_spp = ((64, 36), 64) if quick else ((320, 180), 1024)
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        reference = render(folder, "mis_plates", size, reference_spp, quick, seed=REFERENCE_SEED)
        plot, axes = sheet(2, 3, size, 3.6)
        picture(axes[0, 0], shown(reference), f"reference, {reference_spp} spp")
        for axis, (strategy, title) in zip((axes[0, 1], axes[0, 2], axes[1, 0], axes[1, 1]), STRATEGIES):
            image = render(folder, "mis_plates", size, 4, quick, "--strategy", strategy)
            error = vkpt.relative_mse(image, reference)
            picture(axis, shown(image), f"{title}, 4 spp, relMSE {error:.3g}")
            rows.append([title, f"{error:.4f}", f"{error / float(rows[0][1]) if rows else 1:.3f}"])
        better = which_is_better(folder, size, reference, quick)
        axes[1, 2].imshow(better, cmap="RdBu", vmin=-8, vmax=8, interpolation="nearest")
        axes[1, 2].set_title("blue: light sampling errs less; red: BSDF sampling", fontsize=9)
        axes[1, 2].axis("off")
    return Section("BSDF, light and multiple importance sampling",
                   "Four lamps of equal power, small to large, over four plates, smooth (far) to rough (near). BSDF "
                   "sampling is good at mirror images of large lamps in smooth plates and hardly ever meets a small "
                   "lamp from a rough surface; light sampling is the reverse: in a smooth plate nearly every point of "
                   "a large lamp is the wrong one. Each is better in some regions (the last picture, from squared "
                   "errors of many seeds). Multiple importance sampling combines the benefits of both: each sample is "
                   "weighted by how likely it was among all ways to draw it.",
                   figure(plot) + table(["mis_plates, 4 spp", "relMSE", "over BSDF sampling's"], rows))


# ---- the cosine -------------------------------------------------------------------------------------------------

def ambient_occlusion(quick):
    size, reference_spp = ((60, 45), 128) if quick else ((320, 240), 256)
    counts, kinds = (1, 4, 16), ("uniform", "cosine")
    errors = {}
    with tempfile.TemporaryDirectory() as folder:
        def occlusion(kind, spp, seed=0):
            return render(folder, "instances", size, spp, quick, "--integrator", "ao", "--hemisphere", kind, seed=seed)

        reference = occlusion("cosine", reference_spp, REFERENCE_SEED)
        plot, axes = sheet(2, len(counts), size, 3.6)
        for line, kind in zip(axes, kinds):
            for axis, spp in zip(line, counts):
                image = occlusion(kind, spp)
                errors[kind, spp] = vkpt.relative_mse(image, reference)
                picture(axis, shown(image), f"{kind}, {spp} spp, relMSE {errors[kind, spp]:.3g}")
    rows = [[f"{spp} spp"] + [f"{errors[kind, spp]:.4f}" for kind in kinds] +
            [f"{errors['uniform', spp] / errors['cosine', spp]:.2f}"] for spp in counts]
    return Section("Ambient occlusion: uniform and cosine-weighted directions",
                   "How much of the hemisphere is open, weighted by the cosine. A uniform direction counts 2 cos θ if "
                   "it is open, so that even what nothing hides is noisy. A cosine-weighted one counts 1 or 0: the "
                   "cosine is in the density, and only visibility is left to chance. The open ground at the back is "
                   "where it is seen best.",
                   figure(plot) + table(["relMSE, instances", *kinds, "uniform over cosine"], rows))


# ---- lengths of paths -------------------------------------------------------------------------------------------

def path_layers(scene, size, spp, quick, most):
    """Light by length of path, 0 to `most`, and the picture of all, from one render."""
    with tempfile.TemporaryDirectory() as name:
        target = pathlib.Path(name) / "layers.exr"
        render(name, scene, size, spp, quick, "--max-depth", most, "--rr", "off", "--per-bounce", "--no-film", "-o",
               target)
        layers = vkpt.read_layers(target)
    return layers.pop("Combined"), list(layers.values())


def gain(layer, standard):
    """The power of two that makes `layer` about as light as `standard`."""
    return 2 ** max(0, round(np.log2(standard.mean() / layer.mean())))


def path_lengths(quick):
    size, spp, most = ((40, 40), 16, 6) if quick else ((256, 256), 512, 6)
    everything, layers = path_layers("cornell_box", size, spp, quick, most)
    plot, axes = sheet(2, 4, size, 2.7)
    rows = []
    for length, (axis, layer) in enumerate(zip(axes.flat, layers)):
        times = gain(layer, layers[1]) if length else 1
        picture(axis, shown(times * layer), f"path: {length}" + (f", shown × {times}" if times > 1 else ""))
        rows.append([f"path: {length}", f"{layer.mean():.5f}", f"{layer.mean() / everything.mean():.2%}"])
    total = np.sum(layers, axis=0)
    picture(axes[1, 3], shown(total), "all added")
    rows.append(["all added", f"{total.mean():.5f}", f"{total.mean() / everything.mean():.2%}"])
    rows.append(["the picture itself", f"{everything.mean():.5f}", "100.00%"])
    rows.append(["largest difference of the two, a pixel", f"{np.abs(total - everything).max():.1e}", ""])
    return Section("Light by length of path, and the sum",
                   "Path 0 is the lamp as the camera sees it, path 1 direct light with its black shadows, path 2 what "
                   "has met one more surface: the ceiling appears, and red and green bleed onto the blocks. Every "
                   "further bounce is dimmer and softer, and takes on the colours of the walls. The rendering "
                   "equation, unrolled, is the sum. The layers are those of --per-bounce.",
                   figure(plot) + table(["cornell_box", "mean radiance, nits", "share"], rows))


# ---- double counting --------------------------------------------------------------------------------------------

def counted_twice(folder, size, spp, quick, depth):
    """Light met by chance, light found by light samples, the sum that the careless code makes, and the right image;
    without and with what the camera sees of the lamp."""
    emission = render(folder, "cornell_box", size, spp, quick, "--max-depth", 0)

    def by(strategy):
        return render(folder, "cornell_box", size, spp, quick, "--max-depth", depth, "--strategy", strategy) - emission

    chance, light, right = by("bsdf"), by("light"), by("mis-power")
    return emission, (chance, light, chance + light, right)


def double_counting(quick):
    size, spp = ((40, 40), 64) if quick else ((256, 256), 128)
    titles = ("met by chance", "by light samples", "both added: counted twice", "right")
    rows = []
    plot, axes = sheet(2, 4, size, 2.7)
    with tempfile.TemporaryDirectory() as folder:
        for line, (depth, name) in zip(axes, ((1, "direct light"), (8, "all light"))):
            emission, images = counted_twice(folder, size, spp, quick, depth)
            for axis, image, title in zip(line, images, titles):
                picture(axis, shown(emission + image), f"{name}: {title}")
            means = [image.mean() for image in images]
            rows.append([name, *(f"{mean:.4f}" for mean in means), f"{means[2] / means[3]:.3f}"])
    return Section("Next event estimation: do not count double",
                   "A path that takes light samples must not add the emission that its next direction meets: that is "
                   "the same light once more. Either way alone is right (the first is noisier). The code of the slide "
                   "before the mend adds both, at every bounce, and all light but the lamp itself is twice as bright; "
                   "includeLe = false, or the weights of multiple importance sampling, count it once.",
                   figure(plot) + table(["mean without the lamp itself, nits", *titles, "twice over right"], rows))


SECTIONS = [multiple_importance, ambient_occlusion, path_lengths, double_counting]
