# SPDX-License-Identifier: Apache-2.0
"""Version of the package, from CMakeLists.txt. It is written into the package when that is installed."""
from __future__ import annotations

import pathlib
import re


def readVersion() -> str:
    try:
        from ._version import VERSION

        return VERSION
    except ImportError:
        lists = pathlib.Path(__file__).resolve().parents[2] / 'CMakeLists.txt'
        match = re.search(r'project\(thaw VERSION ([\d.]+)', lists.read_text() if lists.exists() else '')
        return match[1] if match else 'unknown'
