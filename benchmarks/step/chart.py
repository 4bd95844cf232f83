#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints the rows of the step benchmark with their targets and charts them: chart.py FILE.csv PICTURE.png.

PICTURE.md holds the same table. With many rows the chart shows those with 33 neighbours in single precision.
"""
import csv
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

PHASES = ["sort", "search", "density", "force", "elastic", "walls", "heat", "move", "ranks"]


def number(text):
    return float(text) if text else None


def label(r):
    size = float(r["particles"])
    size = f"{size / 1e6:.3g}M" if size > 9e5 else f"{size / 1e3:.0f}k"
    ranks = f"{r['ranks']} rank{'s' if r['ranks'] != '1' else ''}"
    isa = "" if r["isa"] == "avx512" else f" {r['isa'].upper()}"
    return f"{r['case']} {r['precision']}{isa} {float(r['neighbours']):.0f} nb, {size}, {ranks}"


def show(rows):
    print(
        f"{'':44s}  M/s/core       ratio     target  limit   bytes (target)   "
        "moved GB/s of copy  set-up steps (20)  limited by"
    )
    for r in rows:
        goal = (
            f"{number(r['target_ratio']):9.2f} {number(r['limit_ratio']):6.2f}"
            if r["target_ratio"]
            else f"{'-':>9s} {'-':>6s}"
        )
        memory = f"{float(r['bytes_per_particle']):6.0f} ({r['target_bytes_per_particle'] or '-':>4s})"
        print(
            f"{label(r):44s}  {float(r['msteps_per_s']):8.2f}  {float(r['ratio']):10.2f}  {goal}   "
            f"{memory:>14s}   {float(r['moved_gb_per_s']):5.1f} of {float(r['copy_gb_per_s']):5.1f}   "
            f"{float(r['setup_steps']):15.1f}   {r['held_back_by']}"
        )


def nominal(r):
    return 33 if float(r["neighbours"]) < 50 else 74


def table(rows, path):
    """Writes a Markdown table with a row for all numbers of ranks; bold: the target is reached."""
    ranks = sorted({int(r["ranks"]) for r in rows})
    cases = {}
    for r in rows:
        isa = "" if r["isa"] == "avx512" else f", {r['isa'].upper()}"
        cases.setdefault((f"{r['case']}, {r['precision']}{isa}, {nominal(r)}", r["particles"]), {})[
            int(r["ranks"])
        ] = r

    def times(r):
        ratio, target = number(r["ratio"]), number(r["target_ratio"])
        return f"**{ratio:.2f}**" if target and ratio >= target else f"{ratio:.2f}"

    def over(row, shown):
        return " / ".join(shown(row[p]) if p in row else "-" for p in ranks)

    def held(row):
        names = [row[p]["held_back_by"] for p in ranks if p in row]
        return (
            names[0]
            if len(set(names)) == 1
            else " / ".join(row[p]["held_back_by"] if p in row else "-" for p in ranks)
        )

    heads = " / ".join(str(p) for p in ranks)
    with open(path, "w", encoding="utf-8") as out:
        out.write(
            f"| case, precision, neighbours | particles | M/s and core on {heads} ranks "
            "| times the scalar code | target | limit | bytes a particle | set-up, steps | held back by |\n"
            "|---|---|---|---|---|---|---|---|---|\n"
        )
        for (case, particles), row in cases.items():
            first = row[min(row)]
            goal = (
                f"{number(first['target_ratio']):.2f} | {number(first['limit_ratio']):.1f}"
                if first["target_ratio"]
                else " | "
            )
            out.write(
                f"| {case} | {float(particles):,.0f} "
                f"| {over(row, lambda r: format(float(r['msteps_per_s']), '.2f'))} "
                f"| {over(row, times)} | {goal} "
                f"| {over(row, lambda r: format(float(r['bytes_per_particle']), '.0f'))} "
                f"| {over(row, lambda r: format(float(r['setup_steps']), '.0f'))} | {held(row)} |\n"
            )


def draw(rows, picture):
    if len(rows) > 45:  # the table has all rows
        rows = [r for r in rows if nominal(r) == 33 and r["precision"] == "single" and r["case"] != "mesh"]
    figure, axes = plt.subplots(1, 3, figsize=(15, 1.2 + 0.27 * len(rows)), sharey=True)
    at = range(len(rows))
    axes[0].barh(at, [number(r["ratio"]) for r in rows], color="#3b6ea5")
    for column, colour, name in (
        ("target_ratio", "#c0392b", "target"),
        ("limit_ratio", "#555555", "limit of the prototypes"),
    ):
        marks = [(number(r[column]), i) for i, r in enumerate(rows) if r[column]]
        if marks:
            axes[0].plot(
                [m for m, _ in marks],
                [i for _, i in marks],
                "|",
                color=colour,
                markersize=11,
                markeredgewidth=2,
                label=name,
            )
            axes[0].legend(fontsize=7, loc="lower right")
    axes[0].set_title("times the scalar code", fontsize=9)
    left = [0.0] * len(rows)
    for k, phase in enumerate(PHASES):
        values = [float(r["ns_" + phase]) for r in rows]
        axes[1].barh(at, values, left=left, label=phase, color=plt.get_cmap("tab10")(k))
        left = [a + b for a, b in zip(left, values)]
    axes[1].legend(
        fontsize=7,
        loc="upper center",
        bbox_to_anchor=(0.5, -0.03),
        ncols=len(PHASES),
        columnspacing=0.8,
        handlelength=1,
    )  # outside of the bars
    axes[1].set_title("ns per particle, step and core", fontsize=9)
    axes[2].barh(at, [float(r["bytes_per_particle"]) for r in rows], color="#7a9e6f")
    marks = [
        (number(r["target_bytes_per_particle"]), i)
        for i, r in enumerate(rows)
        if r["target_bytes_per_particle"]
    ]
    axes[2].plot(
        [m for m, _ in marks], [i for _, i in marks], "|", color="#c0392b", markersize=11, markeredgewidth=2
    )
    axes[2].set_title("bytes per particle", fontsize=9)
    axes[0].set_yticks(list(at), [label(r) for r in rows], fontsize=7)
    axes[0].margins(y=0.01)
    axes[0].invert_yaxis()
    figure.tight_layout()
    figure.savefig(picture, dpi=110)


rows = list(csv.DictReader(open(sys.argv[1], newline="")))
show(rows)
table(rows, os.path.splitext(sys.argv[2])[0] + ".md")
draw(rows, sys.argv[2])
