# SPDX-License-Identifier: Apache-2.0
"""Melts ice from a hot wall for 12 Stefan numbers, and compares the melting front with Neumann's solution.

stefan.py [PICTURE.png]
"""
import math
import sys

import numpy as np

import thaw

STEFAN = np.geomspace(0.05, 4, 12)  # heat capacity * (wall - melting temperature) / latent heat
END = 0.05  # in units of depth^2 / diffusivity


def frontAfterMelting(stefan):
    """Depth of the melt at END in the simulation. Density, conductivity and heat capacity are 1."""
    side = 0.12
    scene = thaw.Scene(
        spacing=0.02,
        end=END,
        domain={
            'min': [0, 0, 0],
            'max': [side, side, 1],
            'sides': {'x': 'periodic', 'y': 'periodic'},
            'gravity': [0, 0, 0],
        },
        material={
            'ice': {
                'density': 1,
                'young': 1,
                'viscosity': 0,
                'sound_speed': 1,
                'heat_capacity': 1,
                'conductivity': 1,
                'latent_heat': 100 / stefan,
                'melts': 300,
            }
        },
        body=[
            {
                'box': {'size': [side, side, 1]},
                'place': {'move': [side / 2, side / 2, 0.5]},
                'material': 'ice',
                'temperature': 299.999999,
            }
        ],
        obstacle=[{'plane': {'point': [0, 0, 0], 'normal': [0, 0, 1]}, 'temperature': 400}],
    )
    with thaw.Simulation(scene) as sim:
        sim.run()
        return sim.ledger['liquid_fraction']


def neumannFront(stefan):
    """Depth 2 k sqrt(t) of the melt, where k is the root of sqrt(pi) k exp(k^2) erf(k) = Ste."""
    low, high = 0.0, 2.0
    while high - low > 1e-12:
        k = (low + high) / 2
        if math.sqrt(math.pi) * k * math.exp(k * k) * math.erf(k) < stefan:
            low = k
        else:
            high = k
    return 2 * low * math.sqrt(END)


def plot(fronts, picture):
    import matplotlib

    matplotlib.use('Agg')
    import matplotlib.pyplot as plt

    plt.figure(figsize=(5, 3.2), layout='constrained')
    line = np.geomspace(STEFAN[0], STEFAN[-1], 100)
    plt.plot(line, [neumannFront(s) for s in line], color='#777777', label="Neumann's solution")
    plt.plot(STEFAN, fronts, 'o', color='#3b6ea5', label='thaw, 50 particles along the depth')
    plt.xscale('log')
    plt.xlabel('Stefan number')
    plt.ylabel('depth of the melt')
    plt.legend(frameon=False)
    plt.grid(color='#eeeeee')
    plt.savefig(picture, dpi=110)


def main():
    fronts = []
    for stefan in STEFAN:
        fronts.append(frontAfterMelting(stefan))
        exact = neumannFront(stefan)
        print(f'Ste {stefan:.3f}: front {fronts[-1]:.4f}, exact {exact:.4f} ({fronts[-1] / exact - 1:+.1%})')
    if len(sys.argv) > 1:
        plot(fronts, sys.argv[1])


if __name__ == '__main__':
    main()
