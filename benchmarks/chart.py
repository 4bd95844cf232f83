#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints a benchmark's CSV file with figures beside their targets, and charts it.

chart.py FILE.csv PICTURE.png

One row of the file is one case, named by its text columns (and `particles`, `ranks`). Every numeric column
becomes a panel. A column `target_X` (or `X_target`) becomes a mark in the panel of X. Columns `ns_...` are
phases, stacked in one panel.
"""
import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

CASE_COLUMNS = ("particles", "ranks", "case")
NOT_FIGURES = ("repeats", "seed")


def number(text):
    try:
        return float(text)
    except (TypeError, ValueError):
        return None


def targetOf(column, columns):
    return next((t for t in ("target_" + column, column + "_target") if t in columns), None)


def isTarget(column):
    return column.startswith("target_") or column.endswith("_target")


def read(source):
    with open(source, newline="") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    if not rows:
        sys.exit(f"chart.py: {source} has no rows")
    columns = [c for c in rows[0] if c]
    numeric = [
        c
        for c in columns
        if c not in CASE_COLUMNS and all(r[c] in ("", None) or number(r[c]) is not None for r in rows)
    ]
    named = [c for c in columns if c not in numeric]
    labels = [
        " ".join(f"{r[c]} {c}" if c in ("particles", "ranks") else str(r[c]) for c in named) for r in rows
    ]
    return rows, [c for c in numeric if c not in NOT_FIGURES], labels


def printTable(rows, numeric, labels):
    for row, label in zip(rows, labels):
        print(label)
        for column in numeric:
            if isTarget(column) or row[column] in ("", None):
                continue
            target = targetOf(column, numeric)
            beside = f"   target {row[target]}" if target and row[target] else ""
            print(f"  {column:28s} {row[column]:>12s}{beside}")


def drawBars(axis, rows, column, target):
    axis.barh(range(len(rows)), [number(r[column]) or 0 for r in rows], color="#3b6ea5")
    if target:
        marks = [(number(r[target]), i) for i, r in enumerate(rows) if number(r[target]) is not None]
        axis.scatter(
            [m[0] for m in marks],
            [m[1] for m in marks],
            marker="|",
            s=260,
            linewidths=2.5,
            color="#d1495b",
            label="target",
        )
        axis.legend(frameon=False, fontsize=8)
    axis.set_title(column.replace("_", " "), fontsize=10)


def drawPhases(axis, rows, phases):
    left = [0.0] * len(rows)
    for phase in phases:
        widths = [number(r[phase]) or 0 for r in rows]
        axis.barh(range(len(rows)), widths, left=left, label=phase[3:].replace("_", " "))
        left = [a + b for a, b in zip(left, widths)]
    axis.set_title("ns per particle and step", fontsize=10)
    axis.legend(frameon=False, fontsize=7, ncols=6, loc="upper left")
    axis.set_xlim(0, 1.05 * max(left))


def main(source, picture):
    rows, numeric, labels = read(source)
    printTable(rows, numeric, labels)
    phases = [c for c in numeric if c.startswith("ns_")]
    panels = [c for c in numeric if not isTarget(c) and c not in phases]
    count = len(panels) + (1 if phases else 0)
    if count == 0:
        sys.exit(f"chart.py: {source} has no numeric column")
    across = min(3, count)
    down = -(-count // across)
    size = (5.2 * across, (0.34 * len(rows) + 1.1) * down)
    figure, axes = plt.subplots(down, across, squeeze=False, figsize=size, layout="constrained")
    for index, axis in enumerate(axes.flat):
        if index >= count:
            axis.axis("off")
            continue
        if index < len(panels):
            drawBars(axis, rows, panels[index], targetOf(panels[index], numeric))
        else:
            drawPhases(axis, rows, phases)
        axis.set_yticks(range(len(rows)), labels if index % across == 0 else [""] * len(rows), fontsize=8)
        axis.set_ylim(len(rows) - 0.4, -1.0)
        axis.spines[["top", "right"]].set_visible(False)
    figure.savefig(picture, dpi=120)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
