# SPDX-License-Identifier: Apache-2.0
"""Finds the plate temperature at which a given fraction of the block of sweep.py melts in 0.2 s.

optimise.py [FRACTION]     default 0.2
"""
import sys

import scipy.optimize
from sweep import sceneOf

import thaw


def liquidAt(plate):
    """Liquid fraction after 0.2 s. Writes no files."""
    with thaw.Simulation(sceneOf(plate, end=0.2)) as sim:
        sim.run()
        share = sim.ledger['liquid_fraction']
    print(f'plate of {plate:.1f} degC: {100 * share:.2f} % liquid')
    return share


def main():
    target = float(sys.argv[1]) if len(sys.argv) > 1 else 0.2
    plate = scipy.optimize.brentq(lambda t: liquidAt(t) - target, 80, 400, xtol=2, maxiter=20)
    print(f'{plate:.0f} degC melts {100 * target:g} %')


if __name__ == '__main__':
    main()
