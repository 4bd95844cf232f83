#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Pictures of particles at the end of a case: particles.py CASE POINTS.csv PICTURE.png

The suite writes POINTS.csv with --points: x, y, speed and pressure of the middle layer. Points are coloured
by pressure, from its 2nd to its 98th percentile. For the elliptic drop the exact ellipse is drawn over them.
"""
import csv
import math
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

END = 0.0076  # s, end of scenes/liquid/elliptic_drop.toml


def halfAxes(time, steps=2000):
    """a and b of the elliptic drop (R = 1 m): dA/dt = A^2 (a^4 - 1)/(a^4 + 1), da/dt = -a A, b = 1/a."""

    def rates(a, rate):
        return -a * rate, rate**2 * (a**4 - 1) / (a**4 + 1)

    a, rate, dt = 1.0, 100.0, time / steps
    for _ in range(steps):
        k1 = rates(a, rate)
        k2 = rates(a + dt / 2 * k1[0], rate + dt / 2 * k1[1])
        k3 = rates(a + dt / 2 * k2[0], rate + dt / 2 * k2[1])
        k4 = rates(a + dt * k3[0], rate + dt * k3[1])
        a, rate = (s + dt / 6 * (p + 2 * q + 2 * r + t) for s, p, q, r, t in zip((a, rate), k1, k2, k3, k4))
    return a, 1 / a


def draw(case, points, picture):
    with open(points, newline="") as f:
        rows = [{k: float(v) for k, v in r.items()} for r in csv.DictReader(f)]
    figure, axes = plt.subplots(figsize=(5.2, 5.2))
    pressures = sorted(r["pressure"] for r in rows)
    # the range leaves out outliers, which would hide the field
    low, high = (pressures[int(share * (len(rows) - 1))] for share in (0.02, 0.98))
    x, y, colours = ([r[name] for r in rows] for name in ("x", "y", "pressure"))
    found = axes.scatter(x, y, c=colours, s=3, vmin=low, vmax=high)
    figure.colorbar(found, ax=axes, label="pressure (Pa)", shrink=0.8)
    if case == "elliptic_drop":
        a, b = halfAxes(END)
        turn = [2 * math.pi * k / 360 for k in range(361)]
        x, y = [a * math.cos(t) for t in turn], [b * math.sin(t) for t in turn]
        axes.plot(x, y, color="#2e8b57", lw=1, label="exact")
        axes.legend(fontsize=7)
    axes.set_aspect("equal")
    axes.set_xlabel("x (m)")
    axes.set_ylabel("y (m)")
    figure.tight_layout()
    figure.savefig(picture, dpi=100)
    plt.close(figure)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        raise SystemExit(__doc__)
    draw(*sys.argv[1:])
