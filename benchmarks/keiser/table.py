#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs scenes/keiser/*.toml, each on one core, and compares their times with the paper's Table 1.

  scripts/bench keiser [options below; --csv is given by scripts/bench]

A scene that --seconds stops before its end counts as far as it came; the last column shows how far. The
melting scenes with 60,000 surfels can take longer than the default (`thaw check` estimates the time). A run
that exists already, of the same version of thaw, scene and options, is not repeated. Frames and pictures stay
in OUT/NAME.
Columns: particles and surfels are means over the frames. A physics step excludes surface, output and set-up.
An iteration is the time of all surface updates over the number of their iterations. The paper's
frame is one step and one iteration. Frames per second are given for it, and for simulated frames over the
time of the whole run.
"""
import argparse
import csv
import hashlib
import json
import os
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
# Table 1 of the paper: particles, surfels, seconds per physics step, seconds per surface iteration, frames
# per second (3 GHz Pentium 4)
PAPER = {
    "fluid": (3000, 3400, 0.13, 1.3, 0.7),
    "freezing": (2400, 3400, 0.4, 1.2, 0.5),
    "melting_fast": (3900, 60000, 3.2, 22.0, 0.03),
    "melting_slow": (3900, 56000, 3.1, 20.0, 0.03),
}
NOT_PHYSICS = {"setup", "frames", "checkpoint", "surface"}
COLUMNS = [
    "scene",
    "by",
    "particles",
    "surfels",
    "physics_step_s",
    "surface_iteration_s",
    "frames_per_s_as_paper",
    "frames_per_s",
    "steps",
    "updates",
    "iterations",
    "wall_s",
    "simulated_s",
    "ranks",
    "version",
    "machine",
]


def machine():
    with open("/proc/cpuinfo") as info:
        for line in info:
            if line.startswith("model name"):
                return line.split(":", 1)[1].strip()
    return "unknown"


def thaw(*arguments):
    return subprocess.run([os.path.join(os.environ["THAW_BUILD"], "thaw"), *arguments], check=False)


def run(name, options):
    """Runs a scene unless its run exists, and returns the summary. Exits if the run fails."""
    out = os.path.join(options.out, name)
    scene = os.path.join(ROOT, "scenes", "keiser", name + ".toml")
    texts = [
        open(os.path.join(os.path.dirname(scene), file)).read() for file in (name + ".toml", "bust.toml")
    ]
    stamp = json.dumps(
        [
            options.commit,
            options.until,
            options.seconds,
            options.set,
            hashlib.sha256("".join(texts).encode()).hexdigest(),
        ]
    )
    mark = os.path.join(out, "benchmark.json")
    done = os.path.exists(mark) and open(mark).read() == stamp
    if not done:
        command = ["run", scene, "--out", out, "--progress", "30", "--time-limit", str(options.seconds)]
        for value in options.set + ([f"end={options.until}"] if options.until else []):
            command += ["--set", value]
        code = thaw(*command).returncode
        if code not in (0, 75):  # 75: stopped by --seconds
            sys.exit(f"keiser: {name} ended with exit code {code}; see {out}")
        with open(mark, "w") as file:
            file.write(stamp)
    thaw("render", out, "--sheet", os.path.join(out, "pictures", name + ".png"))
    with open(os.path.join(out, "summary.json")) as file:
        return json.load(file), out


def means(out):
    """Mean numbers of particles and surfels over the frames."""
    frames = {}
    with open(os.path.join(out, "surface.csv")) as file:
        for row in csv.DictReader(file):
            at = frames.setdefault(row["frame"], [0, 0])
            at[0] += int(row["particles"])
            at[1] += int(row["surfels"])
    filled = [f for f in frames.values() if f[1] > 0] or [[0, 0]]
    return [sum(f[k] for f in filled) / len(filled) for k in (0, 1)]


def ours(name, summary, out):
    phases = {key: value["mean"] for key, value in summary["phases_s_per_rank"].items()}
    physics = sum(value for key, value in phases.items() if key not in NOT_PHYSICS)
    counters = summary["surface"]["counters"]
    step = physics / max(1, summary["steps_of_this_process"])
    iteration = phases.get("surface", 0.0) / max(1, counters["iterations"])
    particles, surfels = means(out)
    return {
        "scene": name,
        "by": "thaw",
        "particles": round(particles),
        "surfels": round(surfels),
        "physics_step_s": step,
        "surface_iteration_s": iteration,
        "frames_per_s_as_paper": 1 / (step + iteration),
        "frames_per_s": summary["frames"] / summary["wall_s"],
        "steps": summary["step"],
        "updates": counters["updates"],
        "iterations": counters["iterations"],
        "wall_s": summary["wall_s"],
        "simulated_s": summary["time_s"],
        "ranks": summary["ranks"],
        "version": summary["commit"],
        "machine": machine(),
    }


def show(rows, options):
    print(
        f"\n{'scene':13} {'':6} {'particles/surfels':>18} {'physics step':>14} "
        f"{'surface iteration':>18} {'frames/s (1 step, 1 iteration)':>32} "
        f"{'frames/s of the run':>20} {'simulated':>10}"
    )
    for r in rows:
        last = f"{r['frames_per_s']:.2f}" if "frames_per_s" in r else ""
        simulated = f"{r['simulated_s']:.3g} s" if "simulated_s" in r else ""
        print(
            f"{r['scene']:13} {r['by']:6} {r['particles']:>9}/{r['surfels']:<8} "
            f"{r['physics_step_s']:>12.4g} s {r['surface_iteration_s']:>16.4g} s "
            f"{r['frames_per_s_as_paper']:>32.3g} {last:>20} {simulated:>10}"
        )
    until = f" or {options.until:g} s" if options.until else ""
    print(
        f"Each scene ran until its end{until}, or for {options.seconds:g} s of wall-clock time, "
        "whichever came first; simulated: how far."
    )


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--csv", required=True, help="file that also receives the table")
    parser.add_argument("--until", type=float, help="simulated seconds of each scene (default: all of it)")
    parser.add_argument(
        "--seconds",
        type=float,
        default=1200,
        help="limit of wall-clock seconds per scene (default: %(default)g)",
    )
    parser.add_argument("--scenes", default=",".join(PAPER), help="some of %(default)s (default: all)")
    parser.add_argument(
        "--out", default=os.path.join(ROOT, "out", "keiser"), help="folder of the runs (default: %(default)s)"
    )
    parser.add_argument(
        "--set",
        action="append",
        default=[],
        metavar="KEY=VALUE",
        help="for all scenes; may be given several times",
    )
    options = parser.parse_args()
    if "THAW_BUILD" not in os.environ:
        parser.error("THAW_BUILD must name the build folder; use scripts/bench keiser")
    unknown = [s for s in options.scenes.split(",") if s not in PAPER]
    if unknown:
        parser.error(f"unknown scene '{unknown[0]}': there are {', '.join(PAPER)}")
    options.commit = subprocess.run(
        [os.path.join(os.environ["THAW_BUILD"], "thaw"), "--version"],
        capture_output=True,
        text=True,
        check=True,
    ).stdout.strip()
    rows = []
    for name in options.scenes.split(","):
        p = PAPER[name]
        rows.append(
            {
                "scene": name,
                "by": "paper",
                "particles": p[0],
                "surfels": p[1],
                "physics_step_s": p[2],
                "surface_iteration_s": p[3],
                "frames_per_s_as_paper": p[4],
                "machine": "3 GHz Pentium 4",
            }
        )
        rows.append(ours(name, *run(name, options)))
    os.makedirs(os.path.dirname(os.path.abspath(options.csv)), exist_ok=True)
    with open(options.csv, "w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, restval="")
        writer.writeheader()
        writer.writerows(rows)
    show(rows, options)


if __name__ == "__main__":
    main()
