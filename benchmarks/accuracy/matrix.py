#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the matrix of the accuracy suite and writes one CSV file.

scripts/bench accuracy [--level quick|full] [--minutes 60] [--jobs N] [--case NAME]... [--ranks N]

Each run is a separate process on --ranks ranks (1); --jobs of them run side by side (one per core).
core_seconds is the processor time of the steps. A run that the file already holds, from the same version of
thaw, is not repeated: an interrupted matrix continues where it stopped. With --case the lines of all other
cases stay, whatever their version. To repeat some cases, start from docs/accuracy/accuracy.csv. No run starts
after --minutes; the same command continues.
Afterwards benchmarks/accuracy/document.py FIGURES.csv docs/accuracy/modules.csv writes
docs/validation/accuracy.md, its pictures, and the table of `thaw check` in docs/accuracy/frontier.csv. Tests
check that both follow from docs/accuracy/accuracy.csv. Final particles of some cases (plan.PICTURES) go to
points/CASE.csv next to the file.
Columns: case, settings, norm, error, target, order, core_seconds, steps, particles, version, machine.
Settings are "default" and the spacing, or the differences from the defaults. The order is that from the next
coarser resolution of the same settings.
"""
import argparse
import csv
import math
import os
import subprocess
import sys
import threading
import time

import plan

COLUMNS = [
    "case",
    "settings",
    "norm",
    "error",
    "target",
    "order",
    "core_seconds",
    "steps",
    "particles",
    "version",
    "machine",
]


def labelOf(spacing, settings):
    return " ".join([*(settings or ["default"]), "spacing=" + spacing]).replace("numerics.", "")


def readRows(path):
    if not os.path.exists(path):
        return []
    with open(path, newline="") as f:
        return [r for r in csv.DictReader(f) if r.get("machine")]


def withOrders(rows):
    """Fills `order`: log(e1/e2)/log(dx1/dx2) for equal case, norm and settings at two spacings."""
    groups = {}
    for r in rows:
        words = r["settings"].split()
        spacing = float(next(w for w in words if w.startswith("spacing=")).split("=")[1])
        key = (r["case"], r["norm"], tuple(w for w in words if not w.startswith("spacing=")))
        groups.setdefault(key, []).append((spacing, r))
    for group in groups.values():
        group.sort(key=lambda g: -g[0])
        for (dx1, r1), (dx2, r2) in zip(group, group[1:]):
            e1, e2 = float(r1["error"]), float(r2["error"])
            r2["order"] = (
                f"{math.log(e1 / e2) / math.log(dx1 / dx2):.2f}" if e1 > 0 and e2 > 0 and dx1 > dx2 else ""
            )
    return rows


def writeRows(path, rows):
    with open(path + ".new", "w", newline="") as f:
        out = csv.DictWriter(f, COLUMNS, lineterminator="\n")
        out.writeheader()
        out.writerows(withOrders(rows))
    os.replace(path + ".new", path)


class Matrix:
    def __init__(self, options, binary):
        self.options, self.binary, self.lock = options, binary, threading.Lock()
        version = subprocess.run(
            [os.path.join(os.environ["THAW_BUILD"], "thaw"), "--version"], capture_output=True, text=True
        ).stdout
        self.version = version[version.find("(") + 1 : version.find(")")]
        known = readRows(options.csv)
        self.rows = [
            r
            for r in known
            if r["version"] == self.version or (options.case and r["case"] not in options.case)
        ]
        if len(self.rows) < len(known):
            print(f"{len(known) - len(self.rows)} lines of another version are run anew")
        done = {(r["case"], r["settings"]) for r in self.rows if r["version"] == self.version}
        wanted = [r for r in plan.runs(options.level) if not options.case or r[0] in options.case]
        self.todo = [r for r in wanted if (r[0], labelOf(r[1], r[2])) not in done]
        print(
            f"level {options.level}: {len(wanted)} runs, {len(wanted) - len(self.todo)} of them done before; "
            f"{options.jobs} side by side, for at most {options.minutes:g} minutes",
            flush=True,
        )
        self.end = time.monotonic() + 60 * options.minutes
        self.failed = []

    def runOne(self, case, spacing, settings):
        label = labelOf(spacing, settings)
        own = f"{self.options.csv}.{threading.get_ident()}"
        command = ["mpirun", "-q", "-n", str(self.options.ranks)] if self.options.ranks > 1 else []
        command += [self.binary, case, "--spacing", spacing, "--csv", own, "--label", label]
        for s in settings:
            command += ["--set", s]
        if case in plan.PICTURES and not settings and spacing == plan.CASES[case][1]:
            folder = os.path.join(os.path.dirname(os.path.abspath(self.options.csv)), "points")
            os.makedirs(folder, exist_ok=True)
            command += ["--points", os.path.join(folder, case + ".csv")]
        start = time.monotonic()
        result = subprocess.run(command, capture_output=True, text=True)
        with self.lock:
            if os.path.exists(own):
                with open(own, newline="") as f:
                    new = [dict(zip(COLUMNS, line)) for line in csv.reader(f)]
                os.remove(own)
                self.rows += new
                writeRows(self.options.csv, self.rows)
                worst = next((f"{r['norm']} {float(r['error']):.3g}" for r in new), "")
                print(f"{time.monotonic() - start:7.1f} s  {case:20s} {label:44s} {worst}", flush=True)
            else:
                self.failed.append(
                    f"{case} {label}: {(result.stderr.strip().splitlines() or ['no message'])[-1]}"
                )
                print(f"not run: {self.failed[-1]}", flush=True)

    def work(self):
        while True:
            with self.lock:
                if not self.todo or time.monotonic() > self.end:
                    return
                job = self.todo.pop(0)
            self.runOne(*job)

    def run(self):
        threads = [threading.Thread(target=self.work) for _ in range(self.options.jobs)]
        for t in threads:
            t.start()
        for t in threads:
            t.join()
        writeRows(self.options.csv, self.rows)
        misses = [
            r
            for r in self.rows
            if r["target"]
            and r["settings"].startswith("default")
            and not float(r["error"]) <= float(r["target"])
        ]
        more = ", the same command goes on with them" if self.todo else ""
        print(f"{len(self.rows)} lines in {self.options.csv}; {len(self.todo)} runs left{more}")
        for r in misses:
            print(
                f"above its target: {r['case']} {r['settings']} {r['norm']} "
                f"{float(r['error']):.3g} > {float(r['target']):g}"
            )
        for f in self.failed:
            print(f"not run: {f}")
        return 1 if self.failed else 0


def main():
    parser = argparse.ArgumentParser(
        description="The matrix of the accuracy suite: accuracy against time.",
        epilog="docs/validation/accuracy.md and the table of thaw check are written from the figures by "
        "benchmarks/accuracy/document.py.",
    )
    parser.add_argument("--csv", required=True, help="file of the figures")
    parser.add_argument(
        "--level",
        choices=["quick", "full"],
        default="quick",
        help="quick: one setting at a time; full: pairs of settings at all resolutions",
    )
    parser.add_argument("--minutes", type=float, default=55, help="no run is begun after this time")
    parser.add_argument(
        "--jobs", type=int, default=max(1, len(os.sched_getaffinity(0))), help="runs side by side"
    )
    parser.add_argument("--ranks", type=int, default=1, help="ranks of each run")
    parser.add_argument("--case", action="append", help="only this case; may be given several times")
    options = parser.parse_args()
    if "THAW_BUILD" not in os.environ:
        parser.error("THAW_BUILD must name the build folder; use scripts/bench accuracy")
    unknown = [c for c in options.case or [] if c not in plan.CASES]
    if unknown:
        parser.error(f"there is no case {unknown[0]}; there are {' '.join(plan.CASES)}")
    options.jobs = max(1, options.jobs // options.ranks)
    return Matrix(options, os.path.join(os.environ["THAW_BUILD"], "benchmarks", "accuracy")).run()


if __name__ == "__main__":
    sys.exit(main())
