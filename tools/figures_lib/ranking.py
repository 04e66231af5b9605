"""Measures every sampler: its error on scenes, and what it costs. Prints Markdown tables, writes JSON.

Error: relMSE of `vkpt diff`, mean over seeds, over that of `random` at as many samples. Cost: CPU time of the runs of
`vkpt bench`, over that of `random` a moment before, since machines have slow minutes; the median of some turns. Beside it
the same by paths a second, which other processes disturb more.
"""
import concurrent.futures
import json
import pathlib
import sys
import tempfile

import numpy as np

from . import vkpt

SPP, REFERENCE_SEED = 64, 1000
SEEDS, HELMET_SEEDS = 8, 16  # fireflies rule the means of the helmet
HELMET_VIEW = ["--eye", "1.8,1.0,2.2", "--target", "0,0,0", "--fov", "45"]


def samplers():
    return [entry["sampler"] for entry in vkpt.samples("--sampler", "all", "--count", 1)
            if entry["sampler"] != "poissondisk"]


def taken(sampler, spp):
    """How many samples a pixel the sampler makes of spp."""
    return len(vkpt.points(sampler, spp))


def scenes(assets):
    """File or name of each scene, the options to render it with, and how many seeds its means take."""
    found = {name: (name, [], SEEDS) for name in ("cornell_box", "mis_plates")}
    if assets is not None:
        folder = pathlib.Path(assets).resolve()
        sky = folder / "env" / "royal_esplanade_1k.hdr"
        found["DamagedHelmet"] = (folder / "models" / "DamagedHelmet.glb", ["--env", sky, *HELMET_VIEW], HELMET_SEEDS)
    return found


def errors(image, reference):
    """relMSE, and relMSE without the worst 0.1 % of the pixels."""
    pixels = np.sort(np.mean((image - reference) ** 2 / (reference ** 2 + 0.01), axis=2).ravel())
    return float(pixels.mean()), float(pixels[: len(pixels) - len(pixels) // 1000 - 1].mean())


def ratio(values, base):
    """Quotient of two means over seeds, and its standard error."""
    values, base = np.array(values), np.array(base)
    quotient = values.mean() / base.mean()
    relative = [v.std(ddof=1) / v.mean() / np.sqrt(len(v)) for v in (values, base)]
    return float(quotient), float(quotient * np.hypot(*relative))


def scene_errors(folder, scene, options, size, seeds, reference_spp, names):
    reference = vkpt.render(folder, scene, size, reference_spp, "sobol", REFERENCE_SEED, *options)

    def all_seeds(sampler, spp):
        with concurrent.futures.ThreadPoolExecutor(2) as pool:  # one starts while the other renders
            found = pool.map(lambda seed: errors(vkpt.render(folder, scene, size, spp, sampler, seed, *options),
                                                 reference), range(seeds))
            whole, trimmed = zip(*found)
        return {"relMSE": whole, "trimmed": trimmed}

    base, result = {}, []
    for sampler in names:
        spp = taken(sampler, SPP)
        if spp not in base:
            base[spp] = all_seeds("random", spp)
        measured = base[spp] if sampler == "random" else all_seeds(sampler, spp)
        entry = {"sampler": sampler, "spp": spp, "seeds": measured}
        for kind in ("relMSE", "trimmed"):
            entry[kind] = float(np.mean(measured[kind]))
            entry[kind + "OverRandom"], entry[kind + "Error"] = ratio(measured[kind], base[spp][kind])
        result.append(entry)
        print(f"figures: {pathlib.Path(scene).stem}: {sampler} {entry['relMSEOverRandom']:.3f}", file=sys.stderr)
    return result


def cost(names, spp, size, turns):
    """Least CPU time and most paths a second of each, and the medians of what they are beside `random` just before."""
    def bench(sampler):
        report = json.loads(vkpt.run("bench", "--backend", "vulkan", "--size", f"{size}x{size}", "--spp", spp,
                                     "--sampler", sampler, "--repeat", 3, "--json"))
        runs, paths = report["results"][0], size * size * report["settings"]["spp"]
        return min(runs["runCpuSeconds"]) / paths * 1e6, runs["millionPathsPerSecond"]

    pairs_of = {name: [] for name in names}
    for _ in range(turns):
        for name in names:
            base = bench("random")
            pairs_of[name].append((base, base if name == "random" else bench(name)))
    return {name: {"cpuSecondsAMillionPaths": min(own[0] for _, own in pairs),
                   "millionPathsPerSecond": max(own[1] for _, own in pairs),
                   "cpuOverRandom": float(np.median([own[0] / base[0] for base, own in pairs])),
                   "timeOverRandom": float(np.median([base[1] / own[1] for base, own in pairs]))}
            for name, pairs in pairs_of.items()}


def markdown(header, rows):
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in [header, ["---"] * len(header), *rows]) + "\n"


def plus_minus(entry, kind):
    return f"{entry[kind + 'OverRandom']:.2f} ± {entry[kind + 'Error']:.2f}"


def error_table(found):
    """Ratios to random with their standard errors; in brackets without the worst 0.1 % of the pixels."""
    names = [entry["sampler"] for entry in next(iter(found.values()))]
    rows = [[name] + [f"{plus_minus(e[k], 'relMSE')} ({plus_minus(e[k], 'trimmed')})" for e in found.values()]
            for k, name in enumerate(names)]
    return markdown(["sampler", *found], rows)


def cost_table(found):
    """Over random: CPU time, in brackets time by paths a second."""
    rows = [[name] + [f"{of[name]['cpuOverRandom']:.2f} ({of[name]['timeOverRandom']:.2f})" for of in found.values()]
            for name in next(iter(found.values()))]
    return markdown(["sampler", *(f"{spp} spp" for spp in found)], rows)


def save(output, report):
    pathlib.Path(output).write_text(json.dumps(report, indent=1) + "\n", encoding="utf-8")


def measure(output, assets, quick):
    """Saves after every scene, so that a run cut short is not lost."""
    size, reference_spp, turns = (32, 256, 1) if quick else (64, 16384, 5)
    names = samplers()
    report = {"size": size, "reference": {"spp": reference_spp, "seed": REFERENCE_SEED}, "errors": {}}
    report["cost"] = {spp: cost(names, spp, (256 if quick else 1024) // int(spp ** 0.5), turns) for spp in (16, 64)}
    print(cost_table(report["cost"]), flush=True)
    save(output, report)
    with tempfile.TemporaryDirectory() as folder:
        for name, (scene, options, seeds) in scenes(assets).items():
            report["errors"][name] = scene_errors(folder, scene, options, size, 2 if quick else seeds, reference_spp,
                                                  names)
            save(output, report)
    print(error_table(report["errors"]))
