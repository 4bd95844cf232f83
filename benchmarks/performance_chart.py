#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes docs/performance.md and its chart.

The text is performance/text.md; the figures are in docs/performance/ and docs/scaling/.

performance_chart.py [--check]    --check compares the page with the figures and needs no matplotlib
Placeholders of performance/text.md: {{table}}, {{carried}}, {{view}}, {{machine}}, and {{predicted PARTICLES
RANKS}}, an efficiency of the scaling model.
"""
import csv
import os
import re
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
DOCS = os.path.join(HERE, "..", "docs")
SCALING = os.path.join(DOCS, "scaling", "scaling.csv")
sys.path.insert(0, os.path.join(HERE, "scaling"))
import model  # noqa: E402
import summary  # noqa: E402

HEAD = ["case", "particles", "ranks", "M steps/s and core", "ratio", "reference", "bytes per particle"]


def rowsOf(*path):
    with open(os.path.join(DOCS, *path), newline="") as f:
        return list(csv.DictReader(f))


def isShown(r):
    """True for millions of particles with 33 neighbours on one or two ranks.

    Double precision is shown for liquids only.
    """
    return (
        float(r["neighbours"]) < 50
        and float(r["particles"]) >= 1e6
        and int(r["ranks"]) <= 2
        and r["isa"] == "avx512"
        and (r["precision"] == "single" or r["case"] == "fluid")
    )


def stepRows():
    names = {"single": "", "double": ", double precision"}
    return [
        [
            f"step: {r['case']}{names[r['precision']]}",
            f"{float(r['particles']):,.0f}",
            r["ranks"],
            f"{float(r['msteps_per_s']):.2f}",
            f"{float(r['ratio']):.2f}",
            "scalar code",
            f"{float(r['bytes_per_particle']):.0f}",
        ]
        for r in rowsOf("performance", "step.csv")
        if isShown(r)
    ]


def sceneRows():
    return [
        [
            f"scene: {r['case']}",
            f"{float(r['particles']):,.0f}",
            r["ranks"],
            f"{float(r['msteps_per_s']):.2f}",
            f"{float(r['share']):.2f}",
            "step benchmark",
            "",
        ]
        for r in rowsOf("performance", "scenes.csv")
    ]


def scalingRows():
    rows = []
    for series in ("strong", "weak"):
        for r in model.read(SCALING, series):
            if r["ranks"] > 1:
                rows.append(
                    [
                        series,
                        f"{r['particles']:,.0f}",
                        f"{r['ranks']:.0f}",
                        f"{r['msteps_per_s'] / r['ranks']:.2f}",
                        f"{r['efficiency']:.3f}",
                        "copies",
                        "",
                    ]
                )
    return rows


def sleepRows():
    return [
        [
            f"sleep: {float(r['asleep_share']):.0%} asleep".replace("%", " %"),
            "80,000",
            "1",
            f"{float(r['us_per_particle_sleep']):.2f} us",
            f"{float(r['gain']):.2f}",
            "awake",
            "",
        ]
        for r in rowsOf("performance", "sleep.csv")
    ]


def table():
    rows = stepRows() + sceneRows() + scalingRows() + sleepRows()
    return "\n".join("| " + " | ".join(r) + " |" for r in [HEAD, ["---"] * len(HEAD), *rows])


def predicted(particles, ranks):
    counts, machine = model.fit(model.read(SCALING)), summary.machineOf(SCALING)
    efficiency = 100 * model.efficiency(counts, machine, float(particles), int(ranks))
    return f"{efficiency:.0f} % for {float(particles):,.0f} particles on {int(ranks):,} ranks"


def machine():
    row = model.read(SCALING, "strong")[0]
    return f"{row['machine']} with thaw {row['version']}"


def view():
    """Returns the cost of a view for a run and the rate of its pictures."""

    def first(name, case):
        row = next(r for r in rowsOf("performance", name + ".csv") if r["case"] == case)
        return float(row["value"]), row

    instructions, _ = first("view_instructions", "cost followed")
    rate, drawn = first("view_pictures", "particles and surface, in motion")
    script, _ = first("view_pictures", "particles and surface, script of a picture")
    return (
        f"a page that follows a run adds {instructions:.2g} % to the run's instructions. A picture takes "
        f"{script:.1f} ms in JavaScript. Without a GPU, {int(drawn['particles']):,} particles and a surface "
        f"of {int(drawn['vertices']):,} vertices are drawn {rate:.0f} times a second in motion"
    )


def carried():
    """Returns the cost of carried densities over summed ones, in time and memory."""
    summed, own = rowsOf("performance", "carried.csv")
    time = float(summed["ratio"]) / float(own["ratio"])
    memory = float(own["bytes_per_particle"]) - float(summed["bytes_per_particle"])
    return f"{time:.2f} times the time of summed ones, and {memory:.0f} bytes more per particle"


def page():
    with open(os.path.join(HERE, "performance", "text.md")) as f:
        text = f.read()
    made = {"view": view, "table": table, "machine": machine, "predicted": predicted, "carried": carried}
    return re.sub(r"\{\{(\w+)\s*([^}]*)\}\}", lambda m: made[m[1]](*m[2].split()), text)


def draw(picture):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(1, 3, figsize=(14, 4), layout="constrained")
    steps = [r for r in rowsOf("performance", "step.csv") if isShown(r)]
    axes[0].barh(
        [
            f"{r['case']} {r['precision']}, {float(r['particles']) / 1e6:.0f}M, "
            f"{r['ranks']} rank{'s' if r['ranks'] != '1' else ''}"
            for r in steps
        ],
        [float(r["ratio"]) for r in steps],
        color="#3b6ea5",
    )
    axes[0].set_xlabel("times the scalar code")
    axes[0].invert_yaxis()
    for series, style in (("strong", "o-"), ("weak", "s--")):
        rows = model.read(SCALING, series)
        axes[1].plot([r["ranks"] for r in rows], [r["efficiency"] for r in rows], style, label=series)
    axes[1].set_ylim(0, 1.1)
    axes[1].set_xticks([r["ranks"] for r in model.read(SCALING, "strong")])
    axes[1].set_xlabel("ranks")
    axes[1].set_ylabel("efficiency against copies")
    axes[1].legend(frameon=False)
    sleep = rowsOf("performance", "sleep.csv")
    for column, label in (
        ("us_per_particle_awake", "without sleep"),
        ("us_per_particle_sleep", "with sleep"),
    ):
        axes[2].plot(
            [100 * float(r["asleep_share"]) for r in sleep],
            [float(r[column]) for r in sleep],
            "o-",
            label=label,
        )
    axes[2].set_ylim(0)
    axes[2].set_xlabel("% asleep")
    axes[2].set_ylabel("microseconds a particle and step")
    axes[2].legend(frameon=False)
    for axis in axes:
        axis.spines[["top", "right"]].set_visible(False)
    figure.savefig(picture, dpi=100)


def main(check):
    place = os.path.join(DOCS, "performance.md")
    if check:
        with open(place) as f:
            if f.read() != page():
                sys.exit(
                    "docs/performance.md does not match its figures; run benchmarks/performance_chart.py"
                )
        return
    with open(place, "w") as f:
        f.write(page())
    folder = os.path.join(DOCS, "pictures", "performance")
    os.makedirs(folder, exist_ok=True)
    draw(os.path.join(folder, "performance.png"))


if __name__ == "__main__":
    if sys.argv[1:] not in ([], ["--check"]):
        sys.exit(__doc__)
    main("--check" in sys.argv)
