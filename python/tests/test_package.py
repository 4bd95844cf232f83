# SPDX-License-Identifier: Apache-2.0
"""The package itself: version, import without the compiled module, installation."""
from __future__ import annotations

import os
import pathlib
import re
import shutil
import subprocess
import sys

import pytest
from conftest import ROOT

import thaw

VERSION = re.search(r'project\(thaw VERSION ([\d.]+)', (ROOT / 'CMakeLists.txt').read_text())[1]
REPORT = 'import thaw; print(thaw.__version__, thaw.__file__)'


def importFrom(folder: pathlib.Path, code: str = REPORT) -> str:
    env = {**os.environ, 'PYTHONPATH': str(folder), 'PYTHONDONTWRITEBYTECODE': '1'}
    done = subprocess.run([sys.executable, '-c', code], env=env, cwd='/', capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_the_version_is_that_of_cmake() -> None:
    assert thaw.__version__ == VERSION


def test_the_compiled_module_is_needed_only_where_it_is_used() -> None:
    """Reading and scenes need none; a simulation names the way to get it."""
    code = 'import thaw; thaw.Scene(spacing=1); thaw.Simulation({})'
    done = subprocess.run(
        [sys.executable, '-c', code],
        env={**os.environ, 'PYTHONPATH': str(ROOT / 'python')},
        capture_output=True,
        text=True,
    )
    assert 'ImportError: simulations need the compiled part of the package' in done.stderr


def test_pip_installs_the_package_offline(tmp_path: pathlib.Path) -> None:
    pytest.importorskip('setuptools')
    if subprocess.run([sys.executable, '-m', 'pip', '--version'], capture_output=True).returncode != 0:
        pytest.skip('pip is not installed')
    source = tmp_path / 'source/python'  # a build writes beside its sources
    shutil.copytree(ROOT / 'python', source, ignore=shutil.ignore_patterns('build', '*.egg-info'))
    shutil.copy(ROOT / 'CMakeLists.txt', tmp_path / 'source')
    line = [sys.executable, '-m', 'pip', 'install', '--no-index', '--no-deps', '--no-build-isolation']
    line += ['--target', str(tmp_path / 'site'), str(source)]
    done = subprocess.run(line, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    assert importFrom(tmp_path / 'site').split() == [VERSION, str(tmp_path / 'site/thaw/__init__.py')]
    assert (tmp_path / 'site/thaw/py.typed').exists()


def test_cmake_installs_the_package(tmp_path: pathlib.Path) -> None:
    build = os.environ.get('THAW_BUILD')
    if not build:
        pytest.skip('THAW_BUILD names no build folder')
    line = ['cmake', '--install', build, '--component', 'python', '--prefix', str(tmp_path)]
    subprocess.run(line, check=True, capture_output=True)
    (site,) = tmp_path.glob('lib*/**/python3/dist-packages')
    assert importFrom(site).split() == [VERSION, str(site / 'thaw/__init__.py')]
    assert (site / 'thaw/py.typed').exists() and not list(site.glob('**/__pycache__'))
    if list(pathlib.Path(build, 'python/thaw').glob('_core*.so')):
        code = 'import thaw._load; print(thaw._load.core().__file__)'
        assert pathlib.Path(importFrom(site, code).strip()).parent == site / 'thaw'
