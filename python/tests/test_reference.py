# SPDX-License-Identifier: Apache-2.0
"""The reference of the package in the manual, and its docstrings."""
from __future__ import annotations

import inspect
import subprocess
import sys

from conftest import ROOT

import thaw

PAGE = ROOT / 'docs/reference/python_api.md'
SCRIPT = ROOT / 'scripts/python_reference'


def test_the_reference_is_that_of_the_docstrings() -> None:
    done = subprocess.run([sys.executable, str(SCRIPT)], capture_output=True, text=True, check=True)
    assert (
        PAGE.read_text(encoding='utf-8') == done.stdout
    ), f'{PAGE.name} is out of date; write it with: scripts/python_reference > docs/reference/python_api.md'


def test_each_public_name_has_a_docstring_and_an_entry() -> None:
    page, missing = PAGE.read_text(encoding='utf-8'), []
    for name in thaw.__all__:
        value = getattr(thaw, name)
        assert f'### {name}\n' in page
        if not inspect.getdoc(value):
            missing.append(name)
        if not isinstance(value, type):
            continue
        for member, what in vars(value).items():
            function = getattr(what, 'fget', None) or getattr(what, '__func__', what)
            isPublic = not member.startswith('_') and inspect.isfunction(function)
            if isPublic and not inspect.getdoc(function):
                missing.append(f'{name}.{member}')
    assert not missing
