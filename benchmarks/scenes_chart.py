#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Whole scenes against the step benchmark: fractions of its rate, and phases.

scenes_chart.py FILE.csv PICTURE.png
"""
import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

rows = list(csv.DictReader(open(sys.argv[1], newline="")))
for r in rows:
    print(
        f"{r['case']:20s} {int(r['particles']):9d} particles, {r['ranks']} ranks: "
        f"{float(r['msteps_per_s']):6.3f} M particle-steps/s and core, "
        f"{100 * float(r['share']):3.0f} % of the step benchmark's {float(r['step_benchmark']):.3f} "
        f"(target {100 * float(r['target_share']):.0f} %), {100 * float(r['liquid']):.1f} % liquid at the end"
    )
figure, axes = plt.subplots(1, 2, figsize=(11, 1.4 + 0.5 * len(rows)), sharey=True)
at, names = range(len(rows)), [f"{r['case']}, {int(r['particles']):,}" for r in rows]
axes[0].barh(at, [float(r["share"]) for r in rows], color="#3b6ea5")
axes[0].plot(
    [float(r["target_share"]) for r in rows], at, "|", color="#c0392b", markersize=14, markeredgewidth=2
)
axes[0].set_title("share of the step benchmark's rate", fontsize=9)
left = [0.0] * len(rows)
for k, column in enumerate(c for c in rows[0] if c.startswith("ns_")):
    values = [float(r[column]) for r in rows]
    axes[1].barh(at, values, left=left, label=column[3:], color=plt.get_cmap("tab10")(k))
    left = [a + b for a, b in zip(left, values)]
axes[1].legend(fontsize=7)
axes[1].set_title("ns per particle, step and core", fontsize=9)
axes[0].set_yticks(list(at), names, fontsize=8)
axes[0].invert_yaxis()
figure.tight_layout()
figure.savefig(sys.argv[2], dpi=110)
