#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Charts of the accuracy suite: chart.py FILE.csv PICTURE.png

Each case has a panel for each norm with a target, or else for its first norm. A panel shows error against
core-seconds. Points are settings; a line joins the default settings over their resolutions. The frontier
joins the points that no other point beats in both time and accuracy. Marks show the target and published
figures of other programs. PICTURE.png holds all panels; a folder of the same name holds one picture per case.
"""
import csv
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

from peers import MARKS

ROUNDING = 1e-16  # an error of exactly 0 is drawn here


def read(path):
    with open(path, newline="") as f:
        return [r for r in csv.DictReader(f) if not r["norm"].startswith("blew up")]


def panels(rows):
    """(case, norm) in the order of the file.

    The norms are those with a target above rounding, else the case's first norm.
    """
    found = {}
    for r in rows:
        norms = found.setdefault(r["case"], [])
        if r["norm"] not in norms:
            norms.append(r["norm"])
    chosen = []
    for case, norms in found.items():
        targets = {r["norm"]: float(r["target"]) for r in rows if r["case"] == case and r["target"]}
        good = [n for n in norms if targets.get(n, 0) > 1e-9] or norms[:1]
        chosen += [(case, n) for n in good]
    return chosen


def frontier(points):
    best, line = float("inf"), []
    for seconds, error, label in sorted(points):
        if error < best:
            best = error
            line.append((seconds, error, label))
    return line


def draw(axes, rows, case, norm):
    rows = [r for r in rows if r["case"] == case and r["norm"] == norm]
    points = [
        (max(1e-3, float(r["core_seconds"])), max(ROUNDING, float(r["error"])), r["settings"]) for r in rows
    ]
    defaults = sorted(p for p in points if p[2].startswith("default"))
    others = [p for p in points if not p[2].startswith("default")]
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.scatter([p[0] for p in others], [p[1] for p in others], s=18, color="#8a9bb0", zorder=2)
    axes.plot(
        [p[0] for p in defaults], [p[1] for p in defaults], "o-", color="#1f4e8c", label="defaults", zorder=4
    )
    for p in points:
        words = p[2].split()
        text = words[-1] if words[0] == "default" else " ".join(words[:-1])
        axes.annotate(
            text,
            p[:2],
            fontsize=5,
            xytext=(3, 2),
            textcoords="offset points",
            color="#1f4e8c" if words[0] == "default" else "#4a5563",
        )
    line = frontier(points)
    axes.step(
        [p[0] for p in line],
        [p[1] for p in line],
        where="post",
        color="#2e8b57",
        lw=1,
        label="frontier",
        zorder=3,
    )
    target = next((float(r["target"]) for r in rows if r["target"]), None)
    if target:
        axes.axhline(target, color="#c0392b", ls="--", lw=1, label=f"target {target:g}")
    for name, error, seconds in MARKS.get(case, {}).get(norm, []):
        if error:
            axes.axhline(error, color="#b8860b", ls=":", lw=1)
            axes.annotate(
                name,
                (0.02, error),
                xycoords=("axes fraction", "data"),
                fontsize=5,
                color="#8a6508",
                va="bottom",
            )
        else:
            axes.axvline(seconds, color="#b8860b", ls=":", lw=1)
            axes.annotate(
                name,
                (seconds, 0.02),
                xycoords=("data", "axes fraction"),
                fontsize=5,
                color="#8a6508",
                rotation=90,
                ha="right",
            )
    axes.set_title(f"{case}: {norm}", fontsize=8)
    axes.set_xlabel("core-seconds", fontsize=7)
    axes.set_ylabel("error", fontsize=7)
    axes.tick_params(labelsize=6)
    axes.grid(True, which="major", lw=0.3)
    axes.legend(fontsize=5, loc="best")


def main(path, picture):
    rows = read(path)
    every = panels(rows)
    columns = min(4, max(1, len(every)))
    lines = max(1, -(-len(every) // columns))
    figure, axes = plt.subplots(lines, columns, figsize=(4 * columns, 3.2 * lines), squeeze=False)
    for a in axes.flat[len(every) :]:
        a.axis("off")
    for a, (case, norm) in zip(axes.flat, every):
        draw(a, rows, case, norm)
    figure.tight_layout()
    figure.savefig(picture, dpi=110)
    folder = os.path.splitext(picture)[0]
    os.makedirs(folder, exist_ok=True)
    for case in dict.fromkeys(c for c, _ in every):
        norms = [n for c, n in every if c == case]
        figure, axes = plt.subplots(1, len(norms), figsize=(5.2 * len(norms), 3.9), squeeze=False)
        for a, n in zip(axes.flat, norms):
            draw(a, rows, case, n)
        figure.tight_layout()
        figure.savefig(os.path.join(folder, case + ".png"), dpi=110)
        plt.close(figure)


if __name__ == "__main__":
    main(*sys.argv[1:3])
