# SPDX-License-Identifier: Apache-2.0
"""Melts a block of wax on plates of several temperatures, two at a time, and prints the liquid fractions.

sweep.py OUT [PICTURE.png]     runs that are complete in OUT are not repeated; others go on from a checkpoint
"""
import concurrent.futures
import multiprocessing
import os
import sys

import thaw

PLATES = (100, 150, 200, 250)  # degC


def sceneOf(plate, end=0.4):
    return thaw.Scene(
        spacing='1 cm',
        end=end,
        domain={'min': [-0.2, -0.2, -0.02], 'max': [0.2, 0.2, 0.3]},
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
        body=[
            {
                'name': 'block',
                'box': {'size': [0.08, 0.08, 0.06]},
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
        output={'every': 0.05},
    )


def isComplete(out):
    return os.path.exists(os.path.join(out, 'summary.json')) and thaw.open(out).summary['status'] == 'done'


def simulate(plate, folder):
    """Runs one case. Returns the liquid fraction at the end."""
    out = os.path.join(folder, f'plate_{plate}')
    if not isComplete(out):
        sim = thaw.Simulation(sceneOf(plate), out, resume=True)
        sim.run()
        sim.finish()
    return float(thaw.open(out).ledger['liquid_fraction'][-1])


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    # A spawned process can start MPI, a forked one cannot.
    context = multiprocessing.get_context('spawn')
    with concurrent.futures.ProcessPoolExecutor(2, mp_context=context) as pool:
        shares = list(pool.map(simulate, PLATES, [sys.argv[1]] * len(PLATES)))
    for plate, share in zip(PLATES, shares):
        print(f'plate of {plate} degC: {100 * share:.1f} % liquid')
    if len(sys.argv) > 2:
        import matplotlib

        matplotlib.use('Agg')
        import matplotlib.pyplot as plt

        plt.figure(figsize=(5, 3.2), layout='constrained')
        plt.plot(PLATES, [100 * share for share in shares], 'o-', color='#3b6ea5')
        plt.xlabel('temperature of the plate / \u00b0C')
        plt.ylabel('liquid after 0.4 s / %')
        plt.grid(color='#eeeeee')
        plt.savefig(sys.argv[2], dpi=110)


if __name__ == '__main__':
    main()
