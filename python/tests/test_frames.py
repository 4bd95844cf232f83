# SPDX-License-Identifier: Apache-2.0
"""Frames: their sequence, their fields, their order, bodies, surfaces, sheets, oriented particles."""
from __future__ import annotations

import pathlib
import subprocess

import h5py
import numpy as np
import pytest
from conftest import program

import thaw


def test_frames_are_a_lazy_sequence(drops: str) -> None:
    frames = thaw.open(drops).frames
    assert len(frames) == 5
    assert np.allclose(frames.times, [0, 0.001, 0.002, 0.003, 0.004])
    assert [f.number for f in frames] == [0, 1, 2, 3, 4]
    assert frames[-1].number == 4 and frames[1].time == frames.times[1]
    assert [f.number for f in frames[::-2]] == [4, 2, 0]
    assert frames.at(0.0012).number == 1 and frames.at(1).number == 4 and frames.at(-1).number == 0
    assert frames[-1].step > frames[0].step == 0
    with pytest.raises(IndexError, match='5 frames'):
        frames[5]


def test_a_path_object_opens_as_well(drops: str) -> None:
    assert len(thaw.open(pathlib.Path(drops)).frames) == 5


def test_values_are_those_of_the_file(drops: str) -> None:
    frame = thaw.open(drops).frames[2]
    with h5py.File(f'{drops}/frames/drops_000002.hdf') as file:
        assert set(frame) == {'position', *file['VTKHDF/PointData']}
        assert (frame['position'] == file['VTKHDF/Points'][()]).all()
        for name, data in file['VTKHDF/PointData'].items():
            values = frame[name]
            assert values.dtype == data.dtype and (values == data[()]).all()
            assert frame.fields[name].shape == values.shape
            assert frame.fields[name].unit == data.attrs['units'].decode()
            assert frame.fields[name].meaning
        assert frame.time == file['VTKHDF/FieldData/Time'][0]
        assert frame.step == file['VTKHDF/FieldData/Step'][0]
    assert len(frame) == len(frame['id']) and 'density' in frame and 'stress' not in frame


def test_an_unknown_field_lists_the_known_ones(drops: str) -> None:
    frame = thaw.open(drops).frames[0]
    with pytest.raises(KeyError, match="drops_000000.hdf .* did you mean 'velocity'.*density, id, position"):
        frame['velosity']
    with pytest.raises(thaw.FieldError, match=r"'stress' is written where \[output\] fields"):
        frame['stress']
    with pytest.raises(thaw.FieldError, match="no field 'x'"):
        frame.surface['x']


def test_arrays_by_id_match_between_frames(drops: str) -> None:
    first, last = thaw.open(drops).frames[0], thaw.open(drops).frames[-1]
    assert (first.by_id('id') == last.by_id('id')).all()
    assert (np.diff(first.by_id('id').astype(np.int64)) > 0).all()
    rows, others = first.match(last)
    assert (first['id'][rows] == last['id'][others]).all() and len(rows) == len(first)
    assert np.abs(first.by_id('position') - last.by_id('position'))[:, 2].max() < 0.003


def test_match_leaves_out_what_one_frame_lacks(jet: str) -> None:
    frames = thaw.open(jet).frames
    early, late = frames[-2], frames[-1]
    assert 0 < len(early) < len(late)
    rows, others = early.match(late)
    assert (early['id'][rows] == late['id'][others]).all()
    assert len(rows) == len(np.intersect1d(early['id'], late['id'])) > 0
    rows, others = frames[0].match(late)
    assert len(rows) == len(others) == 0
    assert len(late.match(frames[0])[0]) == 0


def test_a_frame_without_particles_has_empty_arrays(jet: str) -> None:
    frame = thaw.open(jet).frames[0]
    assert len(frame) == 0 and frame
    assert frame['position'].shape == (0, 3) and frame['temperature'].shape == (0,)
    assert frame.by_id('velocity').shape == (0, 3)
    assert frame.body('jug').shape == (0,) and frame.bodies == ['jug']


def test_a_body_is_a_mask_by_name_or_number(drops: str, bodies: str, jet: str) -> None:
    frame = thaw.open(drops).frames[-1]
    left, second = frame.body('left'), frame.body('body 1')
    assert left.dtype == bool and (left ^ second).all()
    assert (left == (frame['body'] == 0)).all() and (second == frame.body(1)).all()
    # without the field `body` the number is part of the id
    frame = thaw.open(bodies).frames[0]
    assert 'body' not in frame and frame.body('bust').all()
    assert frame.sheets.body('cloth').all() and frame.oriented.body('film').all()
    assert thaw.open(jet).frames[-1].body('jug').all()
    with pytest.raises(thaw.FieldError, match="no body 'bist'; did you mean 'bust'"):
        frame.body('bist')
    with pytest.raises(thaw.FieldError, match="no body '7'"):
        frame.body(7)


def test_a_frame_names_its_parts(drops: str, bodies: str) -> None:
    assert thaw.open(drops).frames[0].parts == ('particles', 'surface')
    frame = thaw.open(bodies).frames[1]
    assert frame.parts == ('particles', 'surface', 'sheets', 'oriented')
    assert frame.oriented['orientation'].shape == (36, 4)
    assert frame['stress'].shape == (64, 6) and frame.fields['stress'].unit == 'Pa'
    with pytest.raises(thaw.MissingError, match='no sheets; it has: particles, surface'):
        thaw.open(drops).frames[0].sheets


def test_sheets_have_triangles(bodies: str) -> None:
    sheets = thaw.open(bodies).frames[1].sheets
    triangles = sheets.triangles
    assert triangles.shape == (50, 3)
    mesh = sheets.mesh()
    x = mesh.vertices[mesh.triangles].astype(float)
    area = 0.5 * np.linalg.norm(np.cross(x[:, 1] - x[:, 0], x[:, 2] - x[:, 0]), axis=1).sum()
    assert area == pytest.approx(0.01, rel=0.01)
    assert np.allclose(np.linalg.norm(mesh.normals, axis=1), 1)
    assert (mesh.ids == sheets['id']).all() and list(mesh.labels) == [0]


def test_a_run_of_sheets_alone_has_frames_without_particles(sheet: str) -> None:
    run = thaw.open(sheet)
    frame = run.frames[-1]
    assert len(run.frames) == 3 and len(frame) == 0 and frame.fields == {} and len(frame.sheets) == 36
    assert frame.step > 0 and run.name == 'sheet' and 'cloth' in run.scene
    with pytest.raises(thaw.FieldError, match=r"frame.sheets\['velocity'\]"):
        frame['velocity']


def volumeOf(mesh: thaw.Mesh, component: int) -> float:
    a, b, c = mesh.vertices[mesh.triangles[mesh.component == component]].astype(float).transpose(1, 0, 2)
    return float(np.einsum('ij,ij->', a, np.cross(b, c)) / 6)


def test_the_mesh_of_a_surface_has_the_volume_of_the_surface(drops: str) -> None:
    run = thaw.open(drops)
    mesh = run.frames[-1].surface.mesh()
    last = run.components['frame'] == 4
    assert (mesh.labels == run.components['component'][last]).all()
    for k, volume in enumerate(run.components['volume'][last]):  # one drop lies across a periodic side
        assert volumeOf(mesh, k) == pytest.approx(volume, rel=0.05)
    assert mesh.normals.shape == mesh.vertices.shape == mesh.colors.shape and mesh.ids is None
    coarse = run.frames[-1].surface.mesh(cell=2)
    assert 0 < len(coarse.triangles) < 0.9 * len(mesh.triangles)


def withoutCore() -> None:
    raise ImportError('no compiled part')


def test_the_compiled_part_makes_the_mesh_of_the_program(drops: str, monkeypatch: pytest.MonkeyPatch) -> None:
    try:
        thaw._load.core()
    except ImportError as error:
        pytest.skip(str(error))
    surface = thaw.open(drops).frames[2].surface  # with a component across the periodic sides
    by_program = [surface.mesh(cell) for cell in (None, 2)]
    monkeypatch.delenv('THAW_PROGRAM')
    monkeypatch.setenv('PATH', '/nowhere')
    for cell, other in zip((None, 2), by_program):
        mesh = surface.mesh(cell)
        for name in ('vertices', 'triangles', 'normals', 'colors', 'component', 'labels'):
            assert len(getattr(mesh, name)) > 0
            assert np.array_equal(getattr(mesh, name), getattr(other, name)), name
    with pytest.raises(ValueError, match='cell: expected a number from 0.2 to 10, got 0'):
        surface.mesh(0)


def test_an_exported_mesh_is_read_without_the_program(
    copyOfDrops: pathlib.Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    surface = thaw.open(copyOfDrops).frames[1].surface
    made = surface.mesh()
    subprocess.run([program(), 'export', str(copyOfDrops), '--as', 'ply'], check=True, capture_output=True)
    monkeypatch.setenv('THAW_PROGRAM', '/nowhere/thaw')
    read = surface.mesh()
    assert (read.vertices == made.vertices).all() and (read.triangles == made.triangles).all()
    with pytest.raises(thaw.ProgramError, match='/nowhere/thaw'):
        surface.mesh(cell=2)
    monkeypatch.delenv('THAW_PROGRAM')
    monkeypatch.setenv('PATH', '/nowhere')
    monkeypatch.setattr('thaw.mesh.core', withoutCore)
    with pytest.raises(thaw.ProgramError, match='put it on PATH.*THAW_PROGRAM.*thaw export'):
        surface.mesh(cell=2)
    path = copyOfDrops / 'export/drops_surface_000001.ply'
    path.write_bytes(path.read_bytes()[:-100])
    with pytest.raises(thaw.FileError, match='cut short'):
        surface.mesh()
    path.write_bytes(b'ply\nnothing\n')
    with pytest.raises(thaw.FileError, match='thaw export --as ply'):
        surface.mesh()


def test_the_mesh_of_oriented_particles_has_their_ids(bodies: str) -> None:
    oriented = thaw.open(bodies).frames[0].oriented
    mesh = oriented.mesh()
    assert len(mesh.triangles) > 0 and mesh.ids is not None
    x = dict(zip(oriented['id'].tolist(), oriented['position']))
    assert all((x[i] == v).all() for i, v in zip(mesh.ids.tolist(), mesh.vertices))


def test_several_ranks_give_the_same_values(drops: str, dropsOnThreeRanks: str) -> None:
    one, three = thaw.open(drops).frames[-1], thaw.open(dropsOnThreeRanks).frames[-1]
    assert set(three['rank']) > {0} and set(one['rank']) == {0}
    for name in ('id', 'position', 'velocity', 'pressure'):
        assert (one.by_id(name) == three.by_id(name)).all()
    assert (one.surface.by_id('normal') == three.surface.by_id('normal')).all()
