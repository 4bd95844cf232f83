# SPDX-License-Identifier: Apache-2.0
"""Comparisons have the result of `thaw compare`."""
from __future__ import annotations

import re
import subprocess
from typing import Dict, Tuple

import numpy as np
import pytest
from conftest import BODIES, DROPS, Maker, program

import thaw
from thaw.compare import compareSnapshots
from thaw.snapshot import snapshotOfCheckpoint


def compareByProgram(a: str, b: str, *options: str) -> Tuple[int, Dict[str, Tuple[int, int, float]]]:
    """Exit code, and of each field that differs: rows, ids, largest difference."""
    done = subprocess.run([program(), 'compare', a, b, '--all', *options], capture_output=True, text=True)
    line = r'^(\w+) (.+): (\d+) of (\d+) ids differ, by at most (\S+) '
    found = re.findall(line, done.stdout, re.M)
    return done.returncode, {f'{t}/{f}': (int(n), int(m), float(x)) for t, f, n, m, x in found}


def assertSame(result: thaw.Comparison, a: str, b: str, *options: str) -> None:
    code, differences = compareByProgram(a, b, *options)
    assert result.equal == (code == 0)
    different = {name: f for name, f in result.fields.items() if not f.equal}
    assert different.keys() == differences.keys()
    for name, (rows, ids, largest) in differences.items():
        f = different[name]
        assert (f.rows, f.ids) == (rows, ids), name
        assert f.largest == pytest.approx(largest, rel=0.01), name
        assert (f.rms > 0) == (f.largest > 0), name  # zeros of unlike sign differ by 0
        assert f.rms <= f.largest * 3**0.5


def test_runs_on_other_numbers_of_ranks_are_equal(drops: str, dropsOnThreeRanks: str) -> None:
    a, b = thaw.open(drops), thaw.open(dropsOnThreeRanks)
    result = a.compare(b, frames=True)
    assertSame(result, drops, dropsOnThreeRanks, '--frames')
    assert result.equal and len(result.frames) == 5 and 'particles/position' in result.fields
    assert 'equal' in str(result)


def test_differences_are_those_of_the_program(maker: Maker, drops: str) -> None:
    other = maker.run('other', DROPS, '--set', 'domain.gravity=[0,0,-9.8]')
    a, b = thaw.open(drops), thaw.open(other)
    result = a.compare(b)
    assertSame(result, drops, other)
    assert not result.equal and 'domain.gravity' in str(result)
    for tolerance in (0.01, 1e-9):
        assertSame(a.compare(b, tolerance), drops, other, '--tolerance', str(tolerance))
    frames = [f'{run}/frames/drops_000003.hdf' for run in (drops, other)]
    result = a.frames[3].compare(b.frames[3])
    particles = {k: f for k, f in result.fields.items() if k.startswith('particles/')}
    assertSame(thaw.Comparison('', '', result.general, particles, []), *frames)
    d = a.frames[3].by_id('velocity').astype(float) - b.frames[3].by_id('velocity')
    assert result.fields['particles/velocity'].largest == np.abs(d).max()
    assert result.fields['particles/velocity'].rms == pytest.approx(np.sqrt((d**2).sum(axis=1).mean()))


def test_frames_at_other_times_differ(drops: str) -> None:
    frames = thaw.open(drops).frames
    paths = [f'{drops}/frames/drops_surface_00000{k}.hdf' for k in (1, 2)]
    result = frames[1].compare(frames[2])
    surfels = {k: f for k, f in result.fields.items() if k.startswith('surfels/')}
    assertSame(thaw.Comparison('', '', result.general, surfels, []), *paths)
    assert any('time' in line for line in result.general)


def test_solids_sheets_and_oriented_particles_are_compared(maker: Maker, bodies: str) -> None:
    a = thaw.open(bodies)
    assert a.compare(a).equal and 'solids/bond weight' in a.compare(a).fields
    other = maker.run('softer', BODIES, '--set', 'material.wax.young="140 kPa"', name='bodies')
    result = a.compare(thaw.open(other))
    assertSame(result, bodies, other)
    tables = {name.split('/')[0] for name in result.fields}
    assert {'particles', 'solids', 'surfels', 'components', 'sheet', 'oriented'} <= tables


def test_runs_of_other_scenes_differ(drops: str, bodies: str, jet: str) -> None:
    for other in (bodies, jet):
        result = thaw.open(drops).compare(thaw.open(other))
        assert result.equal == (compareByProgram(drops, other)[0] == 0) is False
        assert any('in A only' in line for line in result.general)


def test_texts_of_the_scene_are_compared_and_numbers_are_numbers(drops: str) -> None:
    state = snapshotOfCheckpoint(thaw.open(drops).checkpoint)
    assert state.values and not any(name in state.numbers for name in state.values)
    name = next(iter(state.values))
    other = state._replace(values={**state.values, name: '"other"'})
    result = compareSnapshots(state, other, None)
    assert not result.equal and any(line.startswith(f'{name}: A ') for line in result.general)
    assert compareSnapshots(state, state._replace(values={}), None).general[0].endswith('is in A only')
