#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures the overhead of stepping from Python over stepping in the library, and over `thaw run`.

python_step.py [--spacing X] [--csv FILE]     default 0.018 m: 20,000 particles

A Python process takes the steps of scenes/dam_break.toml by one call of run(), another by a loop of step()
that reads the time after each step. valgrind counts their instructions, which other programs do not change.
Processes without valgrind, and `thaw run`, then take the same steps by turns for the processor time. All
differences are those of a long and a short run, without start and end.
Exit code 1 if the loop takes over 1 % more instructions.
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

TARGET = 0.01
FEW, MANY = 5, 45  # steps with valgrind
SHORT, LONG, PAIRS = 20, 140, 5  # steps of processes, and their number
SCENE = str(ROOT / 'scenes/dam_break.toml')
START = '''
import sys, thaw
scene, spacing, out, steps = sys.argv[1:]
sim = thaw.Simulation(thaw.Scene(scene, spacing=float(spacing)), out)
'''
RUN = START + 'sim.run(steps=int(steps))'
LOOP = (
    START
    + '''times = []
while sim.steps < int(steps) and sim.step():
    times.append(sim.time)
'''
)


def seconds(action):
    start = time.process_time()
    action()
    return time.process_time() - start


def instructions(program, spacing, steps, folder):
    """Instructions of a Python program on a scene, counted by valgrind."""
    out = f'{folder}/counted{steps}'
    line = ['valgrind', '--tool=callgrind', f'--callgrind-out-file={out}', sys.executable, '-c', program]
    subprocess.run(
        [*line, SCENE, str(spacing), tempfile.mkdtemp(dir=folder) + '/out', str(steps)],
        check=True,
        capture_output=True,
        env=ENVIRONMENT,
    )
    with open(out, encoding='utf-8') as file:
        return next(int(line.split()[1]) for line in file if line.startswith(('summary:', 'totals:')))


def costOfLoop(spacing, folder):
    """Instructions of a loop of step() over those of run(), less 1."""
    looped, whole = (
        instructions(program, spacing, MANY, folder) - instructions(program, spacing, FEW, folder)
        for program in (LOOP, RUN)
    )
    return looped / whole - 1


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
    # The cost of a call alone: a simulation that has ended takes no steps.
    sim.request_stop()
    sim.step()
    most = 20000
    own = seconds(lambda: [sim.step() for _ in range(most)]) / most
    with tempfile.TemporaryDirectory() as folder:
        cost = costOfLoop(options.spacing, folder)
        processes = againstCommandLine(options.spacing, folder)
    result = {
        'particles': particles,
        'instructions_of_loop': round(cost, 5),
        'target': TARGET,
        'us_per_call': round(1e6 * own, 3),
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
    return 0 if cost < TARGET else 1


if __name__ == '__main__':
    sys.exit(main())
