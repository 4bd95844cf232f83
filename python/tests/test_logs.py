# SPDX-License-Identifier: Apache-2.0
"""Ledger, progress, components, events, summary, and values of the scene."""
from __future__ import annotations

import json
import pathlib

import numpy as np
import pytest

import thaw


def test_the_ledger_has_columns_with_units(drops: str) -> None:
    ledger = thaw.open(drops).ledger
    assert ledger.rows == 5 and len(ledger['time']) == 5
    assert ledger.units['kinetic'] == 'J' and ledger.units['momentum'] == 'kg m/s'
    assert ledger.units['wall_impulse'] == 'N s' and ledger.units['angular_momentum'] == 'kg m^2/s'
    assert ledger.units['mass'] == 'kg' and ledger.units['particles'] == '1' and ledger.units['dt'] == 's'
    assert ledger['momentum'].shape == (5, 3) and ledger['particles'].dtype == np.int64
    momentum = -9.81 * ledger['mass'] * ledger['time'] + ledger['momentum'][0, 2]
    assert np.allclose(ledger['momentum'][:, 2], momentum)
    with pytest.raises(thaw.FieldError, match="no column 'kinetic_J'; did you mean 'kinetic'"):
        ledger['kinetic_J']
    assert all(len(column) == 5 for column in ledger.values()) and 'potential' in ledger


def test_the_progress_has_texts_and_empty_columns(dropsOnThreeRanks: str) -> None:
    progress = thaw.open(dropsOnThreeRanks).progress
    assert progress['dt_limited_by'][0] == 'sound'
    assert np.isnan(progress['density_iterations']).all()  # the run does not use this solver
    assert progress['seconds_left'][0] == np.inf and progress.units['steps_per_second'] == '1/s'
    assert progress['surfels'].dtype == np.int64 and progress.units['surface_volume'] == 'm^3'


def test_components_have_a_row_for_each_frame_and_drop(drops: str) -> None:
    run = thaw.open(drops)
    components = run.components
    assert components.rows == 10 and components.units['volume'] == 'm^3' and components.units['x'] == 'm'
    frame = run.frames[0]
    labels = {int(frame['id'][frame.body(k)].min()) + 1 for k in (0, 1)}
    assert set(components['component']) == set(frame.surface['component']) == labels
    assert run.events.rows == 0 and list(run.events) == ['step', 'time', 'kind', 'component', 'other']


def test_the_summary_is_a_dict_with_attributes(drops: str) -> None:
    summary = thaw.open(drops).summary
    assert summary == json.loads(pathlib.Path(drops, 'summary.json').read_text())
    assert summary.status == 'done' and summary.ledger.now.mass_kg == summary['ledger']['now']['mass_kg']
    with pytest.raises(AttributeError, match="no key 'statsu'; did you mean 'status'"):
        summary.statsu


def test_a_run_has_its_scene(drops: str, bodies: str) -> None:
    run = thaw.open(drops)
    assert 'surface_tension' in run.scene and run.name == 'drops'
    assert run.bodies == ['left', 'body 1'] and run.spacing == 0.002
    assert np.allclose(run.domain.min, [-0.014, -0.014, 0]) and np.allclose(run.domain.max[2], 0.024)
    assert run.domain.periodic.tolist() == [True, True, False]
    assert np.allclose(run.domain.period, [0.028, 0.028, np.inf])
    assert not thaw.open(bodies).domain.periodic.any()


def test_lengths_of_a_scene_have_units() -> None:
    from thaw.scene_text import lengthOf

    cases = {'2 mm': 0.002, '-14 mm': -0.014, '1e1 cm': 0.1, '3um': 3e-6, '1 in': 0.0254, '0.5 m': 0.5}
    for text, value in cases.items():
        assert lengthOf(text, 'run') == pytest.approx(value)
    assert lengthOf(3, 'run') == 3
    for text in ('2 kg', 'mm', '1..2 m', '2 m^2'):
        with pytest.raises((thaw.FileError, ValueError)):
            lengthOf(text, 'run')


def test_lines_that_are_being_written_are_left_out(copyOfDrops: pathlib.Path) -> None:
    path = copyOfDrops / 'ledger.csv'
    whole = path.read_text()
    path.write_text(whole + '20,0.005,0.0')
    run = thaw.open(copyOfDrops)
    assert run.ledger.rows == 5
    path.write_text(whole + whole.splitlines()[-1] + '\n')
    assert run.ledger.rows == 5 and run.refresh().ledger.rows == 6


def test_damaged_logs_and_summaries_are_named(copyOfDrops: pathlib.Path) -> None:
    run = thaw.open(copyOfDrops)
    path = copyOfDrops / 'ledger.csv'
    whole = path.read_text()
    path.write_text(whole.replace('0.001', '0.0x1', 1))
    with pytest.raises(thaw.FileError, match='ledger.csv: is damaged: column time_s'):
        run.ledger
    path.write_text(whole + '1,' * 100 + '\n')
    with pytest.raises(thaw.FileError, match='ledger.csv:7'):
        run.ledger
    path.write_text('')
    with pytest.raises(thaw.FileError, match='is empty'):
        run.ledger
    path.unlink()
    with pytest.raises(thaw.FileError, match='ledger.csv: no such file'):
        run.ledger
    (copyOfDrops / 'summary.json').write_text('{"status": "do')
    with pytest.raises(thaw.FileError, match='summary.json: is not JSON'):
        run.summary
    (copyOfDrops / 'summary.json').unlink()
    with pytest.raises(thaw.FileError, match='summary.json: no such file'):
        run.summary
