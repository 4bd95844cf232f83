#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures the overhead of stepping from Python over stepping in the library, and over `thaw run`.

python_step.py [--spacing X] [--csv FILE]     default 0.018 m: 20,000 particles

One simulation of scenes/dam_break.toml takes blocks of steps in two ways by turns. One is a call of run(),
the other a Python loop of step() that reads the time after each step. The result is the ratio of the fastest
tenths of blocks in processor time, since other programs only add to it. A process of Python and one of
`thaw run` then take the same steps by turns; the difference of a long and a short run excludes start and end.
Exit code 1 if the loop costs more than 1 %.
"""
import argparse
import csv
import os
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
BUILD = pathlib.Path(os.environ.get('THAW_BUILD', ROOT / 'build/release'))
ENVIRONMENT = {**os.environ, 'PYTHONPATH': str(BUILD / 'python')}
sys.path.insert(0, str(BUILD / 'python'))
import thaw  # noqa: E402

BLOCK, BLOCKS, TARGET = 5, 120, 0.01
SHORT, LONG, PAIRS = 20, 140, 5  # steps of processes, and their number
SCENE = str(ROOT / 'scenes/dam_break.toml')
LOOP = '''
import sys, thaw
sim = thaw.Simulation(thaw.Scene(sys.argv[1], spacing=float(sys.argv[2])), sys.argv[3])
times = []
while sim.steps < int(sys.argv[4]) and sim.step():
    times.append(sim.time)
'''


def seconds(action):
    start = time.process_time()
    action()
    return time.process_time() - start


def fast(times):
    """The slowest of the fastest tenth."""
    return sorted(times)[len(times) // 10]


def processSeconds(line):
    """Processor time of a process."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(line, check=True, stdout=subprocess.DEVNULL, env=ENVIRONMENT)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def stepOfProcess(command):
    """Processor time of a step: the fastest long run less the fastest short one."""
    return (min(command[LONG]) - min(command[SHORT])) / (LONG - SHORT)


def againstCommandLine(spacing, folder):
    """Milliseconds per step of `thaw run` and of a Python loop in processes of their own."""
    program = os.environ.get('THAW_PROGRAM', str(BUILD / 'thaw'))
    runs = {name: {SHORT: [], LONG: []} for name in ('thaw', 'python')}
    for pair in range(PAIRS):
        for steps in (SHORT, LONG):
            out = f'{folder}/{pair}_{steps}'
            size = ['--set', f'spacing={spacing}', '--steps', str(steps)]
            runs['thaw'][steps].append(processSeconds([program, 'run', SCENE, *size, '--out', out + 'c']))
            line = [sys.executable, '-c', LOOP, SCENE, str(spacing), out + 'p', str(steps)]
            runs['python'][steps].append(processSeconds(line))
    return {name: 1e3 * stepOfProcess(command) for name, command in runs.items()}


def main():
    parser = argparse.ArgumentParser(description='overhead of stepping from Python')
    parser.add_argument('--spacing', type=float, default=0.018)
    parser.add_argument('--csv')
    options = parser.parse_args()
    sim = thaw.Simulation(thaw.Scene(SCENE, spacing=options.spacing))
    with sim.local() as p:
        particles = len(p)
    calls = []

    def inPython():
        for _ in range(BLOCK):
            sim.step()
            calls.append(sim.time)

    sim.run(steps=BLOCK)  # warms caches
    within, looped = [], []
    ways = [(within, lambda: sim.run(steps=BLOCK)), (looped, inPython)]
    for _ in range(BLOCKS):
        for times, action in ways:
            times.append(seconds(action))
        ways.reverse()  # other programs disturb both ways alike
    assert len(calls) == BLOCKS * BLOCK
    base = fast(within) / BLOCK
    # The cost of a call alone: a simulation that has ended takes no steps.
    sim.request_stop()
    sim.step()
    most = 20000
    own = seconds(lambda: [sim.step() for _ in range(most)]) / most
    with tempfile.TemporaryDirectory() as folder:
        processes = againstCommandLine(options.spacing, folder)
    result = {
        'particles': particles,
        'ms_per_step': round(1e3 * base, 3),
        'cost_of_loop': round(fast(looped) / fast(within) - 1, 5),
        'target_cost_of_loop': TARGET,
        'us_per_call': round(1e6 * own, 3),
        'cost_of_call': round(own / base, 7),
        'ms_thaw_run': round(processes['thaw'], 3),
        'ms_python_process': round(processes['python'], 3),
        'cost_of_process': round(processes['python'] / processes['thaw'] - 1, 4),
    }
    for name, value in result.items():
        print(f'{name:22s} {value}')
    if options.csv:
        with open(options.csv, 'w', newline='', encoding='utf-8') as file:
            writer = csv.DictWriter(file, list(result))
            writer.writeheader()
            writer.writerow(result)
    return 0 if result['cost_of_loop'] < TARGET else 1


if __name__ == '__main__':
    sys.exit(main())
