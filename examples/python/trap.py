# SPDX-License-Identifier: Apache-2.0
"""Adds a user-defined force: a harmonic trap, in which a jelly ball swings as x0 cos(omega t).

trap.py [PICTURE.png]     mpirun -n 2 python3 trap.py works too
"""
import sys

import numpy as np

import thaw

OMEGA = 20.0  # 1/s
START = 0.05  # m


def main():
    sim = thaw.Simulation(
        thaw.Scene(
            spacing='4 cm',
            end=0.5,
            domain={'min': [-1, -1, -1], 'max': [1, 1, 1], 'gravity': [0, 0, 0]},
            material={'jelly': {'density': 1000, 'young': '1 MPa'}},
            body=[{'sphere': {'radius': 0.2}, 'place': {'move': [START, 0, 0]}, 'material': 'jelly'}],
        )
    )
    # N, shape (n, 3). Each force follows from the particle's own fields and the time t (s).
    sim.add_force(lambda p, t: -(OMEGA**2) * p.mass[:, None] * p.position)

    times, centres = [], []

    def measure(sim):
        times.append(sim.time)
        centres.append(sim.gather('position')[:, 0].mean())

    sim.on_step(measure)
    sim.run()
    t, x = np.array(times), np.array(centres)
    exact = START * np.cos(OMEGA * t)
    ledger = sim.ledger
    if sim.rank > 0:
        return
    print(f'largest error {abs(x - exact).max() / START:.1e} of the amplitude, {sim.steps} steps')
    print(f'energy residual {ledger["energy_residual"] / ledger["energy_scale"]:.1e} of the largest energy')
    if len(sys.argv) > 1:
        import matplotlib

        matplotlib.use('Agg')
        import matplotlib.pyplot as plt

        plt.figure(figsize=(5, 3.2), layout='constrained')
        plt.plot(t, 100 * exact, color='#999999', lw=4, label='exact')
        plt.plot(t, 100 * x, color='#3b6ea5', lw=1.2, label='centre of the ball')
        plt.xlabel('time / s')
        plt.ylabel('x / cm')
        plt.legend(frameon=False, loc='upper right')
        plt.savefig(sys.argv[1], dpi=110)


if __name__ == '__main__':
    main()
