#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Rigid pieces against exact solutions, and the cost of stacks and piles.

  scripts/bench rigid [--pieces 30,100,1000] [--seconds 6]
  benchmarks/rigid/rigid.py --page       writes docs/validation/rigid.md from benchmarks/rigid/rigid.csv

Cases: a tumbling box, a box on an incline, rebounds, a stack of ten boxes, and piles of boxes and balls that
fall into a bin. Times are processor times on one core.
"""
import argparse
import csv
import json
import math
import os
import resource
import subprocess
import sys
import tempfile

import estimates
import melt
import scenes

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
FIGURES = os.path.join(HERE, "rigid.csv")
ESTIMATES = os.path.join(HERE, "estimates.csv")
MELT = os.path.join(HERE, "melt.csv")
PAGE = os.path.join(ROOT, "docs", "validation", "rigid.md")
COLUMNS = ["case", "quantity", "value", "exact", "limit", "unit", "cpu_s", "iterations", "unfinished"]
GRAVITY = 9.81


class Run:
    """A finished run: its ledger, summary and frames, and the processor time that it took."""

    def __init__(self, folder, text):
        self.out = tempfile.mkdtemp(dir=folder)
        scene = os.path.join(self.out, "case.toml")
        with open(scene, "w") as file:
            file.write(text)
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        subprocess.run(
            [os.path.join(os.environ["THAW_BUILD"], "thaw"), "run", scene, "--out", self.out + "/run"],
            check=True,
            stdout=subprocess.DEVNULL,
        )
        self.spent = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
        with open(self.out + "/run/ledger.csv") as file:
            self.ledger = [{k: number(v) for k, v in row.items()} for row in csv.DictReader(file)]
        with open(self.out + "/run/summary.json") as file:
            self.summary = json.load(file)

    def row(self, case, quantity, value, exact, limit, unit):
        contact = self.summary["solvers"]["contact"]
        unfinished = self.summary["counters"]["contact_unfinished"]
        mean = f"{contact['mean_iterations']:.1f}"
        return [case, quantity, value, exact, limit, unit, f"{self.spent:.2f}", mean, unfinished]

    def moves(self):
        """Largest distance (m) of a particle from its start."""
        sys.path.insert(0, os.path.join(ROOT, "python"))
        import thaw

        run = thaw.open(self.out + "/run")
        first, last = run.frames[0], run.frames[-1]
        difference = last.by_id("position") - first.by_id("position")
        return float(max(math.sqrt(sum(x * x for x in d)) for d in difference))


def number(text):
    try:
        return float(text)
    except ValueError:
        return text


def vector(row, name, unit):
    return [row[f"{name}_{a}_{unit}"] for a in "xyz"]


def tumbling(folder):
    run = Run(folder, scenes.tumbling(20))
    first = run.ledger[0]
    energy = max(abs(r["kinetic_J"] / first["kinetic_J"] - 1) for r in run.ledger)
    before = vector(first, "angular_momentum", "kg_m2_per_s")
    size = math.dist(before, [0, 0, 0])
    turn = max(math.dist(vector(r, "angular_momentum", "kg_m2_per_s"), before) for r in run.ledger) / size
    yield run.row("tumbling", "energy", energy, 0, 1e-10, "")
    yield run.row("tumbling", "angular momentum", turn, 0, 1e-10, "")


def incline(folder):
    angle, end = 0.5, 1.0
    for friction in (0.2, 0.4, 0.54, 0.56, 0.8):  # tan(angle) is 0.546
        run = Run(folder, scenes.incline(friction, angle, end))
        last = run.ledger[-1]
        speed = last["momentum_x_kg_m_per_s"] / last["mass_kg"]
        exact = end * max(0, GRAVITY * (math.sin(angle) - friction * math.cos(angle)))
        # The contact impulses that balance the last half kick act in the next step.
        rate = math.sin(angle) if exact == 0 else friction * math.cos(angle)
        speed -= 0.5 * last["dt_s"] * GRAVITY * rate
        limit = 0.02 * exact if exact > 0 else 1e-4
        yield run.row(f"incline, friction {friction:g}", "speed", speed, exact, limit, "m/s")


def restitution(folder):
    for shape in ("box", "ball"):
        for e in (0.3, 0.5, 0.8):
            run = Run(folder, scenes.drop(shape, e, 0.452 * (1 + 1.5 * e)))
            mass = run.ledger[0]["mass_kg"]
            heights = [r["gravity_J"] / mass / GRAVITY for r in run.ledger]
            lowest = min(range(len(heights)), key=lambda k: heights[k])
            fall, rise = heights[0] - heights[lowest], max(heights[lowest:]) - heights[lowest]
            ratio = math.sqrt(rise / fall)
            yield run.row(f"restitution {e:g}, {shape}", "restitution", ratio, e, 0.02 * e, "")


def stack(folder):
    for sleeps in (False, True):
        run = Run(folder, scenes.stack(10, sleeps, 10))
        name = "stack of ten, " + ("asleep" if sleeps else "awake")
        yield run.row(name, "largest move over the spacing", run.moves() / 0.1, 0, 0.1, "")
        if not sleeps:
            continue
        share = run.summary["counters"]["asleep"] / run.summary["particles"]
        yield run.row(name, "particles asleep", share, 1, 0, "")


def pile(folder, pieces, seconds):
    for sleeps in (False, True) if pieces <= 100 else (True,):
        run = Run(folder, scenes.pile(pieces, seconds, sleeps))
        name = f"pile of {pieces}" + (", sleep" if sleeps else "")
        last = run.ledger[-1]
        yield run.row(
            name,
            "residual over the energy scale",
            last["energy_residual_J"] / last["energy_scale_J"],
            0,
            0.01,
            "",
        )
        yield run.row(
            name, "kinetic over the energy scale", last["kinetic_J"] / last["energy_scale_J"], 0, 0.01, ""
        )
        overlap = run.summary["solvers"]["contact"]["largest_overlap_m"] / scenes.SPACING
        yield run.row(name, "largest overlap over the spacing", overlap, 0, 0.1, "")
        if sleeps:
            share = run.summary["counters"]["asleep"] / run.summary["particles"]
            yield run.row(name, "particles asleep", share, 1, 0, "")


def page(rows, estimated, melted):
    lines = [
        "# Rigid pieces",
        "",
        "`scripts/bench rigid` compares [rigid pieces](../theory/rigid.md) with exact solutions. The",
        "spacing is 0.1 m, the step 1 or 2 ms. Iterations are means over all steps. After 500, the",
        "[solver](../theory/rigid_contact.md#solver) leaves a step unfinished. Times are processor times on",
        "one core.",
        "",
        "| case | quantity | value | exact | limit of the error | iterations | unfinished steps | time (s) |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for r in rows:
        value, exact = float(r["value"]), float(r["exact"])
        good = r["limit"] == "" or abs(value - exact) <= float(r["limit"])
        shown = f"{value:.3g}" + (" " + r["unit"] if r["unit"] else "")
        limit = "" if r["limit"] == "" else f"{float(r['limit']):.2g}" + ("" if good else ", missed")
        lines.append(
            f"| {r['case']} | {r['quantity']} | {shown} | {exact:.3g} | {limit} | {r['iterations']} | "
            f"{r['unfinished']} | {float(r['cpu_s']):.1f} |"
        )
    lines += [
        "",
        "- **tumbling**: a box turns about its middle axis for 20 s; relative changes.",
        "- **incline**: a box on a plane at 0.5 rad; speed after 1 s. It sticks from a friction of 0.546 on.",
        "- **restitution**: root of the ratio of heights, after a fall of 1 m.",
        "- **stack**: ten boxes turned against each other, for 10 s.",
        "- **pile**: boxes and balls of 20 to 36 particles fall into a bin, for 6 s. Rolling friction 10 mm.",
        "",
        "## Time of a soft scene that melts",
        "",
        *melt.lines(melted),
        "",
        "## Estimates of thaw check",
        "",
        "`thaw check` runs scenes with rigid solids at a larger spacing. It multiplies the number of steps",
        "and their cost by the growth in that run. Costs are relative to the start.",
        "",
        *estimates.table(estimated),
        "",
        "Figures: `rigid.csv`, `estimates.csv` and `melt.csv` in `benchmarks/rigid/`, from scripts of these",
        "names. `rigid.py --page` writes this page.",
    ]
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--csv")
    parser.add_argument("--page", action="store_true")
    parser.add_argument("--pieces", default="30,100,1000")
    parser.add_argument("--seconds", type=float, default=6)
    o = parser.parse_args()
    if o.page:
        tables = []
        for path in (FIGURES, ESTIMATES, MELT):
            with open(path) as source:
                tables.append(list(csv.DictReader(source)))
        with open(PAGE, "w") as target:
            target.write(page(*tables))
        return
    if not o.csv:
        parser.error("needs --csv FILE or --page")
    with tempfile.TemporaryDirectory() as folder, open(o.csv, "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(COLUMNS)
        for case in (tumbling, incline, restitution, stack):
            for row in case(folder):
                writer.writerow(row)
                print(*row, flush=True)
        for pieces in o.pieces.split(","):
            for row in pile(folder, int(pieces), o.seconds):
                writer.writerow(row)
                file.flush()
                print(*row, flush=True)


if __name__ == "__main__":
    main()
