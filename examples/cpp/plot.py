# SPDX-License-Identifier: Apache-2.0
"""Plots runs of trap, lamp, attraction, mooney, capsule and two_groups, each in a folder of its name.

plot.py FOLDER PICTURE.png
"""
import pathlib
import sys

import matplotlib
import numpy as np

import thaw

matplotlib.use('Agg')
import matplotlib.pyplot as plt  # noqa: E402

BLUE, RED, GREY = '#3b6ea5', '#b5472f', '#999999'


def sideView(axes, x, **style):
    dots = axes.scatter(*(100 * x[:, [0, 2]].T), **{'s': 4, 'linewidths': 0, **style})
    axes.set_aspect('equal')
    axes.set_xlabel('x / cm')
    axes.set_ylabel('z / cm')
    return dots


def trap(axes, run):
    t = np.array([frame.time for frame in run.frames])
    x = [frame['position'][:, 0].mean() for frame in run.frames]
    axes.plot(t, 100 * x[0] * np.cos(20 * t), color=GREY, lw=4, label='exact')
    axes.plot(t, 100 * np.array(x), color=BLUE, lw=1.2, label='centre of the ball')
    axes.set_xlabel('time / s')
    axes.set_ylabel('x / cm')
    axes.legend(frameon=False, loc='upper center', fontsize=8)


def lamp(axes, run):
    frame = run.frames[-1]
    x = frame['position']
    front = x[:, 1] < x[:, 1].min() + 0.02
    dots = sideView(axes, x[front], c=frame['dose'][front], s=120, marker='s', cmap='inferno')
    axes.figure.colorbar(dots, ax=axes, label='dose / (J/kg)')


def attraction(axes, run):
    frame = run.frames[-1]
    x = frame['position']
    middle = abs(x[:, 1]) < 0.011
    for body, color in (('left', BLUE), ('right', RED)):
        sideView(axes, x[middle & frame.body(body)], color=color)


def mooney(axes, run):
    ledger = run.ledger
    for name, color in (('kinetic', BLUE), ('elastic', RED)):
        axes.plot(ledger['time'], ledger[name], color=color, label=name)
    axes.plot(ledger['time'], ledger['kinetic'] + ledger['elastic'], color=GREY, label='sum')
    axes.set_ylim(0, 1.35 * ledger['kinetic'].max())
    axes.set_xlabel('time / s')
    axes.set_ylabel('energy / J')
    axes.legend(frameon=False, loc='upper center', ncols=3, fontsize=8)


def capsule(axes, run):
    sideView(axes, run.frames.at(0.16)['position'], color=BLUE)  # on the bar
    axes.add_patch(plt.Circle((0, 0), 10, color='#cccccc'))


def twoGroups(axes, folder):
    for group, color in ((0, BLUE), (1, RED)):
        frame = thaw.open(folder / str(group)).frames[-1]
        sideView(axes, frame['position'] + [0.6 * group, 0, 0], color=color)
        axes.text(60 * group, 52, f'group {group}\n{len(frame)} particles', fontsize=8)
    axes.set_ylim(-5, 70)
    axes.set_xticks([])
    axes.set_xlabel('')


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    figure, panels = plt.subplots(2, 3, figsize=(11, 6.4), layout='constrained')
    panels = panels.ravel()
    for axes, plot in zip(panels, (trap, lamp, attraction, mooney, capsule)):
        plot(axes, thaw.open(folder / plot.__name__))
        axes.set_title(plot.__name__, fontsize=10)
    twoGroups(panels[5], folder / 'two_groups')
    panels[5].set_title('two_groups', fontsize=10)
    figure.savefig(sys.argv[2], dpi=80)


if __name__ == '__main__':
    main()
