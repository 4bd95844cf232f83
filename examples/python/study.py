# SPDX-License-Identifier: Apache-2.0
"""Melts a block of wax in 12 runs, of four plate temperatures and three conductivities, two runs at a time.

study.py OUT [PICTURE.png]     start it again after an interruption: complete runs are not repeated, others
                               go on from their last checkpoint
"""
import concurrent.futures
import itertools
import multiprocessing
import os
import sys

import thaw

PLATES = (100, 150, 200, 250)  # degC
CONDUCTIVITIES = (75, 150, 300)  # W/(m K)


def sceneOf(plate, conductivity):
    return thaw.Scene(
        spacing='1 cm',
        end=0.5,
        domain={'min': [-0.2, -0.2, -0.02], 'max': [0.2, 0.2, 0.3]},
        material={
            'wax': {
                'density': 900,
                'young': '100 kPa',
                'viscosity': '5 Pa s',
                'sound_speed': '15 m/s',
                'conductivity': conductivity,
                'heat_capacity': '2 kJ/(kg K)',
                'latent_heat': '30 kJ/kg',
                'melts': ['40 degC', '60 degC'],
            }
        },
        body=[
            {
                'name': 'block',
                'box': {'size': [0.04, 0.04, 0.08]},
                'material': 'wax',
                'place': {'bottom': [0, 0, 0]},
            }
        ],
        obstacle=[
            {
                'name': 'plate',
                'plane': {'point': [0, 0, 0], 'normal': [0, 0, 1]},
                'temperature': f'{plate} degC',
            }
        ],
        output={'every': 0.05, 'checkpoint': '1 s'},
    )


def isComplete(out):
    return os.path.exists(os.path.join(out, 'summary.json')) and thaw.open(out).summary['status'] == 'done'


def simulate(plate, conductivity, folder):
    """Runs one case, unless it is complete. Returns the heat (kJ) that the block took up."""
    out = os.path.join(folder, f'plate_{plate}_conductivity_{conductivity}')
    if not isComplete(out):
        sim = thaw.Simulation(sceneOf(plate, conductivity), out, resume=True)
        sim.run()
        sim.finish()
        # One write, so that lines of two processes do not mix.
        print(f'{out}: {sim.steps} steps\n', end='', flush=True)
    return float(thaw.open(out).ledger['heat_in'][-1]) / 1000


def plot(heat, picture):
    import matplotlib

    matplotlib.use('Agg')
    import matplotlib.pyplot as plt

    plt.figure(figsize=(5, 3.2), layout='constrained')
    for conductivity in CONDUCTIVITIES:
        heats = [heat[plate, conductivity] for plate in PLATES]
        plt.plot(PLATES, heats, 'o-', label=f'{conductivity} W/(m K)')
    plt.xlabel('temperature of the plate / \u00b0C')
    plt.ylabel('heat taken up in 0.5 s / kJ')
    plt.legend(frameon=False)
    plt.grid(color='#eeeeee')
    plt.savefig(picture, dpi=110)


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    cases = list(itertools.product(PLATES, CONDUCTIVITIES))
    # A spawned process can start MPI, a forked one cannot.
    context = multiprocessing.get_context('spawn')
    with concurrent.futures.ProcessPoolExecutor(2, mp_context=context) as pool:
        runs = {case: pool.submit(simulate, *case, sys.argv[1]) for case in cases}
        heat = {case: run.result() for case, run in runs.items()}
    for (plate, conductivity), taken in heat.items():
        print(f'plate of {plate} degC, {conductivity} W/(m K): {taken:.2f} kJ')
    if len(sys.argv) > 2:
        plot(heat, sys.argv[2])


if __name__ == '__main__':
    main()
