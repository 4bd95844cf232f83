# SPDX-License-Identifier: Apache-2.0
"""Runs of programs with extensions: their names in reports, and restarts by other programs."""
from __future__ import annotations

import os
import pathlib
import subprocess
import sys

import pytest
from conftest import program

import thaw

PROGRAM = '''
import sys
import thaw
thaw.register_extension('lamp', {'power': (100, 'W/kg')}, fields={'dose': ('J/kg', 'heat', COMPONENTS)},
                        heat=lambda p, t, values: values['power'] * p.mass)
scene = {
    'spacing': 0.05, 'end': 1, 'domain': {'min': [-1, -1, -1], 'max': [1, 1, 1]},
    'material': {'jelly': {'young': '20 kPa', 'conductivity': 1, 'heat_capacity': 1000}},
    'body': [{'box': {'size': [0.2, 0.2, 0.2]}, 'material': 'jelly'}], 'extension': {'lamp': {}},
}
try:
    sim = thaw.Simulation(scene, 'out', restart=sys.argv[1] == 'restart')
except Exception as error:
    sys.exit(f'{type(error).__name__}: {error}')
sim.run(steps=3)
sim.finish()
'''


def runProgram(folder: pathlib.Path, components: int, *options: str) -> subprocess.CompletedProcess:
    code = PROGRAM.replace('COMPONENTS', str(components))
    env = {**os.environ, 'PYTHONPATH': str(pathlib.Path(thaw.__file__).parents[1])}
    line = [sys.executable, '-c', code, *options]
    return subprocess.run(line, env=env, cwd=folder, capture_output=True, text=True)


@pytest.fixture(scope='module')
def lampRun(tmp_path_factory: pytest.TempPathFactory) -> pathlib.Path:
    from thaw._load import core

    try:
        core()
    except ImportError as error:
        pytest.skip(str(error))
    folder = tmp_path_factory.mktemp('lamp')
    done = runProgram(folder, 1, 'start')
    assert done.returncode == 0, done.stderr
    return folder


def infoOf(path: pathlib.Path, *options: str) -> list[str]:
    line = [program(), 'info', str(path), *options]
    return subprocess.run(line, capture_output=True, text=True, check=True).stdout.splitlines()


def test_reports_name_the_extensions_of_a_run(lampRun: pathlib.Path) -> None:
    out = lampRun / 'out'
    assert ['extensions', 'lamp'] in [line.split() for line in infoOf(out)]
    assert thaw.open(out).summary.extensions == ['lamp']
    checkpoints = sorted((out / 'checkpoint').glob('?.hdf'))
    assert checkpoints
    for path in checkpoints:
        assert ['extensions', 'lamp'] in [line.split() for line in infoOf(path)]
    (out / 'summary.json').rename(out / 'kept.json')  # the checkpoint alone names them
    try:
        assert ['extensions', 'lamp'] in [line.split() for line in infoOf(out)]
    finally:
        (out / 'kept.json').rename(out / 'summary.json')


def test_a_restart_with_another_number_of_components_is_refused(lampRun: pathlib.Path) -> None:
    done = runProgram(lampRun, 3, 'restart')
    problem = "field 'dose' of extension 'lamp' has 1 component, and this program declares 3"
    assert done.returncode != 0 and problem in done.stderr, done.stderr
    assert 'damaged' not in done.stderr
    assert runProgram(lampRun, 1, 'restart').returncode == 0
