#!/usr/bin/env python3
"""Error against cost, from the CSV of benchmarks/sheet: chart.py FILE.csv FILE.png"""
import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

rows = [r for r in csv.DictReader(open(sys.argv[1])) if r["test"] == "accuracy"]
cases = list(dict.fromkeys(r["case"] for r in rows))
figure, axes = plt.subplots(1, max(1, len(cases)), figsize=(11, 4.4), squeeze=False)
titles = {"oscillator": "damped oscillator, ten periods", "head": "the head, let go from a press"}
for axis, case in zip(axes[0], cases):
    for method, mark in zip(("exact step", "symplectic Euler", "RK4", "implicit Euler"), "osD^"):
        points = sorted((float(r["evaluations"]), max(float(r["value"]), 1e-16)) for r in rows if r["case"] == case and r["method"] == method)
        if points:
            axis.loglog(*zip(*points), mark + "-", label=method, markersize=4, linewidth=1)
    axis.set_title(titles.get(case, case), fontsize=10)
    axis.set_xlabel("evaluations of the forces")
    axis.set_ylabel("relative error of the places")
    axis.grid(True, which="major", alpha=0.3)
    axis.legend(fontsize=8)
figure.tight_layout()
figure.savefig(sys.argv[2], dpi=110)
