#!/usr/bin/env python3
"""Copies of the reference's sources that hold every planted fault, each behind a switch that VKPT_PLANTED_FAULT sets.

plant_faults.py --list                 the files that faults.json edits, relative to the root
plant_faults.py FOLDER                 writes their copies to FOLDER, without src/, and planted_fault.h
"""
import json
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
HEADER = """// Written by tests/verify/plant_faults.py.
#pragma once
#include <cstdlib>

namespace vkpt {
/// Place in faults.json of the fault that is active; -1: none.
inline const int plantedFault =
    std::getenv("VKPT_PLANTED_FAULT") != nullptr ? std::atoi(std::getenv("VKPT_PLANTED_FAULT")) : -1;
}  // namespace vkpt
"""


def edits():
    """Of every edited file the (number, right, broken) of its faults."""
    files = {}
    for number, fault in enumerate(json.loads((HERE / "faults.json").read_text())["faults"]):
        if fault["file"].startswith("src/"):
            files.setdefault(fault["file"], []).append((number, fault["right"], fault["broken"]))
    return files


def plant(text, faults):
    for number, right, broken in faults:
        if text.count(right) != 1:
            sys.exit(f"fault {number}: its text stands {text.count(right)} times, not once: {right}")
        text = text.replace(right, f"(::vkpt::plantedFault == {number} ? ({broken}) : ({right}))")
    return '#include "planted_fault.h"\n' + text


def main():
    if sys.argv[1:] == ["--list"]:
        print(";".join(edits()), end="")
        return
    folder = pathlib.Path(sys.argv[1])
    for file, faults in edits().items():
        copy = folder / pathlib.Path(file).relative_to("src")
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text(plant((ROOT / file).read_text(), faults))
    (folder / "planted_fault.h").write_text(HEADER)


main()
