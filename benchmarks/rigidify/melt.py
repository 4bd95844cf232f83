#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Errors and time of scenes with rigid parts of elastic solids, relative to the elastic bodies.

  scripts/bench rigidify [--spacing 0.01] [--thresholds 0,0.1,1,3]

Scenes: the bust of scenes/melt.toml, and a cube of 30 MPa that falls by 2 m on a floor and bounces. Time is
that of the processor on one core.
"""
import argparse
import csv
import os
import resource
import subprocess
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
GRAVITY = 9.81
COLUMNS = ["scene", "threshold_per_s", "steps", "cpu_s", "rise_m", "topple_s", "volume_m3", "residual_share"]
CUBE = """spacing = 0.1
end = 1.2
[domain]
min = [-2, -2, -0.5]
max = [2, 2, 4]
gravity = [0, 0, -9.81]
[material.rubber]
law = "neo-hookean"
young = 3e7
density = 1000
damping = 20
[[body]]
name = "cube"
material = "rubber"
box = { size = [0.6, 0.6, 0.6] }
place = { move = [0, 0, 2.3] }
[[obstacle]]
name = "floor"
plane = { point = [0, 0, 0], normal = [0, 0, 1] }
[output]
every = 0.05
"""


def run(folder, scene, options):
    out = tempfile.mkdtemp(dir=folder)
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run(
        [os.path.join(os.environ["THAW_BUILD"], "thaw"), "run", scene, "--out", out]
        + [word for o in options for word in ("--set", o)],
        check=True,
        stdout=subprocess.DEVNULL,
    )
    spent = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    with open(os.path.join(out, "ledger.csv")) as file:
        ledger = list(csv.DictReader(file))
    with open(os.path.join(out, "progress.csv")) as file:
        progress = list(csv.DictReader(file))
    return spent, ledger, progress


def measure(ledger, progress, impact, rebound):
    """impact, rebound (s): the times before which the centre is lowest, and highest after that."""
    mass = float(ledger[0]["mass_kg"])
    at = [(float(r["time_s"]), float(r["gravity_J"]) / mass / GRAVITY) for r in ledger]
    low = min((z, t) for t, z in at if t < impact)
    rise = max(z for t, z in at if low[1] < t < rebound) - low[0]
    topple, lying = "", 0.09  # m
    for (t0, z0), (t1, z1) in zip(at, at[1:]):
        if t0 > 0.4 and z0 >= lying > z1 and topple == "":
            topple = t0 + (t1 - t0) * (z0 - lying) / (z0 - z1)
    volume = progress[-1].get("surface_volume_m3") or ""
    residual = float(progress[-1]["energy_residual_J"]) / float(progress[-1]["energy_scale_J"])
    return rise, topple, volume, residual


def table(rows):
    """Markdown table of rows (COLUMNS) relative to the elastic run of the same scene."""
    lines = [
        "| scene | threshold (1/s) | steps | time (s) | bounce | toppling | volume |",
        "|---|---|---|---|---|---|---|",
    ]
    elastic = {}
    for scene, threshold, steps, spent, *values, _ in rows:
        own = [float(x) if x not in ("", None) else None for x in values]
        if float(threshold) == 0:
            elastic[scene] = own
        errors = [
            "" if b is None else "0" if float(threshold) == 0 else f"{100 * (b / a - 1):+.2f} %"
            for a, b in zip(elastic[scene], own)
        ]
        lines.append(
            "| " + " | ".join([scene, str(threshold), str(steps), f"{float(spent):.2f}"] + errors) + " |"
        )
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--csv", required=True)
    parser.add_argument("--spacing", default="0.01")
    parser.add_argument("--thresholds", default="0,0.1,1,3")
    o = parser.parse_args()
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        cube = os.path.join(folder, "cube.toml")
        with open(cube, "w") as file:
            file.write(CUBE)
        melt = os.path.join(ROOT, "scenes", "melt.toml")
        for name, scene, times, options in (
            ("cube", cube, (0.75, 1.2), []),
            ("melt", melt, (0.18, 0.35), [f"spacing={o.spacing}"]),
        ):
            for threshold in o.thresholds.split(","):
                settings = options + [f"numerics.rigidify={threshold}", "output.ledger_every=0.002"]
                spent, ledger, progress = run(folder, scene, settings)
                rise, topple, volume, residual = measure(ledger, progress, *times)
                rows.append([name, threshold, ledger[-1]["step"], spent, rise, topple, volume, residual])
                print(*rows[-1], flush=True)
    print(table(rows))
    with open(o.csv, "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(COLUMNS)
        writer.writerows(rows)


if __name__ == "__main__":
    main()
