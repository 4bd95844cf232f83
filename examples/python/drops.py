# SPDX-License-Identifier: Apache-2.0
"""Reads frames and the surface of a run: number and sizes of drops, area and volume of the surface.

drops.py out/pour [PICTURE.png]

Particles closer than 1.5 spacings belong to one drop, also across periodic sides. Triangles of the surface
need the program thaw on PATH or in THAW_PROGRAM.
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


def areaAndVolume(mesh):
    """Area (m^2) and volume (m^3) of a closed mesh, from its vertices and triangles."""
    a, b, c = (mesh.vertices[mesh.triangles[:, corner]].astype(float) for corner in range(3))
    normals = np.cross(b - a, c - a)
    return 0.5 * np.linalg.norm(normals, axis=1).sum(), (a * normals).sum() / 6


def sizesOf(frame, run):
    """Numbers of particles of all drops in a frame, the largest first."""
    liquid = frame['liquid'] >= 0.5 if 'liquid' in frame else np.full(len(frame), True)
    x = frame['position'][liquid].astype(float)
    label = drops(x, 1.5 * run.spacing, run.domain.min, run.domain.period)
    return np.sort(np.unique(label, return_counts=True)[1])[::-1]


def plot(run, sizes, picture):
    import matplotlib

    matplotlib.use('Agg')
    import matplotlib.pyplot as plt

    figure = plt.figure(figsize=(7, 3.2), layout='constrained')
    axes = figure.add_subplot(1, 2, 1)
    diameter = 1000 * (6 / np.pi * sizes[-1]) ** (1 / 3) * run.spacing
    axes.hist(diameter, bins=20, color='#3b6ea5')
    axes.set_xlabel('diameter of a drop / mm')
    axes.set_ylabel('drops in the last frame')
    if 'surface' in run.frames[-1].parts:
        mesh = run.frames[-1].surface.mesh()
        axes = figure.add_subplot(1, 2, 2, projection='3d')
        axes.plot_trisurf(*(1000 * mesh.vertices.T), triangles=mesh.triangles, color='#9ab8d8')
        axes.set_aspect('equal')
        axes.set_xlabel('x / mm')
    figure.savefig(picture, dpi=110)


def main():
    run = thaw.open(sys.argv[1]) if len(sys.argv) > 1 else sys.exit(__doc__)
    sizes = []
    for frame in run.frames:
        sizes.append(sizesOf(frame, run))
        largest = sizes[-1][:5].tolist()
        print(f'{frame.time:.4f} s: {len(sizes[-1])} drops, particles in the largest: {largest}')
    if 'surface' in run.frames[-1].parts:
        mesh = run.frames[-1].surface.mesh()
        area, volume = areaAndVolume(mesh)
        print(f'surface of {len(mesh.vertices)} vertices, {len(mesh.triangles)} triangles: ', end='')
        print(f'{area:.4g} m^2 around {volume:.4g} m^3')
    if len(sys.argv) > 2:
        plot(run, sizes, sys.argv[2])


if __name__ == '__main__':
    main()
