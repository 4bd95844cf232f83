#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Bar chart of thaw's figures and those of the paper's Table 1: chart.py CSV PNG."""
import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

with open(sys.argv[1]) as file:
    rows = list(csv.DictReader(file))
scenes = list(dict.fromkeys(r["scene"] for r in rows))
figure, axes = plt.subplots(1, 2, figsize=(10, 4))
for axis, column, title in (
    (axes[0], "physics_step_s", "seconds per physics step"),
    (axes[1], "surface_iteration_s", "seconds per surface iteration"),
):
    for k, (by, colour) in enumerate((("paper", "#b0a090"), ("thaw", "#4050a0"))):
        values = [float(next(r for r in rows if r["scene"] == s and r["by"] == by)[column]) for s in scenes]
        axis.bar([i + 0.4 * k for i in range(len(scenes))], values, 0.38, label=by, color=colour)
    axis.set_yscale("log")
    axis.set_title(title)
    axis.set_xticks([i + 0.2 for i in range(len(scenes))], [s.replace("_", "\n") for s in scenes])
axes[0].legend()
figure.tight_layout()
figure.savefig(sys.argv[2], dpi=120)
