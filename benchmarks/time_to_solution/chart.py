#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Wall-clock seconds per simulated second against the error, one mark per solver.

chart.py FILE.csv PICTURE.png
"""
import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt


def errorText(r):
    return (
        f"error {100 * float(r['error']):6.2f} %"
        if float(r["error"]) >= 0
        else "error unknown (too short a run)"
    )


rows = list(csv.DictReader(open(sys.argv[1], newline="")))
for r in rows:
    print(
        f"{r['case']:5s} {r['solver']:36s} {float(r['wall_s_per_s']):7.1f} s "
        f"(target {r['target_wall_s_per_s']}, goal 10, best peer {r['best_peer_wall_s_per_s']})   "
        f"{errorText(r)}   {r['steps']} steps on {r['ranks']} ranks"
    )
problems = list(dict.fromkeys(r["case"] for r in rows))
figure, axes = plt.subplots(1, len(problems), figsize=(5.5 * len(problems), 4), squeeze=False)
for axis, problem in zip(axes[0], problems):
    mine = [r for r in rows if r["case"] == problem]
    for k, r in enumerate(mine):
        axis.plot(
            float(r["wall_s_per_s"]),
            100 * abs(float(r["error"])),
            "o",
            color=plt.get_cmap("tab10")(k),
            label=r["solver"],
        )
    for x, style, name in (
        (10, ":", "goal"),
        (15, "--", "target"),
        (float(mine[0]["best_peer_wall_s_per_s"]), "-", "best peer"),
    ):
        axis.axvline(x, color="#555555", linestyle=style, linewidth=1)
        axis.text(x, axis.get_ylim()[1], name, fontsize=7, rotation=90, va="top", ha="right")
    axis.set_xscale("log")
    axis.set_xlabel("wall-clock s per simulated second", fontsize=8)
    axis.set_ylabel("error, %", fontsize=8)
    axis.set_ylim(bottom=0)
    axis.set_title(problem, fontsize=9)
    axis.legend(fontsize=7)
figure.tight_layout()
figure.savefig(sys.argv[2], dpi=110)
