# SPDX-License-Identifier: Apache-2.0
"""Plots the energy budget of a run over time.

plot_energy.py out/melt [energy.png]
"""
import sys

import matplotlib

matplotlib.use('Agg')
import matplotlib.pyplot as plt

import thaw


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    ledger = thaw.open(sys.argv[1]).ledger
    picture = sys.argv[2] if len(sys.argv) > 2 else 'energy.png'
    time = ledger['time']

    # The budget closes: the change of the stored energy is what enters, less what leaves, up to the residual.
    stored = ledger['kinetic'] + ledger['elastic'] + ledger['potential']
    entered = sum(
        ledger[f'entered_{part}'] - ledger[f'left_{part}'] for part in ('kinetic', 'elastic', 'potential')
    )
    lost = ledger['dissipated'] + ledger['phase_jump'] - ledger['restart_jump']
    budget = stored[0] + entered + ledger['wall_work'] - lost + ledger['energy_residual']

    figure, axes = plt.subplots(figsize=(7, 4))
    for name in ('kinetic', 'elastic', 'potential', 'dissipated', 'wall_work'):
        axes.plot(time, ledger[name], label=name.replace('_', ' '))
    axes.plot(time, stored, 'k', label='stored')
    axes.plot(time, budget, 'k:', label='budget')
    axes.set_xlabel('time, s')
    axes.set_ylabel(f'energy, {ledger.units["kinetic"]}')
    axes.legend()
    figure.savefig(picture, dpi=150, bbox_inches='tight')

    worst = abs(ledger['energy_residual']).max()
    print(f'{picture}: {ledger.rows} rows, largest residual {worst:.3g} {ledger.units["energy_residual"]}')


if __name__ == '__main__':
    main()
