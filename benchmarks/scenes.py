#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Whole scenes against the step benchmark: the fraction of its rate, and the time of each phase.

  scripts/bench scenes [--quick] [--ranks 4] [--steps 300]

dam_break with a million particles, beam, melt and melt_large run as in their files, but with a frame every
100 steps. The bust is solid in its first thousands of steps. It is measured as such (melt), and with a
quarter molten from the start by temperatures that depend on the height (melting). After each scene, the step
benchmark runs the same physics, size and precision on as many ranks. Both rates thus see the same machine.
--steps is a minimum: small scenes take a thousand, so that the first frame weighs little. --quick: dam_break
with 100,000 particles, beam and melt, on one rank.
"""
import argparse
import csv
import json
import os
import pathlib
import shutil
import subprocess
import sys

root = pathlib.Path(__file__).resolve().parent.parent
build = pathlib.Path(os.environ.get("THAW_BUILD", root / "build/release"))

# 80 degC at its foot, 5 at half its height, -70 at its top; it melts from 40 to 65 degC
MELTING = ['body.bust.temperature="5 degC"', "body.bust.temperature_gradient=[0, 0, -500]"]
# scene, overrides, (case, precision, support) of the step benchmark
SCENES = [
    ("dam_break", ["spacing=0.005"], ("fluid", "single", "2")),
    ("beam", [], ("elastic", "double", "1.7")),
    ("melt", [], ("mixed", "default", "2")),
    ("melt", MELTING, ("mixed", "default", "2")),
    ("melt_large", MELTING, ("mixed", "default", "2")),
]
QUICK = [("dam_break", ["spacing=0.0108"], ("fluid", "single", "2")), *SCENES[1:4]]
TARGET = 0.7
# columns of the CSV file, and the phases of the program whose time each one sums
GROUPS = {
    "search": ["sort", "search"],
    "pairs": ["density", "forces", "viscosity", "pressure"],
    "solids": ["elastic", "bonds", "contact"],
    "walls": ["walls"],
    "heat": ["heat", "phase_change"],
    "motion": ["drift", "kick", "domain"],
    "ranks": ["migrate", "exchange", "reduce", "balance"],
    "surface": ["surface"],
    "frames": ["frames"],
}


def mpirun(ranks, *command):
    environment = dict(
        os.environ,
        OMPI_ALLOW_RUN_AS_ROOT="1",
        OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
        OMPI_MCA_btl_vader_single_copy_mechanism="none",
        OMPI_MCA_rmaps_base_oversubscribe="1",
        OMPI_MCA_hwloc_base_binding_policy="none",
    )
    done = subprocess.run(
        ["mpirun", "-q", "-n", str(ranks), *map(str, command)],
        env=environment,
        capture_output=True,
        text=True,
    )
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))} failed:\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    return done.stdout


def run(scene, overrides, ranks, steps, folder):
    shutil.rmtree(folder, ignore_errors=True)
    sets = [x for o in overrides for x in ("--set", o)]
    mpirun(
        ranks,
        build / "thaw",
        "run",
        root / "scenes" / f"{scene}.toml",
        "--out",
        folder,
        "--steps",
        steps,
        *sets,
    )
    return json.loads((folder / "summary.json").read_text())


def stepBenchmark(physics, ranks, particles, table):
    """The row of the step benchmark with the same physics; table: its CSV file."""
    case, precision, support = physics
    mpirun(
        ranks,
        build / "benchmarks/step",
        "--cases",
        case,
        "--precisions",
        precision,
        "--supports",
        support,
        "--sizes",
        min(particles, 1000000),
        "--repeat",
        3,
        "--seconds",
        0.5,
        "--csv",
        table,
    )
    return next(csv.DictReader(table.open()))


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--csv", default="out/bench/scenes.csv")
    parser.add_argument("--ranks", type=int, default=4)
    parser.add_argument("--steps", type=int, default=300)
    parser.add_argument("--quick", action="store_true")
    options = parser.parse_args()
    if options.quick:
        options.ranks, options.steps = 1, 100
    folder = pathlib.Path(options.csv).resolve().parent / "scenes_run"
    rows = []
    for scene, overrides, physics in QUICK if options.quick else SCENES:
        first = run(scene, overrides, options.ranks, 1, folder)  # gives dt, for frames every 100 steps
        every = f"output.every={100 * first['dt_s']}"
        particles = first["particles"]
        steps = max(options.steps, 1000 if particles < 200000 else 0)
        s = run(scene, [*overrides, every], options.ranks, steps, folder)
        phases = {name: p["mean"] for name, p in s["phases_s_per_rank"].items()}
        looped = sum(t for name, t in phases.items() if name not in ("setup", "none", "checkpoint"))
        rate = particles * s["steps_of_this_process"] / looped / options.ranks / 1e6
        beside = stepBenchmark(physics, options.ranks, particles, folder.parent / "scenes_step.csv")
        row = {
            "case": scene + (", melting" if overrides is MELTING else ""),
            "liquid": round(s["liquid_fraction"], 3),
            "ranks": options.ranks,
            "particles": particles,
            "msteps_per_s": round(rate, 3),
            "step_benchmark": round(float(beside["msteps_per_s"]), 3),
            "share": round(rate / float(beside["msteps_per_s"]), 3),
            "target_share": TARGET,
            "yardstick_ratio": round(rate / float(beside["yardstick_msteps_per_s"]), 2),
        }
        perNs = 1e9 * options.ranks / (particles * s["steps_of_this_process"])
        for name, members in GROUPS.items():
            row["ns_" + name] = round(perNs * sum(phases.get(m, 0) for m in members), 1)
        row["ns_other"] = round(perNs * looped - sum(v for k, v in row.items() if k.startswith("ns_")), 1)
        rows.append(row)
        print(
            f"{row['case']}: {row['msteps_per_s']} M particle-steps/s and core, "
            f"{100 * row['share']:.0f} % of the step benchmark's; "
            f"{100 * row['liquid']:.1f} % liquid at the end",
            flush=True,
        )
    shutil.rmtree(folder, ignore_errors=True)
    with open(options.csv, "w", newline="") as out:
        writer = csv.DictWriter(out, rows[0].keys())
        writer.writeheader()
        writer.writerows(rows)


if __name__ == "__main__":
    main()
