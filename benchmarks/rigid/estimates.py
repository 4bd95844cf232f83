#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Estimates of `thaw check` against whole runs of scenes with rigid solids.

  THAW_BUILD=build/release benchmarks/rigid/estimates.py --csv FILE [--scenes boulders,ice_in_water]

The cost of a step is processor time. That of the start is the mean over 40 steps. rigid.py --page shows the
figures of benchmarks/rigid/estimates.csv.
"""
import argparse
import csv
import json
import os
import resource
import subprocess
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
SCENES = os.path.join(os.path.dirname(os.path.dirname(HERE)), "scenes")
COLUMNS = ["scene", "start_steps", "estimated_steps", "steps", "estimated_growth", "growth"]
COLUMNS += ["end_s", "done_s"]
FIRST = 40
STOPPED = 75  # exit code at the time limit


def thaw(*arguments):
    """Returns the output of the program and its processor time (s)."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    program = os.path.join(os.environ["THAW_BUILD"], "thaw")
    done = subprocess.run([program, *arguments], capture_output=True, text=True)
    if done.returncode not in (0, STOPPED):
        done.check_returncode()
    return done.stdout, resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def measure(scene, folder, limit):
    path = os.path.join(SCENES, scene + ".toml")
    estimate = json.loads(thaw("check", path, "--json")[0])["estimate"]
    growth = estimate["growth"]

    def run(name, *arguments):
        out = os.path.join(folder, scene + name)
        spent = thaw("run", path, "--out", out, *arguments)[1]
        with open(os.path.join(out, "summary.json")) as file:
            return spent, json.load(file)

    start = run("-start", "--steps", "1")[0]
    first = (run("-first", "--steps", str(FIRST + 1))[0] - start) / FIRST
    spent, summary = run("-whole", *(["--time-limit", str(limit)] if limit else []))
    steps = summary["step"]
    return [
        scene,
        estimate["steps"] / growth["steps"],
        estimate["steps"],
        steps,
        growth["cost"],
        (spent - start) / steps / first,
        summary["end_s"],
        summary["time_s"],
    ]


def table(rows):
    """Markdown table of the estimates."""
    lines = [
        "| scene | steps by the first ones | estimated | run | cost of a step, estimated | run |",
        "|---|---|---|---|---|---|",
    ]
    for r in rows:
        share = float(r["done_s"]) / float(r["end_s"])
        note = "" if share >= 0.999 else f" (first {100 * share:.0f} %)"
        first, estimated = (float(r[k]) * share for k in ("start_steps", "estimated_steps"))
        lines.append(
            f"| {r['scene']}{note} | {first:,.0f} | {estimated:,.0f} | {int(r['steps']):,} | "
            f"{float(r['estimated_growth']):.2f} | {float(r['growth']):.2f} |"
        )
    return lines


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--csv", required=True)
    parser.add_argument("--scenes", default="boulders,ice_in_water,candle,glass_breaks")
    parser.add_argument("--limit", type=float, help="seconds after which a run stops")
    o = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder, open(o.csv, "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(COLUMNS)
        for scene in o.scenes.split(","):
            row = measure(scene, folder, o.limit)
            writer.writerow(row)
            file.flush()
            print(*row, flush=True)


if __name__ == "__main__":
    main()
