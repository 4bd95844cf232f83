#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints the scaling study's figures with their targets and charts them.

chart.py SCALING.csv PICTURE.png [TRACE.json]

docs/performance.md takes its figures from docs/scaling/scaling.csv: copy SCALING.csv there and run
benchmarks/performance_chart.py.
"""
import json
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
import model
import summary

BLUE, RED, GREEN, GREY = "#3b6ea5", "#d1495b", "#3a7d44", "#888888"


def finish(axis, title, x, y):
    axis.set_title(title, fontsize=10)
    axis.set_xlabel(x, fontsize=9)
    axis.set_ylabel(y, fontsize=9)
    axis.spines[["top", "right"]].set_visible(False)
    axis.legend(frameon=False, fontsize=8)


def drawEfficiency(axes, path):
    for axis, series, target in zip(axes, ("strong", "weak"), (0.90, 0.92)):
        rows = model.read(path, series)
        if not rows:
            axis.axis("off")
            continue
        ranks = [r["ranks"] for r in rows]
        axis.plot(
            ranks, [r["efficiency"] for r in rows], "o-", color=BLUE, label="against independent copies"
        )
        raw = [r["speedup"] / r["ranks"] for r in rows]
        axis.plot(ranks, raw, "s:", color=GREY, label="against one rank alone")
        axis.axhline(target, color=RED, linestyle="--", label=f"target {target:.0%}")
        axis.set_ylim(0, 1.15)
        axis.set_xticks(ranks)
        finish(
            axis,
            f"{series}: {rows[-1]['particles']:,.0f} particles"
            + (" on most ranks" if series == "weak" else ""),
            "ranks",
            "efficiency",
        )


def drawCounts(axes, path):
    rows = model.read(path)
    many = [r for r in rows if r["ranks"] > 1]
    if not many:
        for axis in axes:
            axis.axis("off")
        return
    c = model.fit(rows)
    ranks = [r["ranks"] for r in many]
    fine = [2 ** (k / 4) for k in range(4, 4 * 14)]
    each = many[-1]["particles"] / many[-1]["ranks"]
    predicted = [model.step(c, model.Machine(), each * p, p) for p in fine]
    axes[0].plot(ranks, [r["messages"] for r in many], "o", color=BLUE, label="messages, mean of ranks")
    axes[0].plot(ranks, [r["messages_max"] for r in many], "x", color=BLUE, label="most of a rank")
    axes[0].plot(fine, [s["messages"] for s in predicted], color=GREY, label="model")
    axes[0].plot(ranks, [r["collectives"] for r in many], "o", color=RED, label="collectives")
    axes[0].plot(
        fine, [c.collectives + c.growth * model.math.log2(p) for p in fine], color=RED, linewidth=0.8
    )
    axes[1].plot(ranks, [r["kib"] for r in many], "o", color=BLUE, label="KiB, mean of ranks")
    axes[1].plot(ranks, [r["kib_max"] for r in many], "x", color=BLUE, label="most of a rank")
    axes[1].plot(fine, [s["bytes"] / 1024 for s in predicted], color=GREY, label="model")
    for axis, title in zip(
        axes, ("sent a step and rank", f"sent a step and rank, {each:,.0f} particles a rank")
    ):
        axis.set_xscale("log", base=2)
        finish(axis, title, "ranks", "number" if axis is axes[0] else "KiB")


def drawModel(axes, path):
    c, m = model.fit(model.read(path)), summary.machineOf(path)
    ranks = [2 ** (k / 2) for k in range(0, 31)]
    for particles, colour in ((1e6, GREY), (1e8, BLUE), (1e9, GREEN), (1e10, RED)):
        fits = [p for p in ranks if particles / p <= 2e7 and particles / p > 1000]
        axes[0].plot(
            fits,
            [1e3 * model.step(c, m, particles, p)["seconds"] for p in fits],
            color=colour,
            label=f"{particles:.0e} particles",
        )
        axes[0].plot(
            fits, [1e3 * particles / p / m.rate for p in fits], color=colour, linestyle=":", linewidth=0.8
        )
    axes[0].set_xscale("log")
    axes[0].set_yscale("log")
    finish(axes[0], "a step, predicted (dotted: work alone)", "ranks", "ms")
    for each, colour in ((1e4, GREY), (1e5, BLUE), (1e6, RED)):
        axes[1].plot(
            ranks,
            [model.efficiency(c, m, each * p, p) for p in ranks],
            color=colour,
            label=f"{each:,.0f} particles a rank",
        )
    axes[1].set_xscale("log")
    axes[1].set_ylim(0, 1.05)
    finish(axes[1], "weak scaling, predicted", "ranks", "efficiency")
    parts = [model.step(c, m, 1e5 * p, p)["parts"] for p in ranks[1:]]
    below = [0.0] * len(parts)
    for name in parts[0]:
        above = [b + 1e3 * s[name] for b, s in zip(below, parts)]
        axes[2].fill_between(ranks[1:], below, above, label=name, alpha=0.8)
        below = above
    axes[2].set_xscale("log")
    finish(axes[2], "parts of a step, 100,000 particles a rank", "ranks", "ms")


def drawTrace(source, picture):
    """Draws the second but last complete step of a trace."""
    with open(source) as f:
        events = json.load(f)["traceEvents"]
    ranks = sorted({e["pid"] for e in events})
    steps = [e for e in events if e.get("cat") == "step"]
    shown = sorted({e["args"]["step"] for e in steps})[-2:]
    begin = min(e["ts"] for e in steps if e["args"]["step"] == shown[0])
    end = max(e["ts"] + e["dur"] for e in steps if e["args"]["step"] == shown[0])
    slices = [e for e in events if e["ph"] == "X" and e["ts"] < end and e["ts"] + e["dur"] > begin]
    names = sorted({e["name"] for e in slices if e["cat"] == "phase"})
    colour = {n: plt.get_cmap("tab20")(k % 20) for k, n in enumerate(names)}
    lanes = {"ghosts": 1.05, "refresh": 1.05, "bonds": 1.45}
    figure, axis = plt.subplots(figsize=(12, 1.1 * len(ranks) + 1.6), layout="constrained")
    for r in ranks:
        for e in (e for e in slices if e["pid"] == r):
            if e["cat"] == "phase":
                axis.broken_barh([(e["ts"] - begin, e["dur"])], (2.2 * r, 1), color=colour[e["name"]])
            elif e["cat"] == "wait":
                axis.broken_barh(
                    [(e["ts"] - begin, e["dur"])],
                    (2.2 * r, 0.45),
                    facecolor="white",
                    edgecolor="black",
                    hatch="////",
                    linewidth=0,
                    zorder=3,
                )
        ends = {e["id"]: e["ts"] for e in events if e["pid"] == r and e["ph"] == "e"}
        for e in (e for e in events if e["pid"] == r and e["ph"] == "b" and begin <= e["ts"] < end):
            axis.broken_barh(
                [(e["ts"] - begin, ends[e["id"]] - e["ts"])],
                (2.2 * r + lanes.get(e["name"], 1.05), 0.35),
                color={"ghosts": "#2a9d8f", "refresh": "#457b9d", "bonds": "#e76f51"}.get(e["name"], GREY),
            )
    for n in names:
        axis.plot([], [], color=colour[n], linewidth=6, label=n)
    for n, c in (
        ("ghosts under way", "#2a9d8f"),
        ("refresh under way", "#457b9d"),
        ("bonds under way", "#e76f51"),
    ):
        axis.plot([], [], color=c, linewidth=3, label=n)
    axis.set_yticks([2.2 * r + 0.5 for r in ranks], [f"rank {r}" for r in ranks])
    axis.set_xlim(0, end - begin)
    axis.set_xlabel("microseconds of a step; hatched: waiting")
    axis.legend(ncols=9, fontsize=7, frameon=False, loc="lower center", bbox_to_anchor=(0.5, 1.0))
    axis.spines[["top", "right"]].set_visible(False)
    figure.savefig(picture, dpi=100)
    plt.close(figure)


def main(source, picture, trace=None):
    print(summary.summary(source))
    figure, axes = plt.subplots(3, 3, figsize=(14, 11), layout="constrained")
    drawEfficiency(axes[0][:2], source)
    axes[0][2].axis("off")
    drawCounts(axes[1][:2], source)
    axes[1][2].axis("off")
    if any(r["ranks"] > 1 for r in model.read(source)):
        drawModel(axes[2], source)
    figure.savefig(picture, dpi=100)
    plt.close(figure)
    trace = trace or os.path.splitext(source)[0] + "_trace.json"
    if os.path.exists(trace):
        drawTrace(trace, os.path.splitext(picture)[0] + "_trace.png")


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    main(*sys.argv[1:])
