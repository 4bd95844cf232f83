#!/usr/bin/env python3
"""Writes io/commands/frontier_points.cpp, what `thaw check` knows of the accuracy suite: frontier.py ACCURACY.csv

Of each case that stands for a part of the model (NORMS), at the spacing at which settings are varied (plan.py): the defaults first, then every
setting, with its keys as `--set` takes them. Marked are those that no other one beats in both error and time. A setting that blew up, or whose
ledger does not close where that of the defaults does, has an error of -1.
"""
import csv
import os
import sys

import plan

TARGET = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "io", "commands", "frontier_points.cpp")

NORMS = {"hydrostatic": "L2(p)", "martin_moyce": "RMS(Z)", "poiseuille": "L2(u)", "drop_laplace": "pressure jump", "cantilever": "deflection",
         "p_wave": "P speed at 20 dx", "stiff_in_soft": "energy residual", "conductivity_ratio": "Linf(T)", "stefan_two_phase": "front"}


def keyed(settings):
    """The settings of the CSV file as a key of a scene, of no particular material; None where there are several keys."""
    text = settings.rsplit(" spacing=", 1)[0]
    if text == "default":
        return ""
    if text.count("=") != 1:
        return None
    if text.startswith("material."):
        return "material.*." + text.split(".", 2)[2]
    return text if text.startswith(("quality=", "body.")) else "numerics." + text


def failed(rows, settings):
    """Did that run blow up, or do its books not close: an error that is small by luck?"""
    of = [r for r in rows if r["settings"] == settings]
    return any(r["norm"].startswith("blew up") or (r["norm"] == "energy residual" and r["target"] and float(r["error"]) > float(r["target"])) for r in of)


def points(rows):
    """(case, norm, key=value, error, time over that of the defaults, on the frontier?)"""
    for case, norm in NORMS.items():
        at = plan.CASES[case][1]
        here = [r for r in rows if r["case"] == case and f"spacing={at}" in r["settings"].split() and keyed(r["settings"]) is not None]
        default = next((r for r in here if r["norm"] == norm and r["settings"].startswith("default")), None)
        if not default or float(default["core_seconds"]) <= 0:
            continue
        every = {}
        for settings in dict.fromkeys(r["settings"] for r in here):
            row = next((r for r in here if r["settings"] == settings and r["norm"] == norm), None)
            cost = float((row or next(r for r in here if r["settings"] == settings))["core_seconds"]) / float(default["core_seconds"])
            every[settings] = (float(row["error"]) if row and not failed(here, settings) else -1, cost)
        best, chosen = float("inf"), {default["settings"]}
        for settings, (error, cost) in sorted(every.items(), key=lambda e: (e[1][1], e[1][0])):
            if 0 <= error < best:
                best = error
                chosen.add(settings)
        for settings, (error, cost) in sorted(every.items(), key=lambda e: e[0] != default["settings"]):
            yield case, norm, keyed(settings), error, cost, settings in chosen


def source(rows):
    """The text of frontier_points.cpp."""
    text = "// Written by benchmarks/accuracy/frontier.py from docs/accuracy/accuracy.csv; not by hand.\n#include \"io/commands/frontier.hpp\"\n\nnamespace thaw {\nnamespace {\n\n"
    text += "constexpr FrontierPoint points[] = {\n"
    for case, norm, settings, error, cost, best in points(rows):
        text += f'    {{"{case}", "{norm}", "{settings}", {error:.3g}, {cost:.2g}, {"true" if best else "false"}}},\n'
    return text + "};\n\n}  // namespace\n\nstd::span<const FrontierPoint> frontierPoints() { return points; }\n\n}  // namespace thaw\n"


def main(path):
    with open(path, newline="") as f:
        rows = list(csv.DictReader(f))
    with open(TARGET, "w") as out:
        out.write(source(rows))


if __name__ == "__main__":
    if len(sys.argv) < 2:
        raise SystemExit(__doc__)
    main(sys.argv[1])
