"""Measures every sampler: its error on scenes, and what it costs. Prints Markdown tables, writes JSON.

Error: relMSE of `vkpt diff`, mean over seeds, over that of `random` at as many samples. Cost: paths a second of `random`
over those of the sampler, by `vkpt bench`, samplers taking turns, the best of all turns.
"""
import json
import pathlib
import sys
import tempfile

import numpy as np

from . import vkpt

SPP, REFERENCE_SEED = 64, 1000
HELMET_VIEW = ["--eye", "1.8,1.0,2.2", "--target", "0,0,0", "--fov", "45"]


def samplers():
    return [entry["sampler"] for entry in vkpt.samples("--sampler", "all", "--count", 1)
            if entry["sampler"] != "poissondisk"]


def taken(sampler, spp):
    """How many samples a pixel the sampler makes of spp."""
    return len(vkpt.points(sampler, spp))


def scenes(assets):
    """File or name of each scene, and the options to render it with."""
    found = {name: (name, []) for name in ("cornell_box", "mis_plates")}
    if assets is not None:
        folder = pathlib.Path(assets).resolve()
        sky = folder / "env" / "royal_esplanade_1k.hdr"
        found["DamagedHelmet"] = (folder / "models" / "DamagedHelmet.glb", ["--env", sky, *HELMET_VIEW])
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
        images = (vkpt.render(folder, scene, size, spp, sampler, seed, *options) for seed in range(seeds))
        whole, trimmed = zip(*(errors(image, reference) for image in images))
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
    """Best paths a second of each, in millions."""
    best = dict.fromkeys(names, 0.0)
    for _ in range(turns):
        for sampler in names:
            report = json.loads(vkpt.run("bench", "--backend", "vulkan", "--size", f"{size}x{size}", "--spp", spp,
                                         "--sampler", sampler, "--repeat", 3, "--json"))
            best[sampler] = max(best[sampler], report["results"][0]["millionPathsPerSecond"])
    return best


def markdown(header, rows):
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in [header, ["---"] * len(header), *rows]) + "\n"


def error_table(found):
    """Ratios to random with their standard errors; in brackets without the worst 0.1 % of the pixels."""
    names = [entry["sampler"] for entry in next(iter(found.values()))]
    rows = [[name] + [f"{e[k]['relMSEOverRandom']:.2f} ± {e[k]['relMSEError']:.2f} ({e[k]['trimmedOverRandom']:.2f})"
                      for e in found.values()] for k, name in enumerate(names)]
    return markdown(["sampler", *found], rows)


def cost_table(found):
    names = list(next(iter(found.values())))
    rows = [[name] + [f"{best['random'] / best[name]:.2f}" for best in found.values()] for name in names]
    return markdown(["sampler", *(f"{spp} spp" for spp in found)], rows)


def measure(output, assets, quick):
    size, seeds, reference_spp, turns = (32, 2, 256, 1) if quick else (64, 8, 16384, 4)
    names = samplers()
    report = {"size": size, "seeds": seeds, "reference": {"spp": reference_spp, "seed": REFERENCE_SEED}}
    with tempfile.TemporaryDirectory() as folder:
        report["errors"] = {name: scene_errors(folder, scene, options, size, seeds, reference_spp, names)
                            for name, (scene, options) in scenes(assets).items()}
    print(error_table(report["errors"]))
    report["millionPathsPerSecond"] = {spp: cost(names, spp, 64 if quick else 256, turns) for spp in (16, 48)}
    print(cost_table(report["millionPathsPerSecond"]))
    pathlib.Path(output).write_text(json.dumps(report, indent=1) + "\n", encoding="utf-8")
