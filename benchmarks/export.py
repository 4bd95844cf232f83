#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Core-seconds of an exported frame and of a picture.

  scripts/bench export [--repeat 3]

usd: a frame of a surface mesh of 100,000 vertices (a ball with 80,000 surfels), `thaw export --as usd`.
picture: 60,000 surfels with three solid obstacles at 800 x 600, `thaw render`. Both use one thread, and the
figures are medians. Targets: 100 of each in 60 s on two cores.
"""
import argparse
import csv
import os
import pathlib
import resource
import statistics
import subprocess
import tempfile

root = pathlib.Path(__file__).resolve().parent.parent
build = pathlib.Path(os.environ.get("THAW_BUILD", root / "build/release"))
TARGET = 1.2  # core-seconds
SCENE = """
spacing = 0.05
end = 1
[domain]
min = [-3, -3, -3]
max = [3, 3, 3]
gravity = [0, 0, 0]
[material.wax]
young = "100 kPa"
[[body]]
sphere = {{ radius = 0.5 }}
material = "wax"
{obstacles}
[surface]
spacing = {spacing}
[output]
every = 1
width = 800
height = 600
"""
BOX = '[[obstacle]]\nbox = {{ size = [0.8, 0.6, 0.4] }}\nplace = {{ move = [{}, {}, 0] }}\nlook = "solid"'


def thaw(*arguments):
    """Runs thaw, and returns its core-seconds."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([build / "thaw", *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def frameOf(work, name, surfels, obstacles):
    """Makes the first frame of a ball with about this number of surfels."""
    scene = work / f"{name}.toml"
    spacing = (3.14159 / surfels) ** 0.5 * 1.05
    scene.write_text(SCENE.format(spacing=spacing, obstacles=obstacles))
    thaw("run", scene, "--steps", 1, "--out", work / name)
    return next((work / name / "frames").glob("*_surface_000000.hdf"))


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--repeat", type=int, default=3)
    options.add_argument("--csv", required=True)
    options = options.parse_args()
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        boxes = "\n".join(BOX.format(x, y) for x, y in ((1.2, 0), (-1.2, 0), (0, 1.2)))
        ball, staged = frameOf(work, "ball", 80000, ""), frameOf(work, "staged", 60000, boxes)
        cases = (
            (
                "usd",
                [
                    "export",
                    ball,
                    "--as",
                    "usd",
                    "--threads",
                    1,
                    "--out",
                    work / "ball.usdc",
                ],
            ),
            ("picture", ["render", staged, "--threads", 1, "--out", work / "picture"]),
        )
        for case, command in cases:
            cost = statistics.median(thaw(*command) for _ in range(options.repeat))
            rows.append(
                {
                    "case": case,
                    "core_seconds": f"{cost:.3f}",
                    "target_core_seconds": TARGET,
                }
            )
    with open(options.csv, "w", newline="") as file:
        writer = csv.DictWriter(file, rows[0])
        writer.writeheader()
        writer.writerows(rows)


main()
