# SPDX-License-Identifier: Apache-2.0
"""The scripts of examples/python run and give the right figures."""
from __future__ import annotations

import importlib.util
import os
import pathlib
import re
import shutil
import signal
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


def test_the_melting_front_is_plotted(bodies: str, tmp_path: pathlib.Path) -> None:
    pytest.importorskip('matplotlib')
    picture = tmp_path / 'front.png'
    assert str(picture) in runExample('melting_front.py', bodies, 'bust', str(picture))
    assert isPicture(picture)


def test_drops_are_counted_across_periodic_sides(drops: str, jet: str) -> None:
    run = thaw.open(drops)
    sizes = sorted((int(run.frames[0].body(k).sum()) for k in (0, 1)), reverse=True)
    lines = runExample('drops.py', drops).splitlines()
    volume = float(lines[-1].split()[-2])
    assert volume == pytest.approx(sum(sizes) * 0.002**3, rel=0.2)
    assert len(lines) == 6 and lines[0] == f'0.0000 s: 2 drops, particles in the largest: {sizes}'
    lines = runExample('drops.py', jet).splitlines()
    assert lines[0] == '0.0000 s: 0 drops, particles in the largest: []'


def test_drops_are_plotted(drops: str, tmp_path: pathlib.Path) -> None:
    pytest.importorskip('matplotlib')
    runExample('drops.py', drops, str(tmp_path / 'drops.png'))
    assert isPicture(tmp_path / 'drops.png')


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


def runWithCore(name: str, *arguments: str, ranks: int = 1) -> str:
    env = {**os.environ, 'PYTHONPATH': str(pathlib.Path(thaw.__file__).parents[1])}
    launch = ['mpirun', '-q', '-n', str(ranks)] if ranks > 1 else []
    line = [*launch, sys.executable, str(EXAMPLES / name), *arguments]
    done = subprocess.run(line, env=env, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def numbers(pattern: str, text: str) -> list[float]:
    return [float(found) for found in re.findall(pattern, text)]


def isPicture(path: pathlib.Path) -> bool:
    return path.read_bytes().startswith(b'\x89PNG')


def pictureFor(folder: pathlib.Path) -> list[str]:
    """The argument of a script that names its picture; none without matplotlib."""
    return [str(folder / 'picture.png')] if importlib.util.find_spec('matplotlib') else []


def test_melting_fronts_follow_neumanns_solution(tmp_path: pathlib.Path) -> None:
    pytest.importorskip('matplotlib')
    needsSimulations()
    lines = runWithCore('stefan.py', str(tmp_path / 'stefan.png'))
    errors = numbers(r'\(([-+\d.]+)%\)', lines)
    assert len(errors) == 12 and max(abs(e) for e in errors) < 1.5
    assert isPicture(tmp_path / 'stefan.png')


def test_a_study_continues_after_it_was_killed(tmp_path: pathlib.Path) -> None:
    needsSimulations()
    env = {**os.environ, 'PYTHONPATH': str(pathlib.Path(thaw.__file__).parents[1])}
    line = [sys.executable, str(EXAMPLES / 'study.py'), str(tmp_path / 'cut')]
    cut = subprocess.Popen(line, env=env, stdout=subprocess.PIPE, text=True, start_new_session=True)
    assert cut.stdout and 'steps' in cut.stdout.readline()  # the first run is complete
    os.killpg(cut.pid, signal.SIGKILL)
    cut.stdout.read()  # its end comes when all workers have ended
    cut.wait()
    done = {f: f.stat().st_mtime_ns for f in (tmp_path / 'cut').glob('*/summary.json') if isDone(f)}
    assert 1 <= len(done) < 12
    rest = runWithCore('study.py', str(tmp_path / 'cut'))
    assert len(re.findall('steps$', rest, re.M)) == 12 - len(done)
    assert all(f.stat().st_mtime_ns == written for f, written in done.items())
    heat = np.reshape(numbers(r': ([\d.]+) kJ', rest), (4, 3))
    assert (np.diff(heat, axis=0) > 0).all() and (np.diff(heat, axis=1) > 0).all()
    assert numbers(r': ([\d.]+) kJ', runWithCore('study.py', str(tmp_path / 'cut'))) == heat.ravel().tolist()


def isDone(summary: pathlib.Path) -> bool:
    return thaw.open(summary.parent).summary['status'] == 'done'


def test_a_ball_in_a_trap_swings_exactly(tmp_path: pathlib.Path) -> None:
    pytest.importorskip('matplotlib')
    needsSimulations()
    out = runWithCore('trap.py', str(tmp_path / 'trap.png'))
    assert numbers(r'largest error ([\de.-]+)', out)[0] < 0.002 and isPicture(tmp_path / 'trap.png')


def test_a_lamp_holds_its_set_point(tmp_path: pathlib.Path) -> None:
    pytest.importorskip('matplotlib')
    needsSimulations()
    out = runWithCore('lamp.py', str(tmp_path / 'lamp.png'))
    assert numbers(r'within ([\d.]+) K', out)[0] < 0.5 and isPicture(tmp_path / 'lamp.png')


def test_an_optimisation_reaches_its_melting_time(tmp_path: pathlib.Path) -> None:
    pytest.importorskip('scipy')
    needsSimulations()
    picture = pictureFor(tmp_path)
    out = runWithCore('optimise.py', '0.35', *picture)
    assert min(abs(t - 0.35) for t in numbers(r'degC: ([\d.]+) s', out)) < 0.003
    assert all(isPicture(pathlib.Path(path)) for path in picture)


def test_energies_are_drawn_during_the_run(tmp_path: pathlib.Path) -> None:
    pytest.importorskip('matplotlib')
    needsSimulations()
    out = runWithCore('live_energy.py', str(tmp_path / 'live.png'))
    assert numbers(r'drawn (\d+) times', out)[0] >= 2 and isPicture(tmp_path / 'live.png')
    assert not (tmp_path / 'live.png.part').exists()


def test_a_coupled_pendulum_gives_its_energy_to_the_water(tmp_path: pathlib.Path) -> None:
    needsSimulations()
    picture = pictureFor(tmp_path)
    out = runWithCore('coupling.py', '0.4', *picture)
    assert all(isPicture(pathlib.Path(path)) for path in picture)
    lost, got = numbers(r'([-\d.]+) J', out.splitlines()[-1])
    assert lost > 10 and abs(lost - got) < 0.02 * lost
    if shutil.which('mpirun') and importlib.util.find_spec('mpi4py'):
        assert runWithCore('coupling.py', '0.4', ranks=3) == out
