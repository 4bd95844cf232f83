#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares forces in Python functions of a simulation with the same expressions on plain numpy arrays.

python_callbacks.py [--spacing X] [--steps N] [--csv FILE]     default 0.0049 m: 1,000,000 particles

A step of scenes/dam_break.toml calls each function between two empty ones, whose time is subtracted. The
same expression then runs by itself on the same arrays, after others have evicted them from caches. Figures
are the fastest of all steps in processor time. Exit code 1 if a function in a simulation costs more than 10 %
above numpy.
"""
import argparse
import csv
import os
import pathlib
import sys
import time

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(pathlib.Path(os.environ.get('THAW_BUILD', ROOT / 'build/release')) / 'python'))
import thaw  # noqa: E402

TARGET = 0.1


def trap(p, t):
    return -400 * p['mass'][:, None] * p['position']


def stirring(p, t):
    x, v = p['position'], p['velocity']
    r2 = x[:, 0] ** 2 + x[:, 1] ** 2
    force = np.empty_like(x)
    force[:, 0] = -x[:, 1] * np.exp(-r2) * np.cos(t) - 0.1 * v[:, 0]
    force[:, 1] = x[:, 0] * np.exp(-r2) * np.cos(t) - 0.1 * v[:, 1]
    force[:, 2] = -0.1 * v[:, 2]
    return p['mass'][:, None] * force


def measure(name, function, options):
    """Returns the figures of one function, in a simulation of its own."""
    keys = {'spacing': options.spacing, 'material.water.sound_speed': 30}
    sim = thaw.Simulation(thaw.Scene(str(ROOT / 'scenes/dam_break.toml'), **keys))
    marks = []

    def mark(p, t):
        marks.append(time.process_time())
        return 0

    for call in (mark, mark, function, mark):
        sim.add_force(call)
    marks.clear()
    sim.run(steps=options.steps)
    empty, within = np.diff(np.reshape(marks, (-1, 3)), axis=1).min(axis=0)
    plain = []
    evicting = np.zeros(64_000_000)  # larger than caches
    with sim.local() as p:
        forces = np.zeros((len(p), 3))
        for _ in range(options.steps):
            evicting += 1
            start = time.process_time()
            forces += function(p, sim.time)
            plain.append(time.process_time() - start)
    sim.close()
    return {
        'function': name,
        'particles': len(forces),
        'ms_in_simulation': round(1e3 * (within - empty), 2),
        'ms_numpy': round(1e3 * min(plain), 2),
        'overhead': round((within - empty) / min(plain) - 1, 4),
        'target_overhead': TARGET,
    }


def main():
    parser = argparse.ArgumentParser(description='cost of Python functions in a step')
    parser.add_argument('--spacing', type=float, default=0.0049)
    parser.add_argument('--steps', type=int, default=8)
    parser.add_argument('--csv')
    options = parser.parse_args()
    rows = []
    for name, function in {'trap': trap, 'stirring': stirring}.items():
        rows.append(measure(name, function, options))
        print('  '.join(f'{key} {value}' for key, value in rows[-1].items()))
    if options.csv:
        with open(options.csv, 'w', newline='', encoding='utf-8') as file:
            writer = csv.DictWriter(file, list(rows[0]))
            writer.writeheader()
            writer.writerows(rows)
    return 0 if max(row['overhead'] for row in rows) < TARGET else 1


if __name__ == '__main__':
    sys.exit(main())
