#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Cost of `thaw view` for a run, and the rate of its pictures without a graphics processor.

  scripts/bench view [--repeats 5] [--spacing 0.0175] [--end 1.25] [--count]

A dam break runs on one core: alone, with a client that follows it as the page does but draws nothing, and
with the page in headless Chromium. The three kinds of runs alternate. Their costs are medians of processor
time. The browser draws on the same processor. Then the page draws a block of liquid from many sides.
--count counts the instructions of each run once by valgrind instead of its time, without the browser. It is
for machines on which other programs run. Columns of the file: case, particles, surfels, value, unit, note.
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


class View:
    """A server of a run."""

    def __init__(self, run):
        self.server = subprocess.Popen([THAW, "view", run, "--no-open"], stdout=subprocess.PIPE, text=True)
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
        self.node = subprocess.Popen(nodeCommand("follow", address), stdin=pipe, stdout=pipe)
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
    """Yields rows of the cost of a view, in percent of the run alone."""
    ways = {"alone": None, "followed": Client, "followed and drawn": Browser}
    unit = "instructions" if o.count else "s of processor time"
    if o.no_browser or o.count:
        del ways["followed and drawn"]
    seconds, wall, frames = {w: [] for w in ways}, {w: [] for w in ways}, {}
    for k in range(o.repeats):
        for way in ways if k % 2 == 0 else reversed(ways):
            cpu, elapsed, particles, frames[way] = runSeconds(folder, o, ways[way])
            seconds[way].append(cpu), wall[way].append(elapsed)
            print(f"{way:20s} {cpu:8.3f} {unit}, {elapsed:8.3f} s, {frames[way]} frames shown")
    for way in ways:
        cost = statistics.median(seconds[way])
        yield f"run {way}", particles, 0, cost, unit, f"{frames[way]} frames shown"
        yield f"run {way}, wall clock", particles, 0, statistics.median(wall[way]), "s", ""
    alone = statistics.median(seconds["alone"])
    for way in list(ways)[1:]:
        cost = 100 * (statistics.median(seconds[way]) / alone - 1)
        yield f"cost {way}", particles, 0, cost, "%", f"{unit}, median of {o.repeats}"


def pictures(folder):
    """Yields rows of the pictures per second that the page draws."""
    scene, out = os.path.join(folder, "block.toml"), os.path.join(folder, "block")
    with open(scene, "w") as file:
        file.write(BLOCK)
    subprocess.run([THAW, "run", scene, "--steps", "1", "--out", out], check=True, stdout=subprocess.DEVNULL)
    with contextlib.closing(View(out)) as view:
        reply = subprocess.run(nodeCommand("rate", view.address), check=True, stdout=subprocess.PIPE).stdout
    for row in json.loads(reply):
        case = f"pictures of {row['layers']}"
        yield case, row["particles"], row["surfels"], row["rate"], "1/s", row["renderer"]


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--csv", required=True)
    parser.add_argument("--repeats", type=int, default=5)
    parser.add_argument("--spacing", type=float, default=0.0175, help="m, of the dam break")
    parser.add_argument("--end", type=float, default=1.25, help="s, of the dam break")
    parser.add_argument("--count", action="store_true", help="instructions of one run each, not seconds")
    parser.add_argument("--no-browser", action="store_true", help="without Chromium")
    o = parser.parse_args()
    if o.count:
        o.repeats = 1
    cache = (BUILD / "CMakeCache.txt").read_text().splitlines()
    os.environ["MODULES"] = next(l.split("=", 1)[1] for l in cache if l.startswith("THAW_VIEW_MODULES:PATH="))
    os.environ["CHROMIUM"] = shutil.which("chromium") or shutil.which("google-chrome") or ""
    folder = tempfile.mkdtemp()
    try:
        rows = list(costs(folder, o)) + ([] if o.no_browser else list(pictures(folder)))
    finally:
        shutil.rmtree(folder)
    with open(o.csv, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["case", "particles", "surfels", "value", "unit", "note"])
        for case, particles, surfels, value, unit, note in rows:
            print(f"{case:40s} {value:8.3f} {unit:4s} {note}")
            writer.writerow([case, particles, surfels, f"{value:.3f}", unit, note])


if __name__ == "__main__":
    main()
