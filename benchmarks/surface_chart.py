#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Charts the surface benchmark by phase with its targets, and prints accuracies.

surface_chart.py FILE.csv PICTURE.png
"""
import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

ITERATION = [
    ("ns_surfel_sums", "sums over surfels"),
    ("ns_particle_sums", "over particles"),
    ("ns_move", "motion"),
    ("ns_exchange", "exchange"),
]
UPDATE = [
    ("ms_iterations", "iterations"),
    ("ms_resampling", "resampling"),
    ("ms_growth", "growth"),
    ("ms_measures", "measures"),
    ("ms_displace", "displacement"),
    ("ms_components", "components"),
    ("ms_fields", "fields"),
    ("ms_place", "place"),
]


def number(text):
    try:
        return float(text)
    except (TypeError, ValueError):
        return 0.0


def bars(axis, rows, phases, label, title):
    left = [0.0] * len(rows)
    for k, (column, name) in enumerate(phases):
        values = [number(r.get(column)) for r in rows]
        axis.barh(range(len(rows)), values, left=left, label=name, color=plt.get_cmap("tab10")(k))
        left = [a + b for a, b in zip(left, values)]
    axis.set_yticks(range(len(rows)), [label(r) for r in rows], fontsize=7)
    axis.invert_yaxis()
    axis.set_title(title, fontsize=9)
    axis.legend(fontsize=7)


every = list(csv.DictReader(open(sys.argv[1], newline="")))
name = list(every[0])[0]
iterations = [r for r in every if r[name].startswith("iteration")]
updates = [r for r in every if r[name].startswith("whole update")]
figure, axes = plt.subplots(2, 1, figsize=(10, 5.5))
if iterations:  # may be empty with --only
    most = 1e6 / next(
        number(r["target_k_surfels_per_s"]) for r in iterations if r["target_k_surfels_per_s"]
    )  # ns
    bars(
        axes[0],
        iterations,
        ITERATION,
        lambda r: r[name].replace("iteration", "iteration,", 1).rstrip(","),
        f"ns a surfel and iteration (target: {most:.0f}, the first line)",
    )
    axes[0].axvline(most, color="#c0392b", linewidth=1)
if updates:
    slowest = 1e3 * number(updates[0]["update_s_target"])
    bars(
        axes[1],
        updates,
        UPDATE,
        lambda r: r[name]
        .replace("whole update of a ", "")
        .replace(" until the local stop", "")
        .split(" (")[0],
        f"ms of a whole update (target: {slowest:.0f})",
    )
    axes[1].axvline(slowest, color="#c0392b", linewidth=1)
for axis, shown in zip(axes, (iterations, updates)):
    axis.set_visible(bool(shown))
figure.tight_layout()
for r in every:
    print("\n" + r[name])
    for column, value in r.items():
        if value and column not in (name, "isa") and "target" not in column:
            goal = r.get("target_" + column) or r.get(column + "_target")
            print(f"  {column:28s} {number(value):10.4g}" + (f"   target {goal}" if goal else ""))
figure.savefig(sys.argv[2], dpi=110)
