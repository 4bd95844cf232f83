#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Cost of `thaw view` for a run, and the rate of its pictures.

  scripts/bench view [--part cost|pictures] [--repeats 7] [--spacing 0.0175] [--end 0.75]
                     [--client] [--count] [--shots PREFIX]

Cost: a dam break runs on the first core, alone and with the page in headless Chromium, which follows it on
the other cores at a lower priority. The runs alternate. --client adds runs with a client that requests what
the page requests, but draws nothing. Each run is a row with its processor time (user and system) and its
wall-clock time. The cost is the median over the repeats of the ratio to the run alone of the same repeat,
with the least and the largest.
--count counts the instructions of each run once by valgrind instead of its time, without the browser. It is
for machines on which other programs run.

Pictures: the page draws a block of liquid in 800 x 600 pixels, at rest and in motion. `script` is the time of
a picture in JavaScript. --shots PREFIX saves pictures of both qualities.

Columns of the file: case, particles, vertices, value, unit, note. The note of a picture names the renderer.
"""
import argparse
import contextlib
import csv
import json
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import tempfile
import threading
import time
import urllib.request

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
BUILD = pathlib.Path(os.environ.get("THAW_BUILD", ROOT / "build/release"))
THAW = str(BUILD / "thaw")
BLOCK = """spacing = 0.01
end = 1e-4
[domain]
min = [-1, -1, -1]
max = [1, 1, 1]
[material.water]
density = 1000
[[body]]
name = "block"
material = "water"
box = { size = [0.46, 0.46, 0.46] }
[surface]
spacing = 0.00355
"""


CORES = sorted(os.sched_getaffinity(0))
RUN, OTHERS = CORES[:1], CORES[1:] or CORES


def onCores(cores, command):
    return ["taskset", "--cpu-list", ",".join(map(str, cores)), *command]


class View:
    """A server of a run."""

    def __init__(self, run):
        command = onCores(OTHERS, [THAW, "view", run, "--no-open"])
        self.server = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        self.address = self.server.stdout.readline().split()[-1]

    def close(self):
        self.server.terminate()
        self.server.wait()
        self.server.stdout.close()


class Client(threading.Thread):
    """Requests the state of a run every second, and each newest frame, as the page does."""

    def __init__(self, address):
        super().__init__()
        self.address, self.ends, self.frames = address, threading.Event(), 0
        self.start()

    def get(self, name, **query):
        text = "&".join(f"{k}={v}" for k, v in query.items())
        with urllib.request.urlopen(f"{self.address}api/{name}?{text}") as reply:
            return reply.read()

    def run(self):
        shown, revision = None, ""
        while not self.ends.wait(1):
            frames = json.loads(self.get("run", frames=revision)).get("frames")
            if not frames:
                continue
            revision = frames["revision"]
            if frames["numbers"] and frames["numbers"][-1] != shown:
                shown = frames["numbers"][-1]
                self.get("frame", number=shown, type="particles", field="velocity")
                self.frames += 1

    def stop(self):
        self.ends.set()
        self.join()


class Browser:
    """The page of a run in headless Chromium."""

    def __init__(self, address):
        pipe = subprocess.PIPE
        # Threads of software renderers choose their cores themselves: the run has priority there.
        command = ["nice", "-n", "5", *onCores(OTHERS, nodeCommand("follow", address))]
        self.node = subprocess.Popen(command, stdin=pipe, stdout=pipe)
        self.node.stdout.readline()  # the page is open

    def stop(self):
        self.frames = int(self.node.communicate(b"\n")[0])


def nodeCommand(*arguments):
    return ["node", str(HERE / "pictures.mjs"), *arguments]


def counting(command, log):
    """Returns a command that counts the instructions of another one into a file."""
    return ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", f"--log-file={log}", *command]


def countIn(log):
    return int(re.search(r"Collected : (\d+)", pathlib.Path(log).read_text())[1])


def runSeconds(folder, o, watch):
    """Returns processor and wall-clock seconds of a run, its particles, and the frames a watcher showed.

    With o.count, instructions take the place of processor seconds.
    """
    out = os.path.join(folder, "out")
    shutil.rmtree(out, ignore_errors=True)
    command = [THAW, "run", str(ROOT / "scenes/dam_break.toml"), "--out", out]
    for setting in (f"spacing={o.spacing}", f"end={o.end}"):
        command += ["--set", setting]
    log = os.path.join(folder, "count.log")
    if o.count:
        command = counting(command, log)
    command = onCores(RUN, command)
    begin = time.monotonic()
    run = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    watcher, view = None, None
    if watch:
        while not os.path.exists(os.path.join(out, "progress.csv")):
            time.sleep(0.05)
        view = View(out)
        watcher = watch(view.address)
    _, status, used = os.wait4(run.pid, 0)
    wall = time.monotonic() - begin
    if watch:
        watcher.stop()
        view.close()
    if status != 0:
        raise SystemExit("the run fails")
    with open(os.path.join(out, "summary.json")) as file:
        particles = json.load(file)["particles"]
    cost = countIn(log) if o.count else used.ru_utime + used.ru_stime
    return cost, wall, particles, watcher.frames if watcher else 0


def costs(folder, o):
    """Yields rows of runs, and of the cost of a view in percent of the run alone."""
    ways = {"alone": None, "followed": Client, "followed and drawn": Browser}
    if o.count:
        del ways["followed and drawn"]
    elif not o.client:
        del ways["followed"]
    unit = "instructions" if o.count else "s of processor time"
    cost, wall = {way: [] for way in ways}, {way: [] for way in ways}
    for k in range(o.repeats):
        for way in ways if k % 2 == 0 else reversed(ways):
            cpu, elapsed, particles, frames = runSeconds(folder, o, ways[way])
            cost[way].append(cpu), wall[way].append(elapsed)
            note = f"repeat {k + 1}, {frames} frames shown"
            yield f"run {way}", particles, 0, cpu, unit, note
            yield f"run {way}", particles, 0, elapsed, "s of wall clock", note
    for way in list(ways)[1:]:
        for name, seconds in ((unit, cost), ("s of wall clock", wall)):
            more = [100 * (a / b - 1) for a, b in zip(seconds[way], seconds["alone"])]
            note = f"{name.removeprefix('s of ')}, median of {o.repeats}, {min(more):.2f} to {max(more):.2f}"
            yield f"cost {way}", particles, 0, statistics.median(more), "%", note


def pictures(folder, o):
    """Yields rows of the pictures that the page draws."""
    scene, out = os.path.join(folder, "block.toml"), os.path.join(folder, "block")
    with open(scene, "w") as file:
        file.write(BLOCK)
    subprocess.run([THAW, "run", scene, "--steps", "1", "--out", out], check=True, stdout=subprocess.DEVNULL)
    with contextlib.closing(View(out)) as view:
        command = nodeCommand("rate", view.address, *([o.shots] if o.shots else []))
        reply = subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout
    for row in json.loads(reply):
        quality = "quick shaders" if row["quality"]["quick"] else "full quality"
        motion = f"{quality} at {100 * row['quality']['share']:.0f} % of the pixels a side"
        for name, value, unit, note in (
            ("at rest", row["full"], "1/s", "full quality"),
            ("in motion", row["rate"], "1/s", motion),
            ("script of a picture", row["script"], "ms", motion),
            ("script of a new frame", row["frame"], "ms", motion),
        ):
            case = f"{row['layers']}, {name}"
            yield case, row["particles"], row["vertices"], value, unit, f"{note}; {row['renderer']}"


def optionsOf():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--csv", required=True)
    parser.add_argument("--part", choices=("cost", "pictures", "all"), default="all")
    parser.add_argument("--repeats", type=int, default=7)
    parser.add_argument("--spacing", type=float, default=0.0175, help="m, of the dam break")
    parser.add_argument("--end", type=float, default=0.75, help="s, of the dam break")
    parser.add_argument("--client", action="store_true", help="also runs with a client that draws nothing")
    parser.add_argument("--count", action="store_true", help="instructions of one run each, not seconds")
    parser.add_argument("--shots", help="prefix of the names of pictures of both qualities")
    o = parser.parse_args()
    if o.count:
        o.repeats, o.part = 1, "cost"
    return o


def main():
    o = optionsOf()
    cache = (BUILD / "CMakeCache.txt").read_text().splitlines()
    os.environ["MODULES"] = next(l.split("=", 1)[1] for l in cache if l.startswith("THAW_VIEW_MODULES:PATH="))
    os.environ["CHROMIUM"] = shutil.which("chromium") or shutil.which("google-chrome") or ""
    folder = tempfile.mkdtemp()
    try:
        with open(o.csv, "w", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(["case", "particles", "vertices", "value", "unit", "note"])
            for part, rows in (("cost", costs), ("pictures", pictures)):
                if o.part not in (part, "all"):
                    continue
                for case, particles, vertices, value, unit, note in rows(folder, o):
                    print(f"{case:45s} {value:9.3f} {unit:20s} {note}", flush=True)
                    writer.writerow([case, particles, vertices, f"{value:.3f}", unit, note])
    finally:
        shutil.rmtree(folder)


if __name__ == "__main__":
    main()
