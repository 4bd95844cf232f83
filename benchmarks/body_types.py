#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Cost of body types that a scene does not have: instructions per step under callgrind, by folder.

  scripts/bench body_types [--steps 6]

Each scene has one body type: liquid, oriented particles or a sheet. Steps N/2 + 1 ... N are counted as the
difference of two runs, inside thaw::step. A function belongs to core/oriented, core/sheet or
core/simulation/body_types if an object of that folder defines it. Inlined functions count where they are
inlined, so that tests for absent body types in step.cpp are in `rest`. Needs valgrind.
"""
import argparse
import csv
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

root = pathlib.Path(__file__).resolve().parent.parent
build = pathlib.Path(os.environ.get("THAW_BUILD", root / "build/release"))
SCENES = [
    ("continuum alone", "dam_break", ["spacing=0.04"], ("oriented", "sheet", "body_types")),
    ("oriented alone", "oriented/relax_plane", ["spacing=0.04"], ("sheet",)),
    ("sheet alone", "sheet/skin", ["sheet.skin.spacing=0.006"], ("oriented",)),
]
FOLDERS = ("oriented", "sheet", "body_types")


def functionsOf(folder):
    place = "simulation/body_types" if folder == "body_types" else folder
    objects = sorted((build / "CMakeFiles/thaw_core.dir/core" / place).rglob("*.o"))
    if not objects:
        sys.exit(f"body_types: no objects of core/{place} in {build}; build thaw first")
    listed = subprocess.run(
        ["nm", "-C", "--defined-only", *map(str, objects)], capture_output=True, text=True, check=True
    ).stdout
    return {m.group(1) for m in re.finditer(r"^[0-9a-f]+ [tT] (.*)$", listed, re.M)}  # no weak ones


def count(scene, settings, steps, folders):
    """Instructions inside thaw::step: {folder: self cost of its functions}, and all."""
    with tempfile.TemporaryDirectory() as work:
        command = [
            "valgrind",
            "--tool=callgrind",
            f"--callgrind-out-file={work}/out",
            "--toggle-collect=thaw::step(*",
            str(build / "thaw"),
            "run",
            str(root / "scenes" / f"{scene}.toml"),
            "--out",
            f"{work}/run",
            "--steps",
            str(steps),
            "--set",
            "output.every=100",
            "--set",
            "numerics.retry_every=0",
        ]
        for s in settings:
            command += ["--set", s]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"{' '.join(command)} failed:\n{done.stdout[-1000:]}{done.stderr[-2000:]}")
        listed = subprocess.run(
            ["callgrind_annotate", "--threshold=100", "--auto=no", f"{work}/out"],
            capture_output=True,
            text=True,
            check=True,
        ).stdout
    costs = dict.fromkeys(FOLDERS, 0)
    every = 0
    for line in listed.splitlines():
        m = re.match(r"\s*([\d,]+) *(?:\([^)]*\))?\s+\S*?:(.*?)(?: \[.*\])?$", line)
        if not m or "PROGRAM TOTALS" in line:
            continue
        cost, name = int(m.group(1).replace(",", "")), m.group(2).strip().removesuffix("'2")
        every += cost
        for folder in FOLDERS:
            if name in folders[folder]:
                costs[folder] += cost
    return costs, every


parser = argparse.ArgumentParser()
parser.add_argument("--csv", default="body_types.csv")
parser.add_argument("--steps", type=int, default=6)
options = parser.parse_args()
if not shutil.which("valgrind"):
    sys.exit("valgrind is not installed (apt-get install valgrind)")
names = {f: functionsOf(f) for f in FOLDERS}
missed = False
with open(options.csv, "w", newline="") as file:
    out = csv.writer(file)
    out.writerow(
        [
            "case",
            "instructions_a_step",
            "oriented",
            "sheet",
            "body_types",
            "rest",
            "of_absent_kinds",
            "target_of_absent_kinds",
        ]
    )
    print(f"{'scene':18} {'a step':>14} {'oriented':>12} {'sheet':>12} {'body_types':>12} {'rest':>12}")
    for name, scene, settings, absent in SCENES:
        first, all1 = count(scene, settings, options.steps // 2, names)
        both, all2 = count(scene, settings, options.steps, names)
        steps = options.steps - options.steps // 2
        each = {f: (both[f] - first[f]) / steps for f in FOLDERS}
        every = (all2 - all1) / steps
        of = sum(each[f] for f in absent)
        missed = missed or of > 0 or every <= 0
        out.writerow(
            [
                name,
                round(every),
                *(round(each[f]) for f in FOLDERS),
                round(every - sum(each.values())),
                round(of),
                0,
            ]
        )
        print(
            f"{name:18} {every:14,.0f} {each['oriented']:12,.0f} {each['sheet']:12,.0f} "
            f"{each['body_types']:12,.0f} {every - sum(each.values()):12,.0f}   "
            f"of absent body types: {of:,.0f}"
        )
if missed:
    sys.exit("body_types: a scene spends instructions on body types that it does not have")
