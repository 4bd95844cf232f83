# SPDX-License-Identifier: Apache-2.0
"""Cells of a notebook: progress bar and picture. Skipped without IPython."""
from __future__ import annotations

import pathlib

import pytest

SCENE = '''
import thaw
sim = thaw.Simulation({
    'spacing': 0.05, 'end': 0.05, 'domain': {'min': [-1, -1, -1], 'max': [1, 1, 1]},
    'material': {'jelly': {'young': '20 kPa'}}, 'body': [{'sphere': {'radius': 0.2}, 'material': 'jelly'}],
})
'''


def test_cells_show_progress_and_pictures(tmp_path: pathlib.Path, monkeypatch, capsys) -> None:
    shells = pytest.importorskip('IPython.core.interactiveshell')
    from thaw._load import core

    try:
        core()
    except ImportError as error:
        pytest.skip(str(error))
    monkeypatch.setenv('IPYTHONDIR', str(tmp_path))
    shell = shells.InteractiveShell()
    shell.run_cell(SCENE).raise_error()
    capsys.readouterr()
    shell.run_cell('sim.run(progress=True)').raise_error()
    bar = capsys.readouterr().err
    assert bar.endswith('\n') and '[' + 30 * '#' + '] 100.0 %  t 0.05 s' in bar.split('\r')[-1]
    picture = shell.run_cell('sim.picture()')
    picture.raise_error()
    forms, _ = shell.display_formatter.format(picture.result)
    assert forms['image/png'].startswith(b'\x89PNG')
