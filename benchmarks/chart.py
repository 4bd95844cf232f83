#!/usr/bin/env python3
"""Bar charts of a benchmark's CSV file: chart.py FILE.csv PICTURE.png

One row of the file is one case, named by its text columns (and `particles`, `ranks`); every numeric column becomes a panel.
A column `X_target` is drawn as a mark on the panel of X.
"""
import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

CASE_COLUMNS = ("particles", "ranks", "case")


def number(text):
    try:
        return float(text)
    except ValueError:
        return None


def main(source, picture):
    with open(source, newline="") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    if not rows:
        sys.exit(f"chart.py: {source} holds no rows")
    columns = list(rows[0])
    numeric = [c for c in columns if c not in CASE_COLUMNS and all(r[c] == "" or number(r[c]) is not None for r in rows)]
    named = [c for c in columns if c not in numeric]
    panels = [c for c in numeric if not c.endswith("_target") and any(r[c] != "" for r in rows)]
    if not panels:
        sys.exit(f"chart.py: {source} holds no numeric column")
    labels = [" ".join(f"{r[c]} {c}" if c in ("particles", "ranks") else r[c] for c in named) for r in rows]
    across = min(3, len(panels))
    down = -(-len(panels) // across)
    figure, axes = plt.subplots(down, across, squeeze=False, figsize=(5.2 * across, (0.32 * len(rows) + 1.2) * down), layout="constrained")
    places = range(len(rows))
    for index, axis in enumerate(axes.flat):
        if index >= len(panels):
            axis.axis("off")
            continue
        column = panels[index]
        axis.barh(places, [number(r[column]) or 0 for r in rows], color="#3b6ea5")
        target = column + "_target"
        if target in numeric:
            marks = [(number(r[target]), i) for i, r in enumerate(rows) if r[target] != ""]
            axis.scatter([m[0] for m in marks], [m[1] for m in marks], marker="|", s=220, color="#d1495b", label="target")
            axis.legend(frameon=False, fontsize=8)
        axis.set_title(column.replace("_", " "), fontsize=10)
        axis.set_yticks(places, labels if index % across == 0 else [""] * len(rows), fontsize=8)
        axis.invert_yaxis()
        axis.spines[["top", "right"]].set_visible(False)
    figure.savefig(picture, dpi=120)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
