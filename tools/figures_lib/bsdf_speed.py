"""Measures what every BSDF costs: paths a second of the gallery where all is made of it. Prints a table, writes JSON.

CPU time, not the clock, so that a busy machine does not matter much: user and system time of the whole process at two
numbers of samples; their difference is free of start, compilation and loading. Best of `turns` turns.
"""
import json
import os
import pathlib
import sys
import tempfile

from . import vkpt
from .ranking import markdown

GALLERY = vkpt.ROOT / "scenes" / "bsdf_gallery" / "scene.gltf"
MODELS = ("gltf", "lambert", "oren_nayar", "eon", "phong", "blinn_phong", "mirror", "conductor",
          "conductor:distribution=beckmann", "conductor:alpha=0.1/0.4", "torrance_sparrow", "cook_torrance",
          "ashikhmin_shirley", "plastic", "dielectric", "dielectric:alpha=0.3")


def cpu_seconds(target, spec, backend, width, spp):
    """CPU time of a process that renders the gallery."""
    before = os.times()
    vkpt.run("render", GALLERY, "--material-all", spec, "--spp", spp, "--size", f"{width}x{width * 9 // 16}",
             "--backend", backend, "-q", "-o", target)
    after = os.times()
    return (after.children_user - before.children_user) + (after.children_system - before.children_system)


def microseconds_a_path(target, spec, backend, quick):
    width, few, many, turns = (32, 1, 5, 1) if quick else (192, 2, 12, 2)
    cpu_seconds(target, spec, backend, width, few)  # compiles its kernels
    least = [min(cpu_seconds(target, spec, backend, width, spp) for _ in range(turns)) for spp in (few, many)]
    return (least[1] - least[0]) / (width * (width * 9 // 16) * (many - few)) * 1e6


def measure(output, quick):
    report = []
    with tempfile.TemporaryDirectory() as folder:
        target = pathlib.Path(folder) / "timed.pfm"
        for spec in MODELS:
            costs = {backend: microseconds_a_path(target, spec, backend, quick) for backend in ("vulkan", "cpu")}
            report.append({"spec": spec, "microsecondsAPath": costs})
            print(f"figures: {spec} {costs['vulkan']:.2f} µs, {costs['cpu']:.2f} µs", file=sys.stderr)
    rows = [[f"`{e['spec']}`"] + [f"{1 / cost:.3f}" for cost in e["microsecondsAPath"].values()] for e in report]
    print(markdown(["model", "Vulkan", "CPU reference"], rows))
    pathlib.Path(output).write_text(json.dumps(report, indent=1) + "\n", encoding="utf-8")
