# SPDX-License-Identifier: Apache-2.0
"""Plots the energy of a simulation while it runs, in a window or in a picture that is updated.

live_energy.py [PICTURE.png]     without a display, or with a picture: the file is updated once a second
"""
import os
import sys
import time

import matplotlib

PICTURE = sys.argv[1] if len(sys.argv) > 1 else None
if PICTURE is None and not os.environ.get('DISPLAY') and not os.environ.get('WAYLAND_DISPLAY'):
    PICTURE = 'live_energy.png'
if PICTURE is not None:
    matplotlib.use('Agg')
import matplotlib.pyplot as plt  # noqa: E402

import thaw  # noqa: E402

NAMES = ('kinetic', 'elastic', 'dissipated')


class LivePlot:
    """Energies over time. It draws at most once in `every` seconds."""

    def __init__(self, every=1.0):
        self.every, self.drawn, self.pictures = every, 0.0, 0
        self.time, self.values = [], {name: [] for name in NAMES}
        self.figure, self.axes = plt.subplots(figsize=(5, 3.2), layout='constrained')
        self.lines = {name: self.axes.plot([], [], label=name)[0] for name in NAMES}
        self.axes.set_xlabel('time / s')
        self.axes.set_ylabel('energy / J')
        self.axes.legend(frameon=False)

    def add(self, time, ledger):
        self.time.append(time)
        for name in NAMES:
            self.values[name].append(ledger[name])

    def draw(self):
        for name in NAMES:
            self.lines[name].set_data(self.time, self.values[name])
        self.axes.relim()
        self.axes.autoscale_view()
        if PICTURE is None:
            plt.pause(0.001)
        else:  # viewers never read an incomplete file
            self.figure.savefig(PICTURE + '.part', dpi=110, format='png')
            os.replace(PICTURE + '.part', PICTURE)
        self.drawn, self.pictures = time.monotonic(), self.pictures + 1

    def onStep(self, sim):
        if sim.steps % 10:
            return
        ledger = sim.ledger  # all ranks read it
        if sim.rank > 0:
            return
        self.add(sim.time, ledger)
        if time.monotonic() - self.drawn > self.every:
            self.draw()


def main():
    sim = thaw.Simulation(
        thaw.Scene(
            spacing='2 cm',
            end=0.6,
            domain={'min': [-0.5, -0.5, -0.1], 'max': [0.5, 0.5, 1]},
            material={'jelly': {'density': 1000, 'young': '50 kPa', 'damping': '5 1/s'}},
            body=[
                {'sphere': {'radius': '10 cm'}, 'place': {'move': [0, 0, 0.25]}, 'material': 'jelly'},
            ],
            obstacle=[{'plane': {'point': [0, 0, 0], 'normal': [0, 0, 1]}}],
        )
    )
    plot = LivePlot()
    sim.on_step(plot.onStep)
    sim.run()
    if sim.rank > 0:
        return
    plot.draw()
    print(f'{sim.steps} steps, drawn {plot.pictures} times' + (f': {PICTURE}' if PICTURE else ''))
    if PICTURE is None:
        plt.show()


if __name__ == '__main__':
    main()
