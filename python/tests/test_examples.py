# SPDX-License-Identifier: Apache-2.0
"""The scripts of examples/python run and give the right figures."""
from __future__ import annotations

import os
import pathlib
import re
import subprocess
import sys

import numpy as np
import pytest
from conftest import ROOT

import thaw

EXAMPLES = ROOT / 'examples/python'


def runExample(name: str, *arguments: str) -> str:
    env = {**os.environ, 'PYTHONPATH': str(ROOT / 'python'), 'PYTHONDONTWRITEBYTECODE': '1'}
    line = [sys.executable, str(EXAMPLES / name), *arguments]
    done = subprocess.run(line, env=env, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_energies_are_plotted(bodies: str, tmp_path: pathlib.Path) -> None:
    pytest.importorskip('matplotlib')
    picture = tmp_path / 'energy.png'
    assert '5 rows' in runExample('plot_energy.py', bodies, str(picture))
    assert picture.read_bytes().startswith(b'\x89PNG')


def test_the_melting_front_is_that_of_the_ledger(bodies: str) -> None:
    rows = re.findall(r'^ *([\d.]+) +([\d.]+) +\S+$', runExample('melting_front.py', bodies), re.M)
    ledger = thaw.open(bodies).ledger
    assert np.allclose([float(t) for t, _ in rows], ledger['time'])
    assert np.allclose([float(f) for _, f in rows], ledger['liquid_fraction'], atol=1e-4)
    assert ledger['liquid_fraction'][-1] > 0.1
    assert '16 of 64 particles of bust have melted' in runExample('melting_front.py', bodies, 'bust')


def test_drops_are_counted_across_periodic_sides(drops: str, jet: str) -> None:
    run = thaw.open(drops)
    sizes = sorted((int(run.frames[0].body(k).sum()) for k in (0, 1)), reverse=True)
    lines = runExample('drops.py', drops).splitlines()
    assert len(lines) == 5 and lines[0] == f'0.0000 s: 2 drops, particles in the largest: {sizes}'
    lines = runExample('drops.py', jet).splitlines()
    assert lines[0] == '0.0000 s: 0 drops, particles in the largest: []'


def test_drops_are_those_of_a_brute_force_search() -> None:
    sys.path.insert(0, str(EXAMPLES))
    from drops import drops as dropsOf

    random = np.random.default_rng(3)
    low, period, reach = np.array([-1.0, 0, 2]), np.array([1.0, np.inf, 2.5]), 0.16
    x = low + random.random((150, 3)) * [1, 1.5, 2.5]
    d = x[:, None] - x[None]
    for axis in (0, 2):
        d[..., axis] -= period[axis] * np.round(d[..., axis] / period[axis])
    near = (d**2).sum(axis=2) < reach**2
    label = np.arange(len(x))
    for _ in x:
        label = np.where(near, label[None], len(x)).min(axis=1)
    assert (dropsOf(x, reach, low, period) == label).all()
    assert 2 < len(np.unique(label)) < len(x)


def test_the_guide_runs_as_it_is_printed(bodies: str, tmp_path: pathlib.Path) -> None:
    pytest.importorskip('matplotlib')
    text = (ROOT / 'docs/howto/python.md').read_text()
    code = '\n'.join(re.findall(r'```python\n(.*?)```', text, re.S))
    (tmp_path / 'guide.py').write_text(code)
    (tmp_path / 'out').mkdir()
    for name in ('melt', 'melt_one_rank'):
        (tmp_path / 'out' / name).symlink_to(bodies)
    env = {**os.environ, 'PYTHONPATH': str(ROOT / 'python'), 'MPLBACKEND': 'Agg'}
    line = [sys.executable, '-W', 'error::UserWarning', 'guide.py']
    done = subprocess.run(line, env=env, cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert '<Run out/melt: <5 frames, 0 to 0.04 s>>' in done.stdout and 'equal' in done.stdout
    assert (tmp_path / 'energy.png').exists()


def needsSimulations() -> None:
    try:
        from thaw._load import core

        core()
    except ImportError as error:
        pytest.skip(str(error))


def runWithCore(name: str, *arguments: str) -> str:
    env = {**os.environ, 'PYTHONPATH': str(pathlib.Path(thaw.__file__).parents[1])}
    line = [sys.executable, str(EXAMPLES / name), *arguments]
    done = subprocess.run(line, env=env, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_a_sweep_melts_more_on_hotter_plates_and_repeats_no_run(tmp_path: pathlib.Path) -> None:
    needsSimulations()
    first = runWithCore('sweep.py', str(tmp_path))
    shares = [float(s) for s in re.findall(r'degC: ([\d.]+) % liquid', first)]
    assert len(shares) == 4 and shares == sorted(shares) and 10 < shares[0] < shares[-1] < 60
    before = (tmp_path / 'plate_100/summary.json').stat().st_mtime_ns
    assert runWithCore('sweep.py', str(tmp_path)) == first
    assert (tmp_path / 'plate_100/summary.json').stat().st_mtime_ns == before


def test_an_optimisation_reaches_its_target() -> None:
    pytest.importorskip('scipy')
    needsSimulations()
    lines = runWithCore('optimise.py', '0.15').splitlines()
    assert re.fullmatch(r'\d+ degC melts 15 %', lines[-1])
    shares = [float(re.search(r'([\d.]+) % liquid', line)[1]) for line in lines[:-1]]
    assert min(abs(s - 15) for s in shares) < 0.5


def test_a_coupled_pendulum_gives_its_energy_to_the_water() -> None:
    needsSimulations()
    last = runWithCore('coupling.py', '0.4').splitlines()[-1]
    lost, got = (float(x) for x in re.findall(r'([-\d.]+) J', last))
    assert lost > 10 and abs(lost - got) < 0.1 * lost
