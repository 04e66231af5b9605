"""Runs vkpt and reads what it writes."""
import json
import os
import pathlib
import subprocess
import threading

import numpy as np
import OpenImageIO

ROOT = pathlib.Path(__file__).resolve().parents[2]
VKPT = os.environ.get("VKPT") or ROOT / "build" / "release" / "src" / "vkpt"  # which tools/figures has built


def run(*arguments):
    result = subprocess.run([str(VKPT), *map(str, arguments)], capture_output=True, text=True, check=False)
    if result.returncode != 0:
        raise SystemExit(f"figures: vkpt {' '.join(map(str, arguments))}: {result.stderr.strip()}")
    return result.stdout


def samples(*arguments):
    """The JSON of `vkpt samples`."""
    return json.loads(run("samples", "--json", *arguments))


def points(sampler, count, dims=(0, 1), scramble=None, seed=0):
    more = ["--scramble", scramble] if scramble else []
    study = samples("--sampler", sampler, "--count", count, "--dims", ",".join(map(str, dims)), "--seed", seed, *more)
    return np.array(study[0]["points"])


def read_pfm(path):
    """Rows from the top, three channels."""
    with open(path, "rb") as file:
        kind, size, scale = file.readline().strip(), file.readline().split(), float(file.readline())
        width, height = map(int, size)
        channels = 3 if kind == b"PF" else 1
        data = np.frombuffer(file.read(), "<f4" if scale < 0 else ">f4").reshape(height, width, channels)
    return data[::-1].astype(np.float64)


def read_layers(path):
    """The parts of an EXR file by name, R, G and B of each."""
    layers = {}
    for index in range(OpenImageIO.ImageBuf(str(path)).nsubimages):
        part = OpenImageIO.ImageBuf(str(path), index, 0)
        layers[part.spec()["oiio:subimagename"]] = part.get_pixels(OpenImageIO.FLOAT)[..., :3].astype(np.float64)
    return layers


def scene_file(scene):
    """Of a bundled scene by its name, or a path."""
    return ROOT / "scenes" / scene / "scene.gltf" if "/" not in str(scene) else scene


def render(folder, scene, size, spp, sampler, seed=0, *more):
    """`size`: of a square, or (width, height)."""
    width, height = size if isinstance(size, tuple) else (size, size)
    target = pathlib.Path(folder) / f"{threading.get_ident()}.pfm"
    run("render", scene_file(scene), "--size", f"{width}x{height}", "--spp", spp, "--sampler", sampler, "--seed", seed,
        "-q", "-o", target, *more)
    return read_pfm(target)


def relative_mse(image, reference):
    """The relMSE of `vkpt diff`. [Rousselle 11]"""
    return float(np.mean((image - reference) ** 2 / (reference ** 2 + 0.01)))
