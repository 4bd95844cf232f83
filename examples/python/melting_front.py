# SPDX-License-Identifier: Apache-2.0
"""Prints liquid fraction and melting front of a body: the height at the start up to which it has melted.

melting_front.py out/melt [body]
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
        print(f'{frame.time:8.4f}  {liquid[of_body].mean():9.4f}  {front:5.3f}')

    there = np.isfinite(melted_at)
    print(f'{there.sum()} of {of_body.sum()} particles of {body} have melted', end='')
    print(f', half of them by {np.median(melted_at[there]):.4g} s' if there.any() else '')


if __name__ == '__main__':
    main()
