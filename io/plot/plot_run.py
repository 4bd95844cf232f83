# SPDX-License-Identifier: Apache-2.0
"""Draws charts of a run as one picture. This script is embedded in `thaw plot`.

plot_run.py RUN PICTURE

Reads ledger.csv, progress.csv and summary.json of the run, and frames if h5py is installed.
"""
import csv
import json
import math
import os
import sys

import matplotlib

matplotlib.use('Agg')
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.ticker import MaxNLocator, StrMethodFormatter  # noqa: E402

COLOURS = ('#3b6ea5', '#d1495b', '#66a182', '#edae49', '#7768ae', '#8d6e63', '#00798c', '#9e9e9e')
MOST_FRAMES = 80  # most frames that are read for the front


class Table:
    """A CSV file of the run by column. Incomplete rows are left out: the run may be writing them."""

    def __init__(self, path):
        self.columns = {}
        try:
            with open(path, newline='', encoding='utf-8') as file:
                rows = list(csv.reader(file))
        except FileNotFoundError:
            rows = []
        if rows:
            whole = [row for row in rows[1:] if len(row) == len(rows[0])]
            self.columns = {name: [row[k] for row in whole] for k, name in enumerate(rows[0])}

    def __len__(self):
        return len(next(iter(self.columns.values()), []))

    def __contains__(self, name):
        return name in self.columns

    def text(self, name):
        return self.columns[name]

    def __getitem__(self, name):
        return np.array([numberOf(text) for text in self.columns[name]])


def numberOf(text):
    try:
        return float(text)
    except ValueError:
        return math.nan


def unitOf(values, unit):
    """Returns the values in a unit whose prefix suits the largest one, and the name of the unit."""
    most = np.nanmax(np.abs(values)) if np.isfinite(values).any() else 0
    for factor, prefix in ((1e9, 'G'), (1e6, 'M'), (1e3, 'k'), (1, ''), (1e-3, 'm'), (1e-6, '\u00b5')):
        if most >= factor:
            return factor, prefix + unit
    return (1, unit) if most == 0 else (1e-9, 'n' + unit)


class Clock:
    """The axis of time: s, ms or \u00b5s depending on the length of the run."""

    def __init__(self, end):
        self.factor, self.unit = unitOf(np.array([end]), 's') if end < 1 else (1, 's')
        self.end = end / self.factor

    def __call__(self, seconds):
        return np.asarray(seconds) / self.factor


def drawLines(axis, clock, time, lines, unit):
    """Draws (name, values) in one unit."""
    lines = [(name, values) for name, values in lines if np.isfinite(values).any()]
    factor, name = unitOf(np.concatenate([values for _, values in lines]), unit)
    for (label, values), colour in zip(lines, COLOURS):
        axis.plot(clock(time), values / factor, color=colour, label=label, linewidth=1.6)
    axis.set_ylabel(name)
    if len(lines) > 1:
        axis.legend(fontsize=8, frameon=False, ncols=2)


def changes(values):
    values = values[np.isfinite(values)]
    return len(values) > 1 and np.ptp(values) > 0


def energies(run):
    led = run.ledger
    parts = [('kinetic', 'kinetic_J'), ('elastic', 'elastic_J'), ('gravity', 'gravity_J')]
    parts += [('compression', 'compression_J'), ('surface', 'surface_tension_J'), ('contact', 'contact_J')]
    parts += [('dissipated', 'dissipated_J'), ('work of walls', 'wall_work_J')]
    lines = [(label, led[name]) for label, name in parts if name in led]
    most = max((np.nanmax(np.abs(change(v))) for _, v in lines), default=0)
    lines = [(label, change(v) if label == 'gravity' else v) for label, v in lines]
    lines = [line for line in lines if np.nanmax(np.abs(line[1])) > 2e-3 * most > 0]
    if not lines:
        return None

    def draw(axis):
        drawLines(axis, run.clock, led['time_s'], lines, 'J')
        axis.set_title('energies (gravity: change)' if 'gravity' in dict(lines) else 'energies')

    return draw


def change(values):
    return values - values[0]


def drawRounding(axis, time, bound, most):
    """Draws lines at the bound of the rounding error, or only its largest value in the legend."""
    largest = np.nanmax(bound)
    if largest < 0.02 * most:
        return
    label = 'rounding' if np.nanmin(bound) < most else f'rounding: up to {largest:.2g} %'
    for sign, name in ((1, label), (-1, None)):
        axis.plot(time, sign * bound, color='#888888', linewidth=0.9, linestyle=':', label=name)


def residual(run):
    led = run.ledger

    def share(name, scale):
        largest = np.nanmax(led[scale])
        return 100 * led[name] / largest if largest > 0 else np.zeros(len(led))

    energy, bound = share('energy_residual_J', 'energy_scale_J'), share('energy_rounding_J', 'energy_scale_J')
    of_heat = share('heat_residual_J', 'heat_scale_J')
    if not changes(energy):
        return None

    def draw(axis):
        time = run.clock(led['time_s'])
        axis.axhline(0, color='#bbbbbb', linewidth=0.8)
        drawn = np.concatenate((energy, of_heat))
        most = 1.2 * np.nanmax(np.abs(drawn)) or 1
        axis.set_ylim(-most, most)
        drawRounding(axis, time, bound, most)
        axis.plot(time, energy, color=COLOURS[0], linewidth=1.6, label='energy')
        if changes(of_heat):
            axis.plot(time, of_heat, color=COLOURS[1], linewidth=1.6, label='heat')
        axis.set_title('unexplained energy, relative to the largest term of the ledger')
        axis.set_ylabel('%')
        axis.legend(fontsize=8, frameon=False, ncols=3)

    return draw


def heat(run):
    led = run.ledger
    if not changes(led['internal_J']):
        return None
    lines = [('stored in the material (change)', change(led['internal_J'])), ('flowed in', led['heat_in_J'])]
    lines += [('entered - left', led['entered_internal_J'] - led['left_internal_J'])]
    lines = [line for line in lines if changes(line[1])]

    def draw(axis):
        drawLines(axis, run.clock, led['time_s'], lines, 'J')
        axis.lines[-1].set_linestyle('--')  # a solid line would hide an equal one
        axis.legend(fontsize=8, frameon=False)
        axis.set_title('heat')

    return draw


def liquid(run):
    led = run.ledger
    if not changes(led['liquid_fraction']):
        return None

    def draw(axis):
        share = 100 * led['liquid_fraction']
        axis.fill_between(run.clock(led['time_s']), share, color=COLOURS[0], alpha=0.2, linewidth=0)
        axis.plot(run.clock(led['time_s']), share, color=COLOURS[0], linewidth=1.6)
        axis.set_title('liquid fraction')
        axis.set_ylabel('%')
        axis.set_ylim(0, max(1, min(100, 1.1 * np.nanmax(share))))

    return draw


def particles(run):
    led = run.ledger
    lines = [(name, led[name]) for name in ('particles', 'oriented', 'sheet') if changes(led[name])]
    if not lines:
        return None

    def draw(axis):
        for (name, values), colour in zip(lines, COLOURS):
            axis.plot(run.clock(led['time_s']), values, color=colour, label=name, linewidth=1.6)
        if len(lines) > 1:
            axis.legend(fontsize=8, frameon=False, ncols=2)
        axis.yaxis.set_major_locator(MaxNLocator(nbins=6, integer=True))
        axis.yaxis.set_major_formatter(StrMethodFormatter('{x:,.0f}'))
        axis.set_title('number of ' + ', '.join(name for name, _ in lines))

    return draw


def limits(values):
    """Returns the lowest and the highest value without the outermost 0.5 %, which may be flying drops."""
    return np.percentile(values, (0.5, 99.5)) if len(values) else (math.nan, math.nan)


def pointsOf(path, h5py):
    """Returns time, positions, and the liquid fraction or None."""
    with h5py.File(path, 'r') as file:
        data = file['VTKHDF']
        liquid = np.asarray(data['PointData/liquid']) if 'liquid' in data['PointData'] else None
        return float(data['FieldData/Time'][0]), np.asarray(data['Points'], dtype=float), liquid


def meltingFront(place, liquid):
    """Returns where the solid ends and the liquid reaches, m."""
    molten, reach = liquid >= 0.5, math.nan
    if molten.any():
        reach = limits(np.linalg.norm(place[molten, :2] - np.median(place[:, :2], axis=0), axis=1))[1]
    bottom, top = limits(place[~molten, 2])
    return {
        'solid: top': top,
        'solid: bottom': bottom,
        'liquid: top': limits(place[molten, 2])[1],
        'liquid: reach from the middle': reach,
    }


def flowFront(place):
    return {f'liquid: largest {axis}': limits(place[:, k])[1] for k, axis in enumerate('xyz')}


def frontRows(run, h5py):
    files, melts = run.frames(), changes(run.ledger['liquid_fraction'])
    chosen = sorted({round(k) for k in np.linspace(0, len(files) - 1, min(len(files), MOST_FRAMES))})
    rows = []
    for k in chosen if files else []:
        time, place, liquid = pointsOf(files[k], h5py)
        if len(place) and (not melts or liquid is not None):
            rows.append({'time': time, **(meltingFront(place, liquid) if melts else flowFront(place))})
    return rows


def front(run):
    """Where the solid ends and the liquid reaches, from the frames of a scene with liquid."""
    if not np.nanmax(run.ledger['liquid_fraction']) > 0:
        return None
    try:
        import h5py

        rows = frontRows(run, h5py)
    except ImportError:
        print('thaw plot: the front is left out: python3 has no h5py (Debian: python3-h5py)', file=sys.stderr)
        return None
    except (OSError, KeyError) as error:
        print(f'thaw plot: the front is left out: {error}', file=sys.stderr)
        return None
    if len(rows) < 2:
        return None
    time = np.array([row['time'] for row in rows])
    lines = [(name, np.array([row[name] for row in rows])) for name in rows[0] if name != 'time']
    lines = [line for line in lines if np.isfinite(line[1]).sum() > 1]

    def draw(axis):
        drawLines(axis, run.clock, time, lines, 'm')
        axis.set_title('front')

    return draw if lines else None


def step(run):
    log = run.progress if len(run.progress) > 3 else run.ledger
    if len(log) < 2:
        return None
    time, length = log['time_s'], log['dt_s']
    good = np.isfinite(length) & (length > 0) & (length < 1e30)
    if not good.any():
        return None

    def draw(axis):
        factor, unit = unitOf(length[good], 's')
        reasons = log.text('dt_limited_by') if 'dt_limited_by' in log else [''] * len(log)
        line = max(run.ledger, log, key=len)  # the ledger does not name the limit
        taken = np.where(line['dt_s'] > 0, line['dt_s'] / factor, math.nan)
        axis.plot(run.clock(line['time_s']), taken, color='#cccccc', linewidth=0.8)
        names = sorted(set(reasons), key=lambda name: -reasons.count(name))
        for name, colour in zip(names, COLOURS):
            rows = good & np.array([reason == name for reason in reasons])
            axis.plot(
                run.clock(time[rows]), length[rows] / factor, '.', color=colour, label=name, markersize=4
            )
        axis.set_title('time step, by the limit that sets it')
        axis.set_ylabel(unit)
        axis.set_ylim(0, 1.15 * np.max(length[good]) / factor)
        if any(names):
            axis.legend(fontsize=8, frameon=False, ncols=2, markerscale=2)

    return draw


def iterations(run):
    log = run.progress
    names = [n for n in ('density', 'divergence', 'viscosity') if n + '_iterations_mean' in log]
    lines = [(n, log[n + '_iterations_mean']) for n in names]
    lines = [line for line in lines if np.isfinite(line[1]).sum() > 1]
    if not lines:
        return None

    def draw(axis):
        drawLines(axis, run.clock, log['time_s'], lines, '')
        axis.set_title('mean iterations of the solvers')
        axis.set_ylim(bottom=0)

    return draw


def phases(run):
    """Bars of the wall-clock time of each phase, with the range over all ranks."""
    found = run.summary.get('phases_s_per_rank') or {}
    rows = sorted(((p['mean'], p['min'], p['max'], name) for name, p in found.items()), reverse=True)
    total = sum(row[0] for row in rows)
    rows = [row for row in rows if row[0] > 0.01 * total][:12]
    if not rows:
        return None

    def draw(axis):
        mean, least, most = (np.array([row[k] for row in rows]) for k in range(3))
        places = np.arange(len(rows))
        axis.barh(places, mean, color=COLOURS[0], height=0.65)
        if run.summary.get('ranks', 1) > 1:
            axis.errorbar(
                mean, places, xerr=(mean - least, most - mean), fmt='none', ecolor='#222222', capsize=3
            )
        for place, value, end in zip(places, mean, most):
            axis.annotate(
                f'{100 * value / total:.0f} %',
                (end, place),
                (6, 0),
                textcoords='offset points',
                va='center',
                size=8,
            )
        axis.set_yticks(places, [row[3] for row in rows], fontsize=8)
        axis.invert_yaxis()
        axis.set_xlim(0, 1.15 * np.max(most))
        ranks = run.summary.get('ranks', 1)
        over = f': mean and range over {ranks} ranks' if ranks > 1 else ''
        axis.set_title(f'wall-clock time by phase{over}')
        axis.set_xlabel('s')

    return draw


class Run:
    def __init__(self, folder):
        self.folder = folder
        self.ledger = Table(os.path.join(folder, 'ledger.csv'))
        self.progress = Table(os.path.join(folder, 'progress.csv'))
        self.summary = {}
        try:
            with open(os.path.join(folder, 'summary.json'), encoding='utf-8') as file:
                self.summary = json.load(file)
        except (OSError, ValueError):
            pass
        if len(self.ledger) == 0:
            sys.exit(f'{folder}: is not the folder of a started run: it has no ledger.csv with rows')
        self.clock = Clock(max(np.nanmax(self.ledger['time_s']), 1e-12))

    def frames(self):
        """Returns the frames of particles, in order of time."""
        folder = os.path.join(self.folder, 'frames')
        found = [
            name for name in (os.listdir(folder) if os.path.isdir(folder) else []) if name.endswith('.hdf')
        ]
        others = ('_surface_', '_sheet_', '_oriented_')
        return [os.path.join(folder, n) for n in sorted(found) if not any(word in n for word in others)]

    def title(self):
        s = self.summary
        title = s.get('title') or os.path.basename(os.path.abspath(self.folder))
        counts = self.ledger
        rows = sum(int(counts[name][-1]) for name in ('particles', 'oriented', 'sheet'))
        steps = int(counts['step'][-1])
        text = f'{rows:,} particles, {steps:,} steps to t = {counts["time_s"][-1]:.4g} s'
        if s.get('wall_s') and s.get('status') == 'done':
            text += f', {s["wall_s"]:.3g} s on {s["ranks"]} rank{"" if s["ranks"] == 1 else "s"}'
        elif s.get('status'):
            text += f' ({s["status"]})'
        return title, text


def main(folder, picture):
    run = Run(folder)
    makers = (energies, residual, heat, liquid, front, particles, step, iterations, phases)
    panels = [draw for draw in (make(run) for make in makers) if draw]
    if not panels:
        sys.exit(f'{folder}: there is nothing to plot yet: rows in ledger.csv: {len(run.ledger)}')
    rows = (len(panels) + 1) // 2
    plt.rcParams.update({'font.size': 9, 'axes.titlesize': 10, 'axes.grid': True, 'grid.color': '#eeeeee'})
    plt.rcParams.update({'axes.spines.top': False, 'axes.spines.right': False, 'axes.axisbelow': True})
    figure, axes = plt.subplots(rows, 2, figsize=(11, 2.7 * rows + 0.8), squeeze=False, layout='constrained')
    for axis, draw in zip(axes.flat, panels):
        draw(axis)
        if not axis.get_xlabel():
            axis.set_xlim(0, run.clock.end)
            axis.set_xlabel(f'time / {run.clock.unit}', fontsize=8)
    for axis in axes.flat[len(panels) :]:
        axis.set_visible(False)
    title, text = run.title()
    figure.suptitle(f'{title}\n{text}', fontsize=12)
    part = picture + '.part'
    figure.savefig(part, dpi=110, format='png')
    os.replace(part, picture)
    print(picture)


if __name__ == '__main__':
    try:
        main(sys.argv[1], sys.argv[2])
    except OSError as error:
        sys.exit(str(error))
