"""The section on environment maps as lights."""
import json
import pathlib
import tempfile

from . import bsdf_levels, bsdf_scenes, page, vkpt
from .page import Section, figure, table
from .renders import picture, shown
from .transport_pictures import REFERENCE_SEED, render, sheet

SUN = 60.0, 5.0  # nits, and degrees of its radius
SUN_TURN = 130  # degrees of --env-rotation: it shines from beside the camera
WAYS = (("uniform", ("--strategy", "bsdf", "--hemisphere", "uniform")),
        ("cosine", ("--strategy", "bsdf", "--hemisphere", "cosine")), ("importance", ("--strategy", "light")),
        ("both, MIS", ("--strategy", "mis-power", "--hemisphere", "cosine")))


def study(environment, count, target):
    """The JSON of `vkpt env`, and its picture as an element of the page."""
    found = json.loads(vkpt.run("env", environment, "--count", count, "-o", target, "--json"))
    return found, page.image_file(target, f"{environment}: map, importance, marginal, conditionals, samples")


def lit_by(folder, sky, quick):
    """One scene, direct light of the sky by three ways to draw directions, and what is right."""
    size, spp, reference_spp = ((48, 36), 8, 128) if quick else ((240, 180), 16, 512)
    scene = bsdf_scenes.sphere_file(folder, quick)

    def drawn(samples, seed, *options):
        return render(folder, scene, size, samples, quick, "--env", sky, "--env-rotation", SUN_TURN, "--max-depth", 1,
                      "--material-all", "lambert:color=0.6", "--background", "0.05,0.05,0.05", *options, seed=seed)

    reference = drawn(reference_spp, REFERENCE_SEED)
    plot, axes = sheet(1, len(WAYS) + 1, size, 2.4)
    row = [f"{spp} spp"]
    for axis, (title, options) in zip(axes[0], WAYS):
        image = drawn(spp, 0, *options)
        row.append(f"{vkpt.relative_mse(image, reference):.4f}")
        picture(axis, shown(image), f"{title}, {spp} spp, relMSE {float(row[-1]):.3g}")
    picture(axes[0, -1], shown(reference), f"reference, {reference_spp} spp")
    return figure(plot) + table(["relMSE, direct light of the sky with a sun", *(title for title, _ in WAYS)], [row])


def environment_importance(quick):
    pictures, rows = "", []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        sky = bsdf_levels.write_sky(folder / "sky_with_sun.hdr", SUN[0], (0.3, 0.45, 0.7), SUN[1])
        for environment in (sky, "studio"):
            found, image = study(environment, 64 if quick else 256, folder / "map.png")
            pictures += image
            for of in found["integrals"]:
                rows.append([f"{pathlib.Path(found['environment']).stem}: {of['name']}", f"{of['uniformVariance']:.3g}",
                             f"{of['importanceVariance']:.3g}",
                             f"{of['uniformVariance'] / of['importanceVariance']:.3g}"])
        lit = lit_by(folder, sky, quick)
    return Section("Importance of an environment map",
                   "The map; its importance, a scalar: luminance × sin θ, since rows near the poles are short; the "
                   "marginal, the sum of every row; every row by itself, which is the conditional density of its "
                   "columns; and where samples fall: a row is drawn by the marginal, a column by the row's "
                   "conditional density. They gather where light is: in the sun, the "
                   "lamps. The table has the variance of one sample, relative to the integral squared, for directions "
                   "uniform over the sphere and by importance. Last, direct light of the sky with a sun: directions of "
                   "the hemisphere meet the sun by chance, and then it is far too bright; importance finds it in every "
                   "pixel, and is noisier where only the sky shines; both together are good everywhere.",
                   pictures + table(["variance of one sample", "uniform", "importance", "ratio"], rows) + lit)


SECTIONS = [environment_importance]
