#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Scaling study: strong and weak series over ranks, copies, an uneven scene, and counts on many ranks.

series.py --csv FILE [--quick] [--cores N] [--only SERIES]

strong   1M particles on 1 ... N ranks, N: the cores of this machine
weak     500k particles a rank on 1 ... N ranks
corner   a melting scene with most of the work in one corner, on N ranks
counts   few particles a rank on up to 64 ranks, more than there are cores: messages, bytes, collectives. Its
         times are not used, and cells are not redistributed by them, so that every run has the same counts
trace    `thaw run --profile` of the melting bust on N ranks: the table to the terminal, the trace next to the
         CSV file; no line in it

P ranks are compared with P independent simulations of one rank each, which run at the same time with as many
particles a rank. The efficiency is the ratio of the two rates. It thus leaves out the machine's shared memory
and clock. Both take steps in turn, ten each, in one call. The efficiency is the median over these pairs of
blocks, so that changes of the machine's speed cancel. Of repeated calls the one with the median efficiency
counts. --quick takes about two minutes.
"""
import argparse
import csv
import os
import shutil
import subprocess
import sys
import tempfile

COLUMNS = [
    "series",
    "case",
    "ranks",
    "particles",
    "level",
    "cores",
    "efficiency",
    "target_efficiency",
    "speedup",
    "msteps_per_s",
    "copies_msteps_per_s",
    "imbalance",
    "target_imbalance",
    "imbalance_worst",
    "clock",
    "ms_step",
    "ms_step_mean",
    "ms_work",
    "ms_wait",
    "ms_balance",
    "start_s",
    "particles_max_over_mean",
    "halo_fraction",
    "halo_fraction_max",
    "neighbours",
    "neighbours_max",
    "messages",
    "messages_max",
    "kib",
    "kib_max",
    "kib_ghosts",
    "kib_refresh",
    "kib_bonds",
    "messages_bonds",
    "kib_migration",
    "collectives",
    "steps",
    "repeats",
    "machine",
    "version",
]
SERIES = ("strong", "weak", "corner", "counts", "trace")


def binary():
    build = os.environ.get("THAW_BUILD") or os.path.join(
        os.path.dirname(os.path.abspath(__file__)), "..", "..", "build", "release"
    )
    return os.path.join(build, "benchmarks", "scaling")


def machine():
    with open("/proc/cpuinfo") as f:
        names = [line.split(":", 1)[1].strip() for line in f if line.startswith("model name")]
    return f"{names[0] if names else 'unknown'} x{len(names)}"


def version():
    here = os.path.dirname(os.path.abspath(__file__))
    return (
        subprocess.run(
            ["git", "-C", here, "rev-parse", "--short=12", "HEAD"], capture_output=True, text=True
        ).stdout.strip()
        or "unknown"
    )


class Bench:
    def __init__(self, cores):
        self.cores = cores
        self.head = (
            subprocess.run([binary(), "--head"], capture_output=True, text=True, check=True)
            .stdout.strip()
            .split(",")
        )

    def measure(self, ranks, case, particles, steps, warm, *flags):
        env = dict(os.environ)
        if ranks > self.cores:
            env["OMPI_MCA_mpi_yield_when_idle"] = "1"
        command = [
            "mpirun",
            "-q",
            "-n",
            str(ranks),
            binary(),
            "--case",
            case,
            "--particles",
            str(int(particles)),
            "--steps",
            str(steps),
            "--warm",
            str(warm),
            *flags,
        ]
        done = subprocess.run(command, capture_output=True, text=True, env=env)
        if done.returncode != 0:
            sys.exit(f"{' '.join(command)}: exit {done.returncode}\n{done.stderr[-2000:]}")
        row = dict(zip(self.head, done.stdout.strip().splitlines()[-1].split(",")))
        against = (
            f", {row['copies_msteps_per_s']} M of copies, efficiency {row['efficiency']}"
            if "--copies" in flags
            else ""
        )
        print(
            f"  {case} on {ranks} ranks, {row['particles']} particles: {row['ms_step']} ms a step, "
            f"imbalance {row['imbalance']}, {row['msteps_per_s']} M particle-steps/s{against}",
            flush=True,
        )
        return row


def middle(rows, column):
    return sorted(rows, key=lambda r: float(r[column]))[len(rows) // 2]


def scaled(bench, series, perRank, steps, warm, repeats, target):
    """Rows of one series; perRank(ranks) gives the particles of a rank."""
    rows = []
    for ranks in range(1, bench.cores + 1):
        row = middle(
            [
                bench.measure(
                    ranks, "fluid", perRank(ranks) * ranks, steps, warm, *(["--copies"] if ranks > 1 else [])
                )
                for _ in range(repeats)
            ],
            "efficiency" if ranks > 1 else "msteps_per_s",
        )
        if ranks == 1:
            row.update(copies_msteps_per_s=row["msteps_per_s"], efficiency="1.0000")
        alone = rows[0] if rows else row
        row.update(
            series=series,
            repeats=repeats,
            speedup=f"{float(row['msteps_per_s']) / float(alone['msteps_per_s']):.3f}",
            target_efficiency=target,
        )
        rows.append(row)
    return rows


def corner(bench, particles, steps, repeats):
    rows = []
    for ranks in sorted(
        {bench.cores, max(4, bench.cores)}
    ):  # imbalance is measured in CPU time where ranks share cores
        shared = ranks > bench.cores
        row = middle(
            [
                bench.measure(ranks, "corner", particles, steps, 100, *(["--cpu-time"] if shared else []))
                for _ in range(repeats)
            ],
            "imbalance",
        )
        row.update(
            series="corner",
            clock="cpu" if shared else "wall",
            repeats=repeats,
            target_imbalance=1.1,
            efficiency="",
            copies_msteps_per_s="",
        )
        rows.append(row)
    return rows


def counts(bench, most, perRank, steps):
    rows, ranks = [], 1
    while ranks <= most:
        for case, particles in (("fluid", perRank * ranks), ("corner", perRank * ranks * 0.5)):
            row = bench.measure(ranks, case, particles, steps, 25 if case == "corner" else 10, "--counts")
            row.update(series="counts", repeats=1)
            for time in (
                "ms_step",
                "ms_step_mean",
                "ms_work",
                "ms_wait",
                "ms_balance",
                "msteps_per_s",
                "start_s",
                "imbalance",
                "imbalance_worst",
                "efficiency",
                "copies_msteps_per_s",
            ):
                row[time] = ""  # times mean nothing with more ranks than cores
            rows.append(row)
        ranks *= 2
    return rows


def trace(cores, path):
    root = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
    with tempfile.TemporaryDirectory() as folder:
        command = [
            "mpirun",
            "-q",
            "-n",
            str(cores),
            os.path.join(os.path.dirname(binary()), "..", "thaw"),
            "run",
            os.path.join(root, "scenes", "melt.toml"),
            "--out",
            folder,
            "--steps",
            "120",
            "--profile",
        ]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"{' '.join(command)}: exit {done.returncode}\n{done.stderr[-2000:]}")
        lines = done.stdout.splitlines()
        first = next(k for k, line in enumerate(lines) if line.startswith("profile of"))
        print(
            "\n".join(
                lines[
                    first : next(k for k in range(first, len(lines)) if "trace of the last steps" in lines[k])
                ]
            ),
            flush=True,
        )
        shutil.copy(os.path.join(folder, "trace.json"), path)


def main():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("--csv", required=True)
    p.add_argument("--quick", action="store_true")
    p.add_argument("--cores", type=int, default=len(os.sched_getaffinity(0)))
    p.add_argument(
        "--only",
        choices=SERIES,
        action="append",
        help="run only this series; lines of the others stay in the file",
    )
    a = p.parse_args()
    wanted = a.only or SERIES
    bench = Bench(a.cores)
    rows = []
    if a.only and os.path.exists(a.csv):
        with open(a.csv, newline="") as f:
            rows = [r for r in csv.DictReader(f) if r["series"] not in wanted]
    steps, warm, repeats = (10, 4, 1) if a.quick else (50, 25, 3)
    fresh = []
    if "strong" in wanted:
        fresh += scaled(bench, "strong", lambda ranks: 1e6 / ranks, steps, warm, repeats, 0.90)
    if "weak" in wanted:
        fresh += scaled(bench, "weak", lambda ranks: 500000, steps, warm, repeats, 0.92)
    if "corner" in wanted:
        fresh += corner(bench, 40000 if a.quick else 120000, 100 if a.quick else 300, 1 if a.quick else 3)
    if "counts" in wanted:
        fresh += counts(bench, 16 if a.quick else 64, 4000, 25)
    if "trace" in wanted:
        trace(bench.cores, os.path.splitext(a.csv)[0] + "_trace.json")
    for r in fresh:
        r.update(level="quick" if a.quick else "full", cores=a.cores, machine=machine(), version=version())
    rows = sorted(rows + fresh, key=lambda r: (SERIES.index(r["series"]), r["case"], int(r["ranks"])))
    os.makedirs(os.path.dirname(os.path.abspath(a.csv)), exist_ok=True)
    with open(a.csv, "w", newline="") as f:
        out = csv.DictWriter(f, COLUMNS, extrasaction="ignore", restval="")
        out.writeheader()
        out.writerows(rows)


if __name__ == "__main__":
    main()
