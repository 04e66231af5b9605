"""Sections that render: the same scene with different samplers, and how its error is spread over the screen."""
import tempfile

import matplotlib.pyplot as plt
import numpy as np

from . import vkpt
from .page import Section, figure, table


def shown(image):
    """Linear radiance to sRGB display values, without a tone curve."""
    v = np.clip(image, 0, 1)
    return np.where(v <= 0.0031308, 12.92 * v, 1.055 * v ** (1 / 2.4) - 0.055)


def picture(axes, image, title):
    axes.imshow(image, interpolation="nearest")
    axes.set_title(title, fontsize=9)
    axes.axis("off")


def comparison(scene, size, counts, reference_spp):
    """Of one scene; `size` (width, height)."""
    samplers = ("random", "halton", "sobol")
    with tempfile.TemporaryDirectory() as folder:
        reference = vkpt.render(folder, scene, size, reference_spp, "sobol", 999)
        height = 3.2 * size[1] / size[0]
        plot, axes = plt.subplots(len(counts), len(samplers) + 1, figsize=(12, len(counts) * height), squeeze=False)
        rows = []
        for line, spp in zip(axes, counts):
            row = [f"{spp} spp"]
            for axis, sampler in zip(line, samplers):
                image = vkpt.render(folder, scene, size, spp, sampler)
                row.append(f"{vkpt.relative_mse(image, reference):.4f}")
                picture(axis, shown(image), f"{sampler}, {spp} spp, relMSE {row[-1]}")
            picture(line[-1], shown(reference), f"reference, {reference_spp} spp")
            rows.append(row)
    plot.tight_layout()
    return figure(plot) + table([f"relMSE, {scene}", *samplers], rows)


def pictures(quick):
    counts, reference_spp = ((4,), 64) if quick else ((4, 8), 1024)
    sizes = {"cornell_box": (48, 48), "mis_plates": (64, 36)} if quick else {"cornell_box": (256, 256),
                                                                             "mis_plates": (320, 180)}
    body = "".join(comparison(scene, size, counts, reference_spp) for scene, size in sizes.items())
    return Section("Random, Halton and Sobol' at 4 and 8 samples", "Error against a reference of another seed.", body)


def error_spectrum(error):
    n = min(error.shape)
    power = np.abs(np.fft.fftshift(np.fft.fft2(error[:n, :n] - error.mean()))) ** 2
    return power / power.sum()


def low_share(power):
    """Share of the power below a quarter of Nyquist."""
    n = power.shape[0]
    y, x = np.mgrid[:n, :n] - n // 2
    return float(power[np.hypot(x, y) <= n / 8].sum())


def error_distribution(quick):
    size, reference_spp, counts = (48, 64, (1,)) if quick else (256, 1024, (1, 2, 4))
    samplers = ("random", "sobol", "zsobol", "bluenoise")
    rows, body = [], ""
    with tempfile.TemporaryDirectory() as folder:
        reference = vkpt.render(folder, "cornell_box", size, reference_spp, "sobol", 999, "--max-depth", 1)
        for spp in counts:
            plot, axes = plt.subplots(3, len(samplers), figsize=(12, 9.6))
            shares = []
            for k, sampler in enumerate(samplers):
                image = vkpt.render(folder, "cornell_box", size, spp, sampler, 0, "--max-depth", 1)
                error = (image - reference)[..., 1] / (reference[..., 1] + 0.05)
                error = np.clip(error, -2, 2)  # the lamp's edge apart
                power = error_spectrum(error)
                shares.append(low_share(power))
                picture(axes[0, k], shown(image), f"{sampler}, {spp} spp")
                picture(axes[1, k], np.repeat(np.clip(0.5 + error / 2, 0, 1)[..., None], 3, 2), "error")
                axes[2, k].imshow(np.sqrt(power), cmap="gray", vmax=np.sqrt(np.quantile(power, 0.995)))
                axes[2, k].axis("off")
                axes[2, k].set_title(f"spectrum; low band {shares[-1] / shares[0]:.2f} of random's", fontsize=9)
            plot.tight_layout()
            body += figure(plot)
            rows.append([f"{spp} spp"] + [f"{s / shares[0]:.2f}" for s in shares])
    return Section("Where the error lies on the screen", "Direct light in the Cornell box: at one sample zsobol and "
                   "bluenoise push the same error to high frequencies, where it is seen less. With more samples zsobol "
                   "still does, bluenoise hardly: its mask shifts all samples of a pixel alike. The table: power below a "
                   "quarter of Nyquist, over random's.", body + table(["low band", *samplers], rows))


SECTIONS = [pictures, error_distribution]
