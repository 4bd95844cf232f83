#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes floating_cube.csv: heave of a cube in a square tank by linear potential flow.

Usage: floating_cube.py > floating_cube.csv

A cube of edge L = 1 floats in the middle of a tank 3 L wide, released off its rest. Liquid without viscosity;
small motions; g = 1, rho = 1. Unknowns: velocity potential p, elevation e of the free surface, displacement x
and velocity w of the cube.
  laplace p = 0, dp/dn = w n_z at the cube, 0 at walls and bottom
  de/dt = dp/dz and dp/dt = -g e at the free surface
  (m + ma) dw/dt = -rho g L^2 x - rho g sum(b e dS)
b is the vertical velocity of the surface for w = 1 and p = 0 at the surface; ma is the added mass of that
flow. Finite volumes on a quarter of the tank; the error of the cells (first order at the cube's edges) is
extrapolated from two resolutions. Added masses are printed to stderr, those of a submerged cube too, in the
tank and far from walls (published: 0.68 rho L^3, DNV-RP-C205, table D-2).
"""
import sys

import numpy as np
from scipy.linalg import expm
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import splu


class Tank:
    """A quarter of a tank with n cells per edge of the cube.

    The cube's bottom is `draught` below the surface of the liquid, or below the cube's top at the height
    `submerged`.
    """

    def __init__(self, n, width, depth, draught, submerged=None):
        half, high = round(width / 2 * n), round(depth * n)
        solid = np.zeros((half, half, high), bool)  # z = 0: bottom
        top = high if submerged is None else round(submerged * n)
        bottom = top - round(draught * n)
        edge = n // 2
        solid[:edge, :edge, bottom:top] = True
        self.h, self.area = 1 / n, 1 / n**2
        self.number = -np.ones(solid.shape, int)
        self.number[~solid] = np.arange((~solid).sum())
        self.surface = self.number[:, :, -1][~solid[:, :, -1]]
        self.below = self.number[:edge, :edge, bottom - 1].ravel()
        self.above = self.number[:edge, :edge, top].ravel() if submerged is not None else np.array([], int)
        self.solve = splu(self.laplacian().tocsc()).solve

    def laplacian(self):
        """Negative fluxes into each cell, over h.

        The free surface is half a cell above the topmost centres.
        """
        count, rows, columns, values = self.number.max() + 1, [], [], []
        diagonal = np.zeros(count)
        for axis in range(3):
            a = np.moveaxis(self.number, axis, 0)
            i, j = a[:-1].ravel(), a[1:].ravel()
            both = (i >= 0) & (j >= 0)
            i, j = i[both], j[both]
            np.add.at(diagonal, i, 1)
            np.add.at(diagonal, j, 1)
            rows += [i, j]
            columns += [j, i]
            values += [-np.ones(i.size), -np.ones(i.size)]
        diagonal[self.surface] += 2
        rows.append(np.arange(count))
        columns.append(np.arange(count))
        values.append(diagonal)
        return coo_matrix(
            (np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))), (count, count)
        )

    def unitHeave(self):
        """Added mass (whole tank) and velocity b of the surface for a cube that moves up at 1.

        The pressure is zero at the surface.
        """
        source = np.zeros(self.number.max() + 1)
        source[self.below] = self.h  # dp/dn = 1: the liquid below moves with the cube
        source[self.above] = -self.h
        p = self.solve(source)
        # from the centres of cells to the faces of the cube with the slope there, 1
        mass = 4 * self.area * (np.sum(p[self.below] + self.h / 2) - np.sum(p[self.above] - self.h / 2))
        return mass, -2 * p[self.surface] / self.h

    def surfaceResponse(self):
        """Matrix from p at the surface to dp/dz at the surface, with the cube at rest."""
        n = self.surface.size
        k = np.empty((n, n))
        for c in range(n):
            source = np.zeros(self.number.max() + 1)
            source[self.surface[c]] = 2
            p = self.solve(source)
            k[:, c] = -2 * p[self.surface] / self.h
            k[c, c] += 2 / self.h
        return k


def heave(tank, density, times):
    """Added mass, and x(t) / x(0) of a cube that is released at rest."""
    mass, b = tank.unitHeave()
    n = b.size
    rates = np.zeros((2 * n + 2, 2 * n + 2))  # rates of e, p, x, w
    rates[:n, n : 2 * n] = tank.surfaceResponse()
    rates[:n, 2 * n + 1] = b
    rates[n : 2 * n, :n] = -np.eye(n)
    rates[2 * n, 2 * n + 1] = 1
    rates[2 * n + 1, 2 * n] = -1 / (density + mass)
    rates[2 * n + 1, :n] = -4 * tank.area * b / (density + mass)
    state = np.zeros(2 * n + 2)
    state[2 * n] = 1
    state[:n] = -1 / (
        4 * tank.area * n
    )  # the volume that the raised cube does not displace lowers the surface
    step = expm(rates * (times[1] - times[0]))
    x = []
    for _ in times:
        x.append(state[2 * n])
        state = step @ state
    return mass, np.array(x)


def extrapolated(coarse, fine):
    return 2 * fine - coarse


def report(what, mass, cells):
    found = ", ".join(f"cells of 1/{n}: {m:.4f}" for n, m in zip(cells, mass))
    print(f"{what}: added mass {extrapolated(*mass):.4f} ({found})", file=sys.stderr)


def main():
    times = np.arange(0, 20.01, 0.1)
    columns = {}
    for density in (0.5, 0.9):
        mass, x = zip(*(heave(Tank(n, 3, 1.5, density), density, times) for n in (10, 20)))
        columns[density] = extrapolated(*x)
        report(f"density {density}", mass, (10, 20))
    submerged = (("sinking", 3, 2, 1.75, (8, 16)), ("far from all walls", 5, 5, 3, (4, 8)))
    for what, width, depth, top, cells in submerged:
        mass = [Tank(n, width, depth, 1, top).unitHeave()[0] for n in cells]
        report(f"submerged, {what}", mass, cells)
    print(
        "# Written by floating_cube.py. t / sqrt(L/g), "
        "displacement over that at the start for densities of 0.5 and 0.9"
    )
    print("time,0.5,0.9")
    for k, t in enumerate(times):
        print(f"{t:.1f},{columns[0.5][k]:.5f},{columns[0.9][k]:.5f}")


if __name__ == "__main__":
    main()
