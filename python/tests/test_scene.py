# SPDX-License-Identifier: Apache-2.0
"""Checks, schema and pictures of scenes; the stub of the compiled part."""
from __future__ import annotations

import ast
import inspect
import json
import os
import pathlib
import struct
import subprocess
import sys
import zlib

import numpy as np
import pytest
from conftest import BODIES, ROOT

import thaw
from thaw import picture


@pytest.fixture
def core():
    from thaw._load import core as load

    try:
        return load()
    except ImportError as error:
        pytest.skip(str(error))


def namesInStub(body: list, outer: str = '') -> set:
    names = set()
    for node in body:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            names.add(outer + node.name)
            names |= (
                namesInStub(node.body, outer + node.name + '.') if isinstance(node, ast.ClassDef) else set()
            )
    return names


def test_the_stub_has_the_names_of_the_module(core) -> None:
    stub = ast.parse((pathlib.Path(thaw.__file__).parent / '_core.pyi').read_text())
    found = set()
    for name, value in vars(core).items():
        if name.startswith('_'):
            continue
        found.add(name)
        if inspect.isclass(value):
            found |= {f'{name}.{m}' for m in vars(value) if not m.startswith('_') or m == '__init__'}
    inherited = {'ArrayGuard.__init__', 'LoadRows.__init__'}  # pybind11's, which raise
    assert namesInStub(stub.body) == found - inherited


def test_a_check_has_the_figures_of_the_program(tmp_path: pathlib.Path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / 'bodies.toml').write_text(BODIES)
    report = thaw.Scene('bodies.toml', numerics__cfl_sound=0.2).check(ranks=3)
    assert report and report.particles == 64 and report['estimate']['ranks'] == 3
    assert 0 < report['time_step']['start'] < 0.01 and report.run_time[0] <= report.run_time[1]
    assert '64 particles, dt' in repr(report) and report['title'] == ''
    assert sorted(p.name for p in tmp_path.iterdir()) == ['bodies.toml']


def test_a_check_reports_errors_with_their_place(tmp_path: pathlib.Path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    report = thaw.Scene({'material': {'wax': {'densty': 900}}}, name='mine').check()
    assert not report and report.errors[0]['line'] == 1 and report.errors[0]['file'] == 'mine'
    assert "unknown key 'densty'" in repr(report) and not list(tmp_path.iterdir())
    monkeypatch.setenv('THAW_PROGRAM', '/nowhere/thaw')  # the check needs no program
    assert 'nothing to simulate' in thaw.Scene(title='empty').check().errors[0]['message']


def test_extensions_are_in_documentation_and_schema(core) -> None:
    before = core.documentation()
    thaw.register_extension('wind', {'speed': (2, 'm/s', 0, 50, 'of the air')}, force=lambda p, t, values: 0)
    assert 'extension.wind' not in before and '| `speed` |' in core.documentation().replace(before, '')
    wind = thaw.Scene.schema()['properties']['extension']['properties']['wind']['properties']['speed']
    assert wind['maximum'] == 50 and wind['default'] == 2 and 'of the air' in wind['description']
    scene = parsed(BODIES)
    assert thaw.Scene({**scene, 'extension': {'wind': {'speed': 3}}}).check()
    report = thaw.Scene({**scene, 'extension': {'wind': {'speed': 60}}}).check()
    assert 'extension.wind.speed: must be between 0 and 50' in report.errors[0]['message']


def test_entries_of_lists_are_set_by_name_or_number() -> None:
    scene = thaw.Scene(body=[{'name': 'ball', 'sphere': {'radius': 1}}, {'material': 'wax'}])
    scene['body.ball.sphere.radius'] = 2
    scene['body.1.name'] = 'cube'
    scene['numerics.cfl_sound'] = 0.2
    assert scene['body.0.sphere.radius'] == 2 and scene['body.cube.material'] == 'wax'
    assert scene['numerics'] == {'cfl_sound': 0.2}
    with pytest.raises(
        KeyError, match="the list has no entry 'bal'; expected a name or number of: ball, cube"
    ):
        scene['body.bal.name'] = 'x'
    with pytest.raises(KeyError, match="there is no 'box'; there are: radius"):
        scene['body.ball.sphere.box.size']


def test_a_scene_of_a_scene_is_a_copy_with_other_keys() -> None:
    first = thaw.Scene({'spacing': 0.01, 'body': [{'name': 'ball', 'sphere': {'radius': 0.1}}]}, name='ball')
    other = thaw.Scene(first, end=3)
    other['body.ball.sphere.radius'] = 0.2
    assert other.name == 'ball' and other.keys['end'] == 3
    assert first['body.ball.sphere.radius'] == 0.1 and 'end' not in first.keys
    file = thaw.Scene(thaw.Scene(pathlib.Path('melt.toml'), spacing=0.02), body__bust__velocity=[0, 0, 1])
    assert file.name == 'melt.toml' and file.keys is None
    assert file.overrides == {'spacing': 0.02, 'body.bust.velocity': [0, 0, 1]}


def test_other_kinds_of_scenes_are_refused() -> None:
    for value, got in ((5, '5'), ([1], r'\[1\]'), ('spacing = 1\nend = 2\n', 'a text of several lines')):
        with pytest.raises(TypeError, match='scene: expected a path, a dict or a Scene, got ' + got):
            thaw.Scene(value)


def test_builders_have_the_keys_of_the_table(core) -> None:
    scene = thaw.Scene(
        spacing='5 cm',
        domain=thaw.Domain(min=[-1, -1, -1], max=[1, 1, 1]),
        material=[thaw.Material('wax', density=900, young='300 kPa')],
        body=[thaw.Body(name='ball', sphere={'radius': 0.2}, material='wax')],
        obstacle=thaw.Obstacle(name='floor', plane={'point': [0, 0, -0.5], 'normal': [0, 0, 1]}),
    )
    assert scene['obstacle.plane.normal'] == [0, 0, 1] and scene['domain.max'] == [1, 1, 1]
    report = scene.check()
    assert report and report.particles > 100, report
    assert list(inspect.signature(thaw.Material).parameters)[0] == 'name'
    assert {'density', 'young', 'melts'} <= set(inspect.signature(thaw.Material).parameters)
    assert {'sphere', 'velocity'} <= set(inspect.signature(thaw.Body).parameters)
    assert 'unit: kg/m^3' in thaw.Material.__doc__ and 'Default' in thaw.Numerics.__doc__
    with pytest.raises(TypeError, match="Material has no key 'densty'; did you mean 'density'?"):
        thaw.Material('wax', densty=900)
    with pytest.raises(TypeError, match='expected thaw.Material'):
        thaw.Scene(material=[{'density': 1}])


def test_simulations_need_no_h5py(core) -> None:
    code = (
        'import sys; sys.modules["h5py"] = None; import thaw; '
        'sim = thaw.Simulation(thaw.Scene(spacing=0.1, end=1, material={"w": {"sound_speed": 10}}, '
        'body=[{"sphere": {"radius": 0.3}, "material": "w"}])); sim.step(); print(sim.steps)'
    )
    env = {**os.environ, 'PYTHONPATH': str(pathlib.Path(thaw.__file__).parents[1])}
    done = subprocess.run([sys.executable, '-c', code], env=env, capture_output=True, text=True)
    assert done.stdout == '1\n', done.stderr


def test_the_schema_completes_keywords(core) -> None:
    schema = thaw.Scene.schema()
    stock = json.loads((ROOT / 'scenes/scene.schema.json').read_text())
    schema['properties']['extension'].pop('properties', None)  # tests register some
    assert schema == stock
    names = list(inspect.signature(thaw.Scene).parameters)
    assert names[0] == 'scene' and set(names[2:]) == set(schema['properties'])


def pixelsOf(png: bytes) -> np.ndarray:
    """Decodes a PNG without filters."""
    width, height = struct.unpack('>II', png[16:24])
    at = png.index(b'IDAT')
    data = zlib.decompress(png[at + 4 : at + 4 + int.from_bytes(png[at - 4 : at], 'big')])
    return np.frombuffer(data, np.uint8).reshape(height, 1 + 3 * width)[:, 1:].reshape(height, width, 3)


def test_the_nearest_sphere_is_drawn() -> None:
    x = np.array([[0, 0, 0], [0, 1, 0], [3, 0, 0], [4, 0, 0.0]])  # the second is behind the first
    image = picture.draw(x, np.array([0, 1, 0, 1]), size=(200, 100), eye=(2, -9, 0), at=(2, 0, 0))
    assert (pixelsOf(image.png()) == image.pixels).all() and '200 x 100' in repr(image)
    ink = (image.pixels != image.pixels[0, 0]).any(axis=2)
    columns = np.flatnonzero(ink.any(axis=0))
    left, right = image.pixels[50, columns[0] + 6].astype(int), image.pixels[50, columns[-1] - 6].astype(int)
    assert left[2] > left[1] and right[1] > right[2]  # the lowest colour is blue, the highest yellow
    assert picture.draw(np.zeros((0, 3))).pixels.shape == (480, 640, 3)
    with pytest.raises(ValueError):
        picture.draw(x, size=(1, 1))


def test_a_simulation_is_drawn(core) -> None:
    with thaw.Simulation(thaw.Scene({'body': [], **parsed(BODIES)})) as sim:
        shown = sim.picture(size=(320, 240))
        assert 0.02 < (shown.pixels != shown.pixels[0, 0]).any(axis=2).mean() < 0.9
        assert (sim.picture('velocity', size=(64, 64)).pixels != 0).any()
        with pytest.raises(KeyError, match="no field 'colour'"):
            sim.picture('colour')
        with sim.local() as p:
            assert {'velocity', 'temperature', 'fields'} <= set(dir(p))
            assert 'velocity' in p._ipython_key_completions_()


def parsed(text: str) -> dict:
    toml = pytest.importorskip('tomllib')
    return toml.loads(text)
