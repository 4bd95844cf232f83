#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures the overhead of stepping from Python over stepping in the library.

python_step.py [--spacing X] [--csv FILE]     default 0.0105 m: 100,000 particles

One simulation of scenes/dam_break.toml takes blocks of steps in two ways by turns. One is a call of run(),
the other a Python loop of step() that reads the time after each step. The result is the ratio of the fastest
blocks in processor time, since other programs only add to it. Exit code 1 if stepping costs more than 1 %.
"""
import argparse
import csv
import os
import pathlib
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(pathlib.Path(os.environ.get('THAW_BUILD', ROOT / 'build/release')) / 'python'))
import thaw  # noqa: E402

BLOCK, BLOCKS, TARGET = 5, 30, 0.01


def seconds(action):
    start = time.process_time()
    action()
    return time.process_time() - start


def main():
    parser = argparse.ArgumentParser(description='overhead of stepping from Python')
    parser.add_argument('--spacing', type=float, default=0.0105)
    parser.add_argument('--csv')
    options = parser.parse_args()
    sim = thaw.Simulation(thaw.Scene(str(ROOT / 'scenes/dam_break.toml'), spacing=options.spacing))
    with sim.local() as p:
        particles = len(p)
    calls = []

    def inPython():
        for _ in range(BLOCK):
            sim.step()
            calls.append(sim.time)

    sim.run(steps=BLOCK)  # warms caches
    within, looped = [], []
    for _ in range(BLOCKS):
        within.append(seconds(lambda: sim.run(steps=BLOCK)))
        looped.append(seconds(inPython))
    assert len(calls) == BLOCKS * BLOCK
    base = min(within) / BLOCK
    # The cost of a call alone: a simulation that has ended takes no steps.
    sim.request_stop()
    sim.step()
    most = 20000
    own = seconds(lambda: [sim.step() for _ in range(most)]) / most
    result = {
        'particles': particles,
        'ms_per_step': round(1e3 * base, 3),
        'cost_of_loop': round(min(looped) / min(within) - 1, 5),
        'target_cost_of_loop': TARGET,
        'us_per_call': round(1e6 * own, 3),
        'cost_of_call': round(own / base, 7),
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
