#!/usr/bin/env python3
"""Writes io/commands/frontier_points.cpp, what `thaw check` knows of the accuracy suite: frontier.py ACCURACY.csv

Of each case and norm, at the spacing at which settings are varied (plan.py): the defaults, and the settings that no other one beats in
both error and time; without those whose ledger does not close.
"""
import csv
import os
import sys

import plan

TARGET = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "io", "commands", "frontier_points.cpp")


def closes(rows, case, settings):
    """False where the books of that run do not close: an error that is small by luck."""
    return all(float(r["error"]) <= float(r["target"]) for r in rows if (r["case"], r["settings"]) == (case, settings) and r["norm"] == "energy residual" and r["target"])


def points(rows):
    for case, (_, at, _) in plan.CASES.items():
        here = [r for r in rows if r["case"] == case and f"spacing={at}" in r["settings"].split() and not r["norm"].startswith("blew up")
                and closes(rows, case, r["settings"])]
        for norm in dict.fromkeys(r["norm"] for r in here):
            of = [r for r in here if r["norm"] == norm]
            default = next((r for r in of if r["settings"].startswith("default")), None)
            if not default or float(default["core_seconds"]) <= 0 or ("residual" in norm and case != "stiff_in_soft"):
                continue
            best = float("inf")
            chosen = []
            for r in sorted(of, key=lambda r: (float(r["core_seconds"]), float(r["error"]))):
                if float(r["error"]) < best:
                    best = float(r["error"])
                    chosen.append(r)
            if default not in chosen:
                chosen.insert(0, default)
            for r in chosen:
                settings = " ".join(w for w in r["settings"].split() if not w.startswith("spacing="))
                yield case, norm, settings.replace("default", "defaults"), float(r["error"]), float(r["core_seconds"]) / float(default["core_seconds"])


def main(path):
    with open(path, newline="") as f:
        rows = list(csv.DictReader(f))
    with open(TARGET, "w") as out:
        out.write("// Written by benchmarks/accuracy/frontier.py from docs/accuracy/accuracy.csv; not by hand.\n#include \"io/commands/frontier.hpp\"\n\nnamespace thaw {\nnamespace {\n\n")
        out.write("constexpr FrontierPoint points[] = {\n")
        for case, norm, settings, error, cost in points(rows):
            out.write(f'    {{"{case}", "{norm}", "{settings}", {error:.3g}, {cost:.2g}}},\n')
        out.write("};\n\n}  // namespace\n\nstd::span<const FrontierPoint> frontierPoints() { return points; }\n\n}  // namespace thaw\n")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        raise SystemExit(__doc__)
    main(sys.argv[1])
