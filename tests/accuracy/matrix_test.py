# SPDX-License-Identifier: Apache-2.0
"""Runs matrix.py with a stand-in for the benchmark with known errors.

matrix_test.py BUILD (see matrix_test.sh)
"""
import csv
import os
import stat
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
TOOLS = os.path.join(ROOT, "benchmarks", "accuracy")
sys.path.insert(0, TOOLS)
import document  # noqa: E402
import frontier  # noqa: E402
import matrix  # noqa: E402
import plan  # noqa: E402

# The stand-in for the program has errors of second order in the spacing, and logs every call. It refuses the
# case named in REFUSED.
STAND_IN = """#!/usr/bin/env python3
import os, sys
case, rest = sys.argv[1], sys.argv[2:]
spacing, path, label = (rest[rest.index("--" + k) + 1] for k in ("spacing", "csv", "label"))
with open(os.environ["CALLS"], "a") as f: f.write(case + "|" + label + "\\n")
if case == os.environ.get("REFUSED"): sys.exit("error: refused")
line = f"{case},{label},L2,{float(spacing) ** 2},1,,0.5,10,100,{os.environ['VERSION']},machine\\n"
with open(path, "a") as f: f.write(line)
"""


class MatrixTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.csv, self.calls = self.path("accuracy.csv"), self.path("calls")
        os.mkdir(self.path("benchmarks"))
        self.script("benchmarks/accuracy", STAND_IN)
        self.script("thaw", "#!/bin/sh\necho \"thaw 0.1 ($VERSION)\"\n")

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def script(self, name, text):
        with open(self.path(name), "w") as f:
            f.write(text)
        os.chmod(self.path(name), os.stat(self.path(name)).st_mode | stat.S_IXUSR)

    def run_matrix(self, *options, version="aaa", **environment):
        everything = {
            **os.environ,
            "THAW_BUILD": self.folder.name,
            "CALLS": self.calls,
            "VERSION": version,
            **environment,
        }
        return subprocess.run(
            [
                sys.executable,
                "-B",
                os.path.join(TOOLS, "matrix.py"),
                "--csv",
                self.csv,
                "--jobs",
                "2",
                *options,
            ],
            env=everything,
            capture_output=True,
            text=True,
        )

    def rows(self):
        with open(self.csv, newline="") as f:
            return list(csv.DictReader(f))

    def called(self):
        if not os.path.exists(self.calls):
            return []
        with open(self.calls) as f:
            calls = f.read().split("\n")[:-1]
        os.remove(self.calls)
        return calls

    def test_every_run_once_with_marked_defaults(self):
        self.assertEqual(self.run_matrix("--case", "poiseuille").returncode, 0)
        wanted = [r for r in plan.runs("quick") if r[0] == "poiseuille"]
        rows = self.rows()
        self.assertEqual(len(rows), len(wanted))
        self.assertEqual(len(self.called()), len(wanted))
        self.assertEqual(list(rows[0]), matrix.COLUMNS)
        self.assertEqual(
            sorted(r["settings"] for r in rows if r["settings"].startswith("default")),
            sorted(f"default spacing={s}" for s in plan.CASES["poiseuille"][0]),
        )
        self.assertIn("support=2.5 spacing=0.05", [r["settings"] for r in rows])

    def test_orders(self):
        self.run_matrix("--case", "poiseuille")
        order = {r["settings"]: r["order"] for r in self.rows()}
        self.assertEqual(order["default spacing=0.1"], "")
        self.assertEqual(order["default spacing=0.05"], "2.00")
        self.assertEqual(order["default spacing=0.025"], "2.00")
        self.assertEqual(order["support=2.5 spacing=0.05"], "")

    def test_continues_after_an_interruption(self):
        self.run_matrix("--case", "poiseuille")
        self.called()
        whole = self.rows()
        with open(self.csv) as f:
            lines = f.read().splitlines(keepends=True)
        with open(self.csv, "w") as f:  # a kill in the middle of a line
            f.writelines(lines[:5] + [lines[5][: len(lines[5]) // 2]])
        done = self.run_matrix("--case", "poiseuille")
        self.assertIn("4 of them done before", done.stdout)
        self.assertEqual(len(self.called()), len(whole) - 4)
        self.assertEqual(
            sorted(r["settings"] + r["error"] + r["order"] for r in self.rows()),
            sorted(r["settings"] + r["error"] + r["order"] for r in whole),
        )
        self.run_matrix("--case", "poiseuille")
        self.assertEqual(self.called(), [])

    def test_no_time_no_run(self):
        done = self.run_matrix("--case", "poiseuille", "--minutes", "0")
        self.assertEqual(self.called(), [])
        self.assertIn("the same command goes on", done.stdout)

    def test_other_versions_are_repeated_only_for_chosen_cases(self):
        self.run_matrix("--case", "patch", "--case", "rotation")
        self.called()
        self.run_matrix("--case", "patch", version="bbb")
        self.assertTrue(all(c.startswith("patch|") for c in self.called()))
        self.assertEqual(
            {(r["case"], r["version"]) for r in self.rows()}, {("patch", "bbb"), ("rotation", "aaa")}
        )

    def test_reports_failed_runs(self):
        done = self.run_matrix("--case", "patch", "--case", "rotation", REFUSED="patch")
        self.assertEqual(done.returncode, 1)
        self.assertIn("not run: patch", done.stdout)
        self.assertEqual({r["case"] for r in self.rows()}, {"rotation"})
        self.assertEqual(self.run_matrix("--case", "nothing").returncode, 2)

    def test_plan(self):
        for level in ("quick", "full"):
            runs = plan.runs(level)
            keys = [(case, matrix.labelOf(spacing, settings)) for case, spacing, settings in runs]
            self.assertEqual(len(keys), len(set(keys)))
        self.assertEqual(plan.settingsOf("tension", "surface energy"), ["numerics.tension=surface energy"])
        self.assertEqual(
            plan.settingsOf("density=continuity corrected_gradients", "false"),
            ["numerics.density=continuity", "numerics.corrected_gradients=false"],
        )
        names = {
            line.split()[0]
            for line in subprocess.run(
                [os.path.join(BUILD, "benchmarks", "accuracy"), "--list"],
                capture_output=True,
                text=True,
                check=True,
            ).stdout.splitlines()
        }
        self.assertEqual(names, set(plan.CASES))


class CommittedTest(unittest.TestCase):
    """The committed files equal the generated ones, byte for byte."""

    def read(self, *place):
        with open(os.path.join(ROOT, *place), newline="") as f:
            return f.read()

    def test_document(self):
        made = document.Document(
            document.rowsOf(os.path.join(ROOT, "docs", "accuracy", "accuracy.csv")),
            document.rowsOf(os.path.join(ROOT, "docs", "accuracy", "modules.csv")),
        )
        self.assertEqual(made.text(document.template()), self.read("docs", "validation", "accuracy.md"))
        for picture in [*made.used, *(case + "_particles" for case in made.drawn)]:
            self.assertTrue(
                os.path.exists(os.path.join(ROOT, "docs", "pictures", "accuracy", picture + ".png")), picture
            )

    def test_frontier(self):
        self.assertEqual(
            frontier.source(document.rowsOf(os.path.join(ROOT, "docs", "accuracy", "accuracy.csv"))),
            self.read("docs", "accuracy", "frontier.csv"),
        )

    def test_frontier_of_known_points(self):
        row = {"case": "poiseuille", "norm": "L2(u)", "target": "", "version": "", "order": ""}
        rows = [
            {**row, "settings": s + " spacing=0.05", "error": e, "core_seconds": t}
            for s, e, t in (
                ("default", "0.1", "1"),
                ("support=2.5", "0.05", "2"),
                ("support=3", "0.06", "3"),
                ("kernel=cubic", "0.2", "0.5"),
                ("viscosity=laplacian", "0.01", "0.1"),
            )
        ]
        rows.append(
            {**rows[-1], "norm": "energy residual", "error": "1", "target": "0.01"}
        )  # a small error by chance
        self.assertEqual(
            [(p[2], p[3], p[5]) for p in frontier.points(rows)],
            [
                ("", 0.1, True),
                ("numerics.support=2.5", 0.05, True),
                ("numerics.support=3", 0.06, False),
                ("numerics.kernel=cubic", 0.2, True),
                ("numerics.viscosity=laplacian", -1, False),
            ],
        )


if __name__ == "__main__":
    BUILD = sys.argv.pop(1)
    unittest.main()
