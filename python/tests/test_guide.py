# SPDX-License-Identifier: Apache-2.0
"""The guide of simulations runs as it is printed."""
from __future__ import annotations

import os
import pathlib
import re
import subprocess
import sys

import pytest
from conftest import ROOT

import thaw


def test_the_guide_of_simulations_runs_as_it_is_printed(tmp_path: pathlib.Path) -> None:
    from thaw._load import core

    try:
        core()
    except ImportError as error:
        pytest.skip(str(error))
    text = (ROOT / 'docs/howto/python_simulations.md').read_text()
    blocks = re.findall(r'```python\n(.*?)```', text, re.S)
    # One block needs an outside body (examples/python/coupling.py has one).
    apart = ('pendulum',)
    code = '\n'.join(block for block in blocks if not any(word in block for word in apart))
    assert code.count('thaw.Simulation(') >= 3
    (tmp_path / 'guide.py').write_text(code)
    env = {**os.environ, 'PYTHONPATH': str(pathlib.Path(thaw.__file__).parents[1])}
    line = [sys.executable, '-W', 'error::UserWarning', 'guide.py']
    done = subprocess.run(line, env=env, cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert 'spacing: must be > 0 m, got -1' in done.stdout
    assert (tmp_path / 'now.png').read_bytes().startswith(b'\x89PNG') and (tmp_path / 'out/ball').is_dir()
