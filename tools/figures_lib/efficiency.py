"""Measures the efficiency of path tracing: error, seconds, and error × seconds. Prints a table, writes JSON.

Error: relMSE of `vkpt diff` against a converged render of another seed, mean over seeds, with and without the worst
0.1 % of the pixels. Seconds: of the fastest run of `vkpt bench`, start excluded; CPU time beside it.
"""
import concurrent.futures
import json
import pathlib
import sys
import tempfile

import numpy as np

from . import ranking, vkpt
from .ranking import REFERENCE_SEED, markdown, save

COUNTS = (4, 16, 64)


def timed(scene, options, size, spp, repeat):
    """Seconds of the fastest run, and CPU seconds of the cheapest."""
    file = vkpt.scene_file(scene)
    report = json.loads(vkpt.run("bench", file, "--backend", "vulkan", "--size", f"{size}x{size}", "--spp", spp,
                                 "--repeat", repeat, "--json", *options))
    run = report["results"][0]
    return min(run["runSeconds"]), min(run["runCpuSeconds"])


def figures(folder, scene, options, size, counts, seeds, reference_spp, repeat):
    """A row for every number of samples."""
    reference = vkpt.render(folder, scene, size, reference_spp, "sobol", REFERENCE_SEED, *options)
    rows = []
    for spp in counts:
        with concurrent.futures.ThreadPoolExecutor(2) as pool:  # one starts while the other renders
            found = list(pool.map(lambda seed, spp=spp: ranking.errors(
                vkpt.render(folder, scene, size, spp, "sobol", seed, *options), reference), range(seeds)))
        whole, trimmed = np.mean(found, axis=0)
        seconds, cpu = timed(scene, options, size, spp, repeat)
        rows.append({"spp": spp, "seeds": found, "relMSE": whole, "trimmed": trimmed, "seconds": seconds,
                     "cpuSeconds": cpu, "relMSESeconds": whole * seconds, "trimmedSeconds": trimmed * seconds})
        print(f"figures: {pathlib.Path(scene).stem}, {spp} spp: {whole:.4g} in {seconds:.3g} s", file=sys.stderr)
    return rows


def measure(output, assets, quick):
    """Saves after every scene, so that a run cut short is not lost."""
    size, reference_spp, counts, seeds, repeat = (32, 256, (4,), 2, 1) if quick else (256, 4096, COUNTS, 8, 5)
    report = {"size": size, "reference": {"spp": reference_spp, "seed": REFERENCE_SEED}, "scenes": {}}
    with tempfile.TemporaryDirectory() as folder:
        for name, (scene, options, _) in ranking.scenes(assets).items():
            if name == "mis_plates":
                continue  # shown by the page
            report["scenes"][name] = figures(folder, scene, options, size, counts, seeds, reference_spp, repeat)
            save(output, report)
    columns = ("relMSE", "trimmed", "seconds", "cpuSeconds", "relMSESeconds", "trimmedSeconds")
    rows = [[f"{name}, {row['spp']} spp", *(f"{row[column]:.3g}" for column in columns)]
            for name, found in report["scenes"].items() for row in found]
    print(markdown(["scene", "relMSE", "without the worst 0.1 %", "s", "CPU s", "relMSE × s", "trimmed × s"], rows))
