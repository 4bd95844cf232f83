#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Error against cost and phases of a step of the sheet benchmark: chart.py FILE.csv FILE.png"""
import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

every = list(csv.DictReader(open(sys.argv[1])))
rows = [r for r in every if r["test"] == "accuracy"]
phases = [r for r in every if r["test"] == "phases"]
cases = list(dict.fromkeys(r["case"] for r in rows))
figure, axes = plt.subplots(1, len(cases) + 1, figsize=(5.5 * (len(cases) + 1), 4.4), squeeze=False)
titles = {"oscillator": "damped oscillator, ten periods", "head": "the head, released from a press"}
for axis, case in zip(axes[0], cases):
    for method, mark in zip(("exact step", "symplectic Euler", "RK4", "implicit Euler"), "osD^"):
        points = sorted(
            (float(r["evaluations"]), max(float(r["value"]), 1e-16))
            for r in rows
            if r["case"] == case and r["method"] == method
        )
        if points:
            axis.loglog(*zip(*points), mark + "-", label=method, markersize=4, linewidth=1)
    axis.set_title(titles.get(case, case), fontsize=10)
    axis.set_xlabel("evaluations of the forces")
    axis.set_ylabel("relative error of the positions")
    axis.grid(True, which="major", alpha=0.3)
    axis.legend(fontsize=8)
axis = axes[0][-1]
bars = list(dict.fromkeys((r["case"], r["evaluations"]) for r in phases))
left = [0.0] * len(bars)
for name in ("motion", "forces", "contact", "rest"):
    values = [
        sum(float(r["value"]) for r in phases if (r["case"], r["evaluations"]) == b and r["method"] == name)
        for b in bars
    ]
    axis.barh(range(len(bars)), values, left=left, label=name)
    left = [a + b for a, b in zip(left, values)]
axis.set_yticks(range(len(bars)), [f"{c}, {float(n):,.0f} vertices" for c, n in bars], fontsize=8)
axis.set_xlabel("ns per vertex and step")
axis.legend(fontsize=8)
figure.tight_layout()
figure.savefig(sys.argv[2], dpi=110)
