#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Gain of sleep: the time of a step over the fraction of sleeping particles, on one core.

  scripts/bench sleep [--across 20] [--steps 100] [--repeats 3]

Ten elastic blocks of ACROSS^3 particles; ten, five, two, one or none of them drift, the others rest. Each
case runs with and without sleep, in turn; the median of the repeats counts. The time of a step covers all
phases except set-up, frames and checkpoint.
"""
import argparse
import csv
import json
import os
import shutil
import statistics
import subprocess
import tempfile

COLUMNS = ["drifting", "asleep_share", "us_per_particle_awake", "us_per_particle_sleep", "gain"]
SCENE = """spacing = 0.05
end = 100
[domain]
min = [-1, -1, -1]
max = [{length}, 4, 4]
gravity = [0, 0, 0]
[material.rubber]
density = 1000
young = 1e6
[numerics]
sleep_speed = {speed}
sleep_after = 1e-3
"""
BODY = """[[body]]
name = "b{k}"
material = "rubber"
box = {{ size = [{size}, {size}, {size}] }}
place = {{ move = [{x}, 1, 1] }}
velocity = [0, {v}, 0]
"""


def scene(across, drifting, sleeps):
    size, far = across * 0.05, across * 0.05 + 0.5
    text = SCENE.format(length=10 * far + 1, speed=1e-3 if sleeps else 0)
    return text + "".join(
        BODY.format(k=k, size=size, x=k * far + size / 2, v=0.1 if k < drifting else 0) for k in range(10)
    )


def microseconds(folder, text, steps):
    path = os.path.join(folder, "sleep.toml")
    with open(path, "w") as file:
        file.write(text)
    out = os.path.join(folder, "out")
    shutil.rmtree(out, ignore_errors=True)
    subprocess.run(
        [os.path.join(os.environ["THAW_BUILD"], "thaw"), "run", path, "--out", out, "--steps", str(steps)],
        check=True,
        stdout=subprocess.DEVNULL,
    )
    with open(os.path.join(out, "summary.json")) as file:
        s = json.load(file)
    spent = sum(
        v["mean"] for k, v in s["phases_s_per_rank"].items() if k not in ("setup", "frames", "checkpoint")
    )
    return 1e6 * spent / steps / s["particles"], s["counters"]["asleep"] / s["particles"]


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--csv", required=True)
    parser.add_argument("--across", type=int, default=20)
    parser.add_argument("--steps", type=int, default=100)
    parser.add_argument("--repeats", type=int, default=3)
    o = parser.parse_args()
    rows = []
    print(f"{'drifting':>8} {'asleep':>8} {'without, us a particle':>24} {'with sleep':>12} {'gain':>6}")
    with tempfile.TemporaryDirectory() as folder:
        for drifting in (10, 5, 2, 1, 0):
            plain, sleep = [], []
            for _ in range(o.repeats):
                plain.append(microseconds(folder, scene(o.across, drifting, False), o.steps)[0])
                us, share = microseconds(folder, scene(o.across, drifting, True), o.steps)
                sleep.append(us)
            a, b = statistics.median(plain), statistics.median(sleep)
            rows.append([drifting, share, a, b, a / b])
            print(f"{drifting:>8} {share:>8.1%} {a:>24.4f} {b:>12.4f} {a / b:>6.2f}", flush=True)
    with open(o.csv, "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(COLUMNS)
        writer.writerows(rows)
    print("asleep: share of the particles in the last step. The first steps of each run are awake.")


if __name__ == "__main__":
    main()
