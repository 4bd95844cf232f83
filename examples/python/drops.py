# SPDX-License-Identifier: Apache-2.0
"""Prints number and sizes of the connected drops of liquid in each frame of a run.

drops.py out/pour

Particles closer than 1.5 spacings belong to one drop, also across periodic sides.
"""
import itertools
import sys

import numpy as np

import thaw


def pairs(x, reach, low, period):
    """Rows of all pairs closer than `reach`; period: length of each axis, infinite where not periodic."""
    wraps = np.isfinite(period)
    count = np.where(wraps, np.floor(np.where(wraps, period, reach) / reach), 2**20).astype(int)
    size = np.where(wraps, period / count, reach)
    cell = np.floor((x - low) / size).astype(int)
    cell[:, wraps] %= count[wraps]
    cell[:, ~wraps] += 2**19
    key = (cell[:, 0] << 42) + (cell[:, 1] << 21) + cell[:, 2]
    order = np.argsort(key)
    for offset in itertools.product((-1, 0, 1), repeat=3):
        near = cell + offset
        near[:, wraps] %= count[wraps]
        key_near = (near[:, 0] << 42) + (near[:, 1] << 21) + near[:, 2]
        first, last = (np.searchsorted(key[order], key_near, side) for side in ('left', 'right'))
        i = np.repeat(np.arange(len(x)), last - first)
        nth = np.arange(len(i)) - np.repeat(np.cumsum(last - first) - (last - first), last - first)
        j = order[first[i] + nth]
        d = x[i] - x[j]
        d[:, wraps] -= period[wraps] * np.round(d[:, wraps] / period[wraps])
        close = (d * d).sum(axis=1) < reach**2
        yield i[close], j[close]


def drops(x, reach, low, period):
    """Number of the drop of each particle: the smallest row in it."""
    i, j = (np.concatenate(rows) for rows in zip(*pairs(x, reach, low, period)))
    label, before = np.arange(len(x)), None
    while before is None or (label != before).any():
        before = label.copy()
        np.minimum.at(label, i, label[j])
        label = label[label]
    return label


if __name__ == '__main__':
    run = thaw.open(sys.argv[1]) if len(sys.argv) > 1 else sys.exit(__doc__)
    for frame in run.frames:
        liquid = frame['liquid'] >= 0.5 if 'liquid' in frame else np.full(len(frame), True)
        x = frame['position'][liquid].astype(float)
        label = drops(x, 1.5 * run.spacing, run.domain.min, run.domain.period)
        size = np.sort(np.unique(label, return_counts=True)[1])
        print(f'{frame.time:.4f} s: {len(size)} drops, particles in the largest: {size[::-1][:5].tolist()}')
