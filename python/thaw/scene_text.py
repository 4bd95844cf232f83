# SPDX-License-Identifier: Apache-2.0
"""Names and sizes from the scene that a run stores. Its text has all includes and settings resolved."""
from __future__ import annotations

import functools
import importlib
import re
import sys
from typing import Any, Dict, List, NamedTuple, Sequence

import numpy as np

from .errors import FileError

PREFIXES = {
    '': 1.0,
    'k': 1e3,
    'd': 0.1,
    'c': 0.01,
    'm': 1e-3,
    'u': 1e-6,
    '\u00b5': 1e-6,
    '\u03bc': 1e-6,
    'n': 1e-9,
}
TABLES = {'particles': ('body', 'emitter'), 'sheets': ('sheet',), 'oriented': ('oriented',)}


class RunDomain(NamedTuple):
    """The simulated box: `min` and `max`, float64 (3,), m, and `periodic`, bool (3,)."""

    min: np.ndarray
    max: np.ndarray
    periodic: np.ndarray

    @property
    def period(self) -> np.ndarray:
        """Length of the box along periodic axes and infinity along others, float64 (3,), m."""
        return np.where(self.periodic, self.max - self.min, np.inf)


@functools.lru_cache(maxsize=8)
def sceneOf(text: str, path: str) -> Dict[str, Any]:
    """The scene as a dict. Raises FileError if the text of the file `path` is not TOML."""
    toml = importlib.import_module('tomllib' if sys.version_info >= (3, 11) else 'tomli')
    try:
        return toml.loads(text)
    except ValueError as error:
        raise FileError(path, f'its scene is not readable: {error}') from error


def namesOf(scene: Dict[str, Any], kind: str) -> List[str]:
    """Names of the bodies of a kind, in the order of their numbers in frames."""
    names: List[str] = []
    for table in TABLES[kind]:
        names += [b.get('name') or f'{table} {k}' for k, b in enumerate(scene.get(table, []))]
    return names


def lengthOf(value: Any, path: str) -> float:
    """A length of a scene in m: a number, or a text with a unit."""
    if isinstance(value, (int, float)):
        return float(value)
    match = re.fullmatch(
        r'\s*([-+]?[0-9.]+(?:[eE][-+]?[0-9]+)?)\s*(?:(k|d|c|m|u|\u00b5|\u03bc|n|)m|(in))\s*', str(value)
    )
    if not match:
        raise FileError(path, f'its scene has {value!r}; expected a length in m, cm, mm')
    return float(match[1]) * (0.0254 if match[3] else PREFIXES[match[2]])


def domainOf(scene: Dict[str, Any], path: str) -> RunDomain:
    domain = scene.get('domain', {})

    def corner(name: str, default: float) -> np.ndarray:
        return np.array([lengthOf(x, path) for x in domain.get(name, [default] * 3)])

    def isPeriodic(side: Any) -> bool:
        return side == 'periodic' or (not isinstance(side, str) and 'periodic' in side)

    sides = domain.get('sides', {})
    periodic = np.array([isPeriodic(sides.get(axis, 'open')) for axis in 'xyz'])
    return RunDomain(corner('min', -1.0), corner('max', 1.0), periodic)


def spacingOf(scene: Dict[str, Any], path: str) -> float:
    return lengthOf(scene.get('spacing', 0.01), path)


def numbersOf(names: Sequence[str], name: str) -> List[int]:
    return [k for k, known in enumerate(names) if known == name]
