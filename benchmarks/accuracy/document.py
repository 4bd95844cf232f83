#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes docs/validation/accuracy.md from text.md and the figures: document.py ACCURACY.csv [MODULES.csv]

It also writes the table of `thaw check` (frontier.py).

Every number in the document comes from the files. In text.md:
  {{error CASE | NORM | SETTINGS}}    an error; `seconds`, `order`, `steps` and `particles` likewise;
      SETTINGS as in the CSV file; `count` writes a zero as "none"
  {{ratio CASE | NORM | SETTINGS A | SETTINGS B}}    error of A over that of B; {{cost ...}} likewise for
      core-seconds
  {{between CASE A | CASE B | NORM}}    order between the defaults of two cases that are one at two
      resolutions
  {{table CASE}}    all settings of a case        {{targets}}    the defaults with their targets
  {{choices CASE | SETTINGS; SETTINGS ... | NORM; NORM ...}}    some settings and norms of a case, one line
      per setting
  {{chart CASE}}    its chart, copied to docs/pictures/accuracy/        {{modules}}    the cost of each module
  {{machines}}    processors on which the rows were made
  {{picture CASE}}    the particles at the end, from points/CASE.csv next to ACCURACY.csv
The CSV files are copied to docs/accuracy/, so that the repository alone can reproduce the document.
"""
import csv
import math
import os
import re
import shutil
import subprocess
import sys

import frontier

HERE = os.path.dirname(os.path.abspath(__file__))
DOCS = os.path.join(HERE, "..", "..", "docs")


def rowsOf(path):
    with open(path, newline="") as f:
        return list(csv.DictReader(f))


def short(text):
    """Three digits; thousands have commas, and larger or small numbers a power of ten."""
    digits = f"{float(text):.3g}" if text != "" else ""
    return f"{float(digits):,.0f}" if digits and 1000 <= abs(float(digits)) < 1e6 else digits


def settingsText(settings):
    """Settings with a spacing of one over a whole number as a fraction, where that is shorter."""

    def fraction(match):
        count = round(1 / float(match[1]))
        return f"spacing=1/{count}" if abs(count * float(match[1]) - 1) < 1e-12 else match[0]

    return re.sub(r"\bspacing=([0-9.]{10,})", fraction, settings)


def cell(text):
    """Text of a table cell, with bars escaped because they end a cell."""
    return text.replace("|", "\\|")


def orderOf(row):
    """The order of convergence, or nothing where the error is rounding or a residual."""
    return row["order"] if float(row["error"]) > 1e-8 and "residual" not in row["norm"] else ""


def spacingOf(row):
    return float(next(w for w in row["settings"].split() if w.startswith("spacing=")).split("=")[1])


class Document:
    def __init__(self, rows, modules):
        self.rows, self.modules, self.used, self.drawn = rows, modules, set(), set()

    def find(self, case, norm, settings):
        for r in self.rows:
            if (r["case"], r["norm"], r["settings"]) == (case, norm, settings):
                return r
        raise SystemExit(
            f"benchmarks/accuracy/text.md: no figure for {case} | {norm} | {settings}; "
            "run that case or mend the page"
        )

    def value(self, what, arguments):
        columns = {
            "error": "error",
            "seconds": "core_seconds",
            "order": "order",
            "steps": "steps",
            "particles": "particles",
        }
        if what in columns:
            return short(self.find(*arguments)[columns[what]]) or "none"
        if what == "count":
            number = float(self.find(*arguments)["error"])
            return short(number) if number else "none"
        if what == "between":  # the same problem at two resolutions
            one, two, norm = arguments
            a, b = (
                min(
                    (
                        r
                        for r in self.rows
                        if r["case"] == c and r["norm"] == norm and r["settings"].startswith("default")
                    ),
                    key=spacingOf,
                )
                for c in (one, two)
            )
            errors, spacings = float(a["error"]) / float(b["error"]), spacingOf(a) / spacingOf(b)
            return f"{math.log(errors) / math.log(spacings):.2f}"
        if what in ("ratio", "cost"):
            case, norm, a, b = arguments
            column = "error" if what == "ratio" else "core_seconds"
            return short(float(self.find(case, norm, a)[column]) / float(self.find(case, norm, b)[column]))
        if what == "table":
            return self.table(arguments[0])
        if what == "choices":
            return self.choices(
                arguments[0], *([part.strip() for part in text.split(";")] for text in arguments[1:])
            )
        if what == "targets":
            return self.targets()
        if what == "chart":
            self.used.add(arguments[0])
            return f"![error against core-seconds: {arguments[0]}](../pictures/accuracy/{arguments[0]}.png)"
        if what == "picture":
            self.drawn.add(arguments[0])
            return (
                f"![particles at the end: {arguments[0]}](../pictures/accuracy/{arguments[0]}_particles.png)"
            )
        if what == "modules":
            return self.moduleTable()
        if what == "machines":
            return ", ".join(sorted({r["machine"] for r in self.rows}))
        raise SystemExit(f"text.md: unknown {{{{{what}}}}}")

    def table(self, case):
        rows = [r for r in self.rows if r["case"] == case]
        norms = list(dict.fromkeys(r["norm"] for r in rows if not r["norm"].startswith("blew up")))
        lines = [
            f"| settings | {' | '.join(cell(n) for n in norms)} | order | core-seconds | steps | particles |",
            "|---" * (len(norms) + 5) + "|",
        ]
        for settings in dict.fromkeys(r["settings"] for r in rows):
            of = {r["norm"]: r for r in rows if r["settings"] == settings}
            one = next(iter(of.values()))
            values = [
                short(of[n]["error"])
                if n in of
                else "blew up"
                if any(k.startswith("blew up") for k in of)
                else ""
                for n in norms
            ]
            order = orderOf(of[norms[0]]) if norms and norms[0] in of else ""
            lines.append(
                f"| {settingsText(settings)} | {' | '.join(values)} | {order} | {short(one['core_seconds'])} "
                f"| {one['steps']} | {one['particles']} |"
            )
        return "\n".join(lines)

    def choices(self, case, settings, norms):
        lines = [
            f"| settings | {' | '.join(cell(n) for n in norms)} | core-seconds |",
            "|---" * (len(norms) + 2) + "|",
        ]
        for at in settings:
            found = [self.find(case, n, at) for n in norms]
            lines.append(
                f"| {settingsText(at)} | {' | '.join(short(r['error']) for r in found)} "
                f"| {short(found[0]['core_seconds'])} |"
            )
        return "\n".join(lines)

    def targets(self):
        lines = [
            "| case | norm | finest default | error | target | result | order | core-seconds |",
            "|---|---|---|---|---|---|---|---|",
        ]
        found = {}
        for r in self.rows:
            if r["settings"].startswith("default") and r["target"]:
                key = (r["case"], r["norm"])
                if key not in found or spacingOf(r) < spacingOf(found[key]):
                    found[key] = r
        for (case, norm), r in found.items():
            reached = "reached" if float(r["error"]) <= float(r["target"]) else "**missed**"
            settings = settingsText(r["settings"].replace("default ", ""))
            lines.append(
                f"| {case} | {cell(norm)} | {settings} | {short(r['error'])} "
                f"| {short(r['target'])} | {reached} | {orderOf(r)} | {short(r['core_seconds'])} |"
            )
        return "\n".join(lines)

    def moduleTable(self):
        lines = [
            "| module | base | ns per particle and step: without / with | ratio "
            "| bytes per particle: without / with | fields: without / with | time in unused phases |",
            "|---|---|---|---|---|---|---|",
        ]
        for r in self.modules:
            lines.append(
                f"| {r['case']} | {r['base']} | {short(r['ns_without'])} / {short(r['ns_with'])} "
                f"| {r['time_ratio']} | {r['bytes_without']} / {r['bytes_with']} "
                f"| {r['fields_without']} / {r['fields_with']} | {100 * float(r['idle_share']):.2g} % |"
            )
        return "\n".join(lines)

    def text(self, template):
        return re.sub(
            r"\{\{(\w+)\s*([^}]*)\}\}",
            lambda m: self.value(m[1], [a.strip() for a in m[2].split(" | ")] if m[2] else []),
            template,
        )


def template():
    with open(os.path.join(HERE, "text.md")) as f:
        return f.read()


def drawParticles(case, source, pictures):
    """Copies points/CASE.csv to docs/accuracy/ and draws it."""
    folder = os.path.join(DOCS, "accuracy", "points")
    os.makedirs(folder, exist_ok=True)
    new, kept = os.path.join(os.path.dirname(os.path.abspath(source)), "points", case + ".csv"), os.path.join(
        folder, case + ".csv"
    )
    if os.path.exists(new) and os.path.abspath(kept) != new:
        shutil.copy(new, kept)
    subprocess.run(
        [
            sys.executable,
            os.path.join(HERE, "particles.py"),
            case,
            kept,
            os.path.join(pictures, case + "_particles.png"),
        ],
        check=True,
    )


def main(path, modules=None):
    folder = os.path.join(DOCS, "accuracy")
    os.makedirs(folder, exist_ok=True)
    for source, name in ((path, "accuracy.csv"), (modules, "modules.csv")):
        if source and os.path.abspath(source) != os.path.abspath(os.path.join(folder, name)):
            shutil.copy(source, os.path.join(folder, name))
    frontier.write(rowsOf(path))
    document = Document(rowsOf(path), rowsOf(modules) if modules else [])
    text = document.text(template())
    with open(os.path.join(DOCS, "validation", "accuracy.md"), "w") as f:
        f.write(text)
    subprocess.run(
        [sys.executable, os.path.join(HERE, "chart.py"), path, os.path.join(folder, "all.png")], check=True
    )
    pictures = os.path.join(DOCS, "pictures", "accuracy")
    os.makedirs(pictures, exist_ok=True)
    for case in document.used:
        shutil.move(os.path.join(folder, "all", case + ".png"), os.path.join(pictures, case + ".png"))
    for case in sorted(document.drawn):
        drawParticles(case, path, pictures)
    shutil.rmtree(os.path.join(folder, "all"))
    os.remove(os.path.join(folder, "all.png"))
    print(f"written: {os.path.normpath(os.path.join(DOCS, 'validation', 'accuracy.md'))}")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        raise SystemExit(__doc__)
    main(*sys.argv[1:3])
