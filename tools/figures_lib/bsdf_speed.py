"""Measures what every BSDF costs: paths a second of the gallery where all is made of it. Prints a table, writes JSON.

Per second of CPU time, so that a busy machine matters little: least of the runs of `vkpt bench`, start excluded.
"""
import json
import sys

from . import vkpt
from .ranking import markdown, save

GALLERY = vkpt.ROOT / "scenes" / "bsdf_gallery" / "scene.gltf"
MODELS = ("gltf", "lambert", "oren_nayar", "eon", "phong", "blinn_phong", "ashikhmin_shirley", "cook_torrance",
          "torrance_sparrow", "mirror", "conductor", "conductor:distribution=beckmann", "conductor:alpha=0.1/0.4",
          "plastic", "dielectric", "dielectric:alpha=0.3")


def paths_a_second(spec, quick):
    """Millions of paths a second of CPU time, a backend."""
    width, spp, repeat = (32, 2, 1) if quick else (256, 8, 3)
    height = width * 9 // 16
    report = json.loads(vkpt.run("bench", GALLERY, "--material-all", spec, "--size", f"{width}x{height}", "--spp", spp,
                                 "--repeat", repeat, "--json"))
    return {run["backend"]: width * height * spp / min(run["runCpuSeconds"]) / 1e6 for run in report["results"]}


def measure(output, quick):
    report = {}
    for spec in MODELS:
        report[spec] = paths_a_second(spec, quick)
        print(f"figures: {spec} {report[spec]}", file=sys.stderr)
    backends = list(next(iter(report.values())))
    rows = [[f"`{spec}`"] + [f"{rates[backend]:.2f}" for backend in backends] for spec, rates in report.items()]
    print(markdown(["M paths a second of CPU time", *backends], rows))
    save(output, report)
