# SPDX-License-Identifier: Apache-2.0
"""Damaged, incomplete and unusual folders, and runs that are being written."""
from __future__ import annotations

import os
import pathlib
import shutil
import subprocess
import time

import h5py
import numpy as np
import pytest
from conftest import DROPS, Maker, command

import thaw


def cutShort(path: pathlib.Path) -> None:
    path.write_bytes(path.read_bytes()[: path.stat().st_size * 2 // 3])


def test_what_is_no_run_is_refused(tmp_path: pathlib.Path, drops: str) -> None:
    with pytest.raises(thaw.FileError, match='no such folder'):
        thaw.open(tmp_path / 'missing')
    with pytest.raises(thaw.FileError, match='not a run folder'):
        thaw.open(tmp_path)
    (tmp_path / 'lock').write_text('')  # a run that is being set up
    assert len(thaw.open(tmp_path).frames) == 0 and thaw.open(tmp_path).running is None
    with pytest.raises(thaw.FileError, match=f'is a file; .* as {drops}'):
        thaw.open(f'{drops}/frames/drops_000000.hdf')


def test_the_newest_complete_frame_is_used(copyOfDrops: pathlib.Path) -> None:
    cutShort(copyOfDrops / 'frames/drops_000004.hdf')
    with pytest.warns(thaw.DamageWarning, match='drops_000004.hdf: is damaged'):
        run = thaw.open(copyOfDrops)
    assert run.frames[-1].number == 3 and 'drops_000004' in run.problems[0]
    (copyOfDrops / 'frames/drops_surface_000003.hdf').unlink()  # as if it was not written yet
    shutil.copy(copyOfDrops / 'frames/drops_000000.hdf', copyOfDrops / 'frames/drops_000009.hdf.part')
    with pytest.warns(thaw.DamageWarning):
        assert run.refresh().frames[-1].number == 2


def test_a_damaged_frame_in_between_is_named_when_it_is_read(copyOfDrops: pathlib.Path) -> None:
    cutShort(copyOfDrops / 'frames/drops_000002.hdf')
    run = thaw.open(copyOfDrops)
    assert len(run.frames) == 5 and len(run.frames[3]) == 51
    with pytest.raises(thaw.FileError, match='drops_000002.hdf: is damaged'):
        run.frames[2]['velocity']


def test_frames_are_found_without_their_index(copyOfDrops: pathlib.Path) -> None:
    times = thaw.open(copyOfDrops).frames.times
    (copyOfDrops / 'frames/drops_surface.hdf.series').unlink()
    (copyOfDrops / 'frames/drops.hdf.series').write_text('{"files": [{"na')
    assert (thaw.open(copyOfDrops).frames.times == times).all()
    (copyOfDrops / 'frames/drops_000001.hdf').write_bytes(b'')
    with pytest.warns(thaw.DamageWarning, match='drops_000001.hdf'):
        run = thaw.open(copyOfDrops)
    assert len(run.frames) == 5 and any('drops_000001' in line for line in run.problems)


def test_removed_frames_are_not_listed(copyOfDrops: pathlib.Path) -> None:
    run = thaw.open(copyOfDrops)
    frame = run.frames[1]
    for path in copyOfDrops.glob('frames/*_000001.hdf'):
        path.unlink()
    with pytest.raises(thaw.FileError, match='no such file.*refresh'):
        frame['velocity']
    assert [f.number for f in run.refresh().frames] == [0, 2, 3, 4]


def test_a_replaced_frame_is_noticed(copyOfDrops: pathlib.Path) -> None:
    run = thaw.open(copyOfDrops)
    frame = run.frames[1]
    assert len(frame) == 51
    shutil.copy(copyOfDrops / 'frames/drops_000002.hdf', copyOfDrops / 'new')
    os.replace(copyOfDrops / 'new', copyOfDrops / 'frames/drops_000001.hdf')
    with pytest.raises(thaw.FileError, match='replaced by the run'):
        frame['velocity']
    assert run.frames[1]['velocity'].shape == (51, 3)


def test_a_checkpoint_alone_is_a_run(copyOfDrops: pathlib.Path, drops: str) -> None:
    for path in copyOfDrops.iterdir():
        if path.name != 'checkpoint':
            shutil.rmtree(path) if path.is_dir() else path.unlink()
    run, whole = thaw.open(copyOfDrops), thaw.open(drops)
    assert len(run.frames) == 0 and len(run.frames.times) == 0 and run.name == 'drops'
    assert run.scene == whole.scene and run.bodies == whole.bodies
    x = run.checkpoint['particles/position']
    assert x.dtype == np.float64 and run.checkpoint.fields['particles/position'].unit == 'm'
    order = np.argsort(run.checkpoint['particles/id'])
    assert np.allclose(x[order], whole.frames[-1].by_id('position'), atol=1e-8)
    assert run.compare(whole).equal and run.checkpoint.time == whole.frames[-1].time
    with pytest.raises(thaw.MissingError, match='has no frames'):
        run.frames.at(0)
    with pytest.raises(thaw.FieldError, match="did you mean 'particles/velocity'"):
        run.checkpoint['particles/velocit']


def test_the_newest_readable_checkpoint_is_used(copyOfDrops: pathlib.Path) -> None:
    folder = copyOfDrops / 'checkpoint'
    shutil.copy(folder / 'a.hdf', folder / 'b.hdf')
    cutShort(folder / 'a.hdf')
    run = thaw.open(copyOfDrops)
    with pytest.warns(thaw.DamageWarning, match='a.hdf'):
        assert run.checkpoint.path.endswith('b.hdf')
    (folder / 'b.hdf').unlink()
    with pytest.warns(thaw.DamageWarning), pytest.raises(thaw.MissingError, match='no checkpoint'):
        run.refresh().checkpoint
    assert len(run.problems) == 1
    for name in ('frames', 'summary.json'):
        os.rename(copyOfDrops / name, copyOfDrops / f'no_{name}')
    with pytest.warns(thaw.DamageWarning):
        assert run.refresh().name == '' and len(run.frames) == 0


def test_a_damaged_row_of_a_checkpoint_is_found(copyOfDrops: pathlib.Path) -> None:
    path = copyOfDrops / 'checkpoint/a.hdf'
    with h5py.File(path) as file:
        at = file['particles/velocity'].id.get_offset()
    data = bytearray(path.read_bytes())
    data[at + 5] ^= 1
    path.write_bytes(data)
    run = thaw.open(copyOfDrops)
    assert len(run.checkpoint['particles/position']) == 51
    with pytest.raises(thaw.FileError, match='checksum of particles/velocity is wrong'):
        run.compare(run)


def test_no_damage_crashes_the_reader(copyOfDrops: pathlib.Path) -> None:
    """Flips, cuts, zeros and appends bytes. Each copy is refused, or its fields have the right shapes."""
    path = copyOfDrops / 'frames/drops_000002.hdf'
    whole, random = path.read_bytes(), np.random.default_rng(1)
    refused = 0
    for trial in range(200):
        data, at = bytearray(whole), int(random.integers(len(whole)))
        if trial % 4 == 0:
            data[at] ^= 1 << int(random.integers(8))
        elif trial % 4 == 1:
            del data[at:]
        elif trial % 4 == 2:
            data[at : at + 512] = bytes(len(data[at : at + 512]))
        else:
            del data[at : at + int(random.integers(1, 2000))]
        path.write_bytes(data)
        try:
            frame = thaw.open(copyOfDrops).frames[2]
            assert all(len(frame[name]) == 51 for name in frame)
        except thaw.FileError as error:
            refused += 1
            assert 'drops_000002.hdf' in str(error)
    assert refused > 120


def test_frames_of_several_scenes_need_a_choice(copyOfDrops: pathlib.Path, jet: str) -> None:
    for path in pathlib.Path(jet, 'frames').iterdir():
        shutil.copy(path, copyOfDrops / 'frames')
    with pytest.raises(thaw.FileError, match='several scenes: drops, jet'):
        thaw.open(copyOfDrops)
    assert thaw.open(copyOfDrops, scene='jet').bodies == ['jug']
    assert thaw.open(copyOfDrops, scene='drops').bodies == ['left', 'body 1']
    with pytest.raises(thaw.FileError, match="no frames of scene 'x'"):
        thaw.open(copyOfDrops, scene='x')


def test_a_running_run_can_be_read(maker: Maker) -> None:
    out = maker.folder / 'live'
    settings = ('--set', 'end=1000', '--set', 'output.every="0.5 ms"', '--progress', '0.01')
    line = command(maker.scene('live', DROPS), out, *settings)
    process = subprocess.Popen(line, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        run, counts, deadline = None, [], time.monotonic() + 240
        while len(set(counts)) < 4 and time.monotonic() < deadline:
            assert process.poll() is None
            if not (out / 'summary.json').exists():
                time.sleep(0.01)
                continue
            run = run.refresh() if run else thaw.open(out)
            counts.append(len(run.frames))
            assert run.running is True and run.summary.status == 'running'
            for frame in run.frames[-2:]:
                assert np.isfinite(frame['position']).all() and len(frame.surface) > 0
            assert run.ledger.rows >= len(run.frames) - 2
            assert run.progress.rows > 0
        assert len(set(counts)) >= 4
    finally:
        process.kill()
        process.wait()
    assert run and run.refresh().running is False  # its lock stays
