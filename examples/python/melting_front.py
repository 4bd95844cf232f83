# SPDX-License-Identifier: Apache-2.0
"""Prints liquid fraction and melting front of a body: the height at the start up to which it has melted.

melting_front.py out/melt [body [front.png]]

With the name of a picture, it plots both.
"""
import sys

import numpy as np

import thaw


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    run = thaw.open(sys.argv[1])
    body = sys.argv[2] if len(sys.argv) > 2 else run.bodies[0]

    first = run.frames[0]
    start = first['position'][:, 2]
    of_body = first.body(body)
    melted_at = np.full(len(first), np.inf)

    table = []
    print('    time     liquid  front')
    print('       s          1      m')
    for frame in run.frames:
        # The order of rows changes from frame to frame, and particles may leave: match them by id.
        rows, first_rows = frame.match(first)
        liquid = np.zeros(len(first))
        liquid[first_rows] = frame['liquid'][rows]
        molten = of_body & (liquid >= 0.5)
        melted_at[molten] = np.minimum(melted_at[molten], frame.time)
        front = start[molten].max() if molten.any() else np.nan
        table.append((frame.time, liquid[of_body].mean(), front))
        print('{:8.4f}  {:9.4f}  {:5.3f}'.format(*table[-1]))

    there = np.isfinite(melted_at)
    print(f'{there.sum()} of {of_body.sum()} particles of {body} have melted', end='')
    print(f', half of them by {np.median(melted_at[there]):.4g} s' if there.any() else '')
    if len(sys.argv) > 3:
        plot(table, sys.argv[3])


def plot(table, picture):
    import matplotlib

    matplotlib.use('Agg')
    import matplotlib.pyplot as plt

    time, liquid, front = np.transpose(table)
    figure, axes = plt.subplots(figsize=(7, 4))
    axes.plot(time, liquid, 'C0', label='liquid fraction')
    axes.set_xlabel('time, s')
    axes.set_ylabel('liquid fraction')
    heights = axes.twinx()
    heights.plot(time, front, 'C3--', label='melting front')
    heights.set_ylabel('height of the front at the start, m')
    axes.set_ylim(bottom=0)
    heights.set_ylim(bottom=0)
    figure.legend(loc='upper left', bbox_to_anchor=(0, 1), bbox_transform=axes.transAxes)
    figure.savefig(picture, dpi=150, bbox_inches='tight')
    print(picture)


if __name__ == '__main__':
    main()
