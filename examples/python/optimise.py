# SPDX-License-Identifier: Apache-2.0
"""Finds the plate temperature at which a block of wax is half liquid after a given time, by SciPy.

optimise.py [TIME [PICTURE.png]]     TIME in s, default 0.4
"""
import sys

import scipy.optimize

import thaw

HALF = 0.5  # liquid fraction that ends the melting time


def sceneOf(plate):
    return thaw.Scene(
        spacing='1 cm',
        end=1,
        domain={'min': [-0.1, -0.1, -0.02], 'max': [0.1, 0.1, 0.1], 'gravity': [0, 0, 0]},
        material={
            'wax': {
                'density': 900,
                'young': '100 kPa',
                'viscosity': '5 Pa s',
                'sound_speed': '15 m/s',
                'conductivity': 300,
                'heat_capacity': '2 kJ/(kg K)',
                'latent_heat': '30 kJ/kg',
                'melts': ['40 degC', '60 degC'],
            }
        },
        body=[{'box': {'size': [0.06, 0.06, 0.03]}, 'material': 'wax', 'place': {'bottom': [0, 0, 0]}}],
        obstacle=[
            {
                'plane': {'point': [0, 0, 0], 'normal': [0, 0, 1]},
                'temperature': f'{plate} degC',
            }
        ],
    )


def meltingTime(plate):
    """Time (s) until half of the block is liquid, linear within the last step. Writes no files."""
    with thaw.Simulation(sceneOf(plate)) as sim:
        before = after = (0.0, sim.ledger['liquid_fraction'])
        while after[1] < HALF and sim.run(steps=10) is None and sim.time < sim.end:
            before, after = after, (sim.time, sim.ledger['liquid_fraction'])
    if after[1] < HALF:
        return sim.end
    return before[0] + (HALF - before[1]) * (after[0] - before[0]) / (after[1] - before[1])


def plot(trials, target, picture):
    import matplotlib

    matplotlib.use('Agg')
    import matplotlib.pyplot as plt

    plt.figure(figsize=(5, 3.2), layout='constrained')
    plt.axhline(target, color='#bbbbbb', lw=1)
    plt.plot(*zip(*sorted(trials)), color='#dddddd')
    plt.plot(*zip(*trials), 'o', color='#3b6ea5')
    for number, (plate, time) in enumerate(trials, 1):
        plt.annotate(str(number), (plate, time), textcoords='offset points', xytext=(5, 5))
    plt.xlabel('temperature of the plate / \u00b0C')
    plt.ylabel('time until half is liquid / s')
    plt.savefig(picture, dpi=110)


def main():
    target = float(sys.argv[1]) if len(sys.argv) > 1 else 0.4
    trials = []

    def excess(plate):
        trials.append((plate, meltingTime(plate)))
        print(f'plate of {plate:.1f} degC: {trials[-1][1]:.4f} s', flush=True)
        return trials[-1][1] - target

    plate = scipy.optimize.brentq(excess, 120, 400, xtol=1, rtol=1e-3)
    print(f'{plate:.0f} degC melts half of the block in {target:g} s')
    if len(sys.argv) > 2:
        plot(trials, target, sys.argv[2])


if __name__ == '__main__':
    main()
