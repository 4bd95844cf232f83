# SPDX-License-Identifier: Apache-2.0
"""The data of a frame or a checkpoint that `thaw compare` compares (io/compare/snapshot.hpp)."""
from __future__ import annotations

from typing import Any, Callable, Dict, List, NamedTuple, Optional

import numpy as np

from .checkpoint import TABLES, Checkpoint
from .errors import FileError
from .hdf_file import textOf
from .points import Points

TITLES = {'particles': 'particles', 'surface': 'surfels', 'sheets': 'sheet', 'oriented': 'oriented'}


class Number(NamedTuple):
    """A number of the whole state: a count, a real, or an exact sum with its digits."""

    unit: str
    value: float
    bits: bytes
    whole: bool


class Table(NamedTuple):
    """Columns whose rows have ids; `read` reads one. Bonds have `first_bond` of each row and the end."""

    title: str
    ids: np.ndarray
    columns: Dict[str, str]  #: name -> unit
    read: Callable[[str], np.ndarray]
    first_bond: Optional[np.ndarray] = None
    bonds: Dict[str, str] = {}


class Snapshot(NamedTuple):
    path: str
    numbers: Dict[str, Number]
    tables: Dict[str, Table]
    values: Dict[str, str] = {}  #: keys of the scene whose values are not numbers


def whole(value: Any) -> Number:
    return Number('1', float(value), np.int64(value).tobytes(), True)


def real(value: Any, unit: str) -> Number:
    return Number(unit, float(value), np.float64(value).tobytes(), False)


def tableOfPoints(points: Points) -> Table:
    columns = {n: f.unit for n, f in points.fields.items() if n not in ('id', 'rank')}
    if 'id' not in points:
        raise FileError(points.path, 'has no ids, so it cannot be compared')
    return Table(TITLES[points.kind], points['id'], columns, points.__getitem__)


def snapshotOfPoints(points: Points) -> Snapshot:
    head = points._head()
    numbers = {'time': real(head.time, 's'), 'step': whole(head.step)}
    return Snapshot(points.path, numbers, {TITLES[points.kind]: tableOfPoints(points)})


def numberOf(value: Any, unit: str = '') -> Number:
    return whole(value) if np.asarray(value).dtype.kind in 'iu' else real(value, unit)


def numbersOf(checkpoint: Checkpoint) -> Dict[str, Number]:
    with checkpoint._hdf.open() as file:
        top = file['checkpoint']
        numbers = {
            'time': real(top.attrs['time'], 's'),
            'step': whole(top.attrs['step']),
            'dt': real(top.attrs['dt'], 's'),
        }
        for name in ('counter', 'watch'):
            group = 'counters' if name == 'counter' else name
            for key, value in top[group].attrs.items() if group in top else ():
                numbers[f'{name} {key}'] = numberOf(value)
        units = {}
        for key, data in top['ledger'].items():
            units[key] = textOf(data.attrs['units'])
            value = float(data.attrs['value'])
            numbers[f'ledger {key}'] = Number(units[key], value, data[()].tobytes(), False)
        for key, value in top['initial'].attrs.items():
            numbers[f'initial {key}'] = real(value, units.get(f'entered_{key}', ''))
        if 'surface' in file:
            numbers['surface last_step'] = whole(file['surface'].attrs['last_step'])
            for key, value in file['surface/counters'].attrs.items():
                numbers[f'surface {key}'] = whole(value)
    return numbers


def valuesOf(checkpoint: Checkpoint) -> Dict[str, str]:
    """Returns the values of scene keys as texts, by name."""
    with checkpoint._hdf.open() as file:
        return {name: textOf(value) for name, value in file['checkpoint/values'].attrs.items()}


def asNumber(text: str) -> Optional[float]:
    try:
        return float(text)
    except ValueError:
        return None


def columnsOf(checkpoint: Checkpoint, table: str, without: List[str]) -> Dict[str, str]:
    begin = f'{table}/'
    return {
        n[len(begin) :]: f.unit
        for n, f in checkpoint.fields.items()
        if n.startswith(begin) and n[len(begin) :] not in without
    }


def snapshotOfCheckpoint(checkpoint: Checkpoint) -> Snapshot:
    tables: Dict[str, Table] = {}
    for title in TABLES:
        if title == 'bonds' or f'{title}/id' not in checkpoint:
            continue

        def read(name: str, title: str = title) -> np.ndarray:
            return checkpoint[f'{"bonds" if name.startswith("bond ") else title}/{name.split(" ")[-1]}']

        # "changed" marks rows that are recomputed after a migration; no bit of the state depends on it
        columns = columnsOf(checkpoint, title, ['id', 'changed'] if title == 'solids' else ['id'])
        tables[title] = Table(title, read('id'), columns, read)
    if 'solids' in tables:
        with checkpoint._hdf.open() as file:
            first = file['order/first_bond'][()].astype(np.int64)
        bonds = columnsOf(checkpoint, 'bonds', [])
        end = checkpoint.fields['bonds/neighbour'].shape[0]
        first = np.append(first, end)
        if len(first) != len(tables['solids'].ids) + 1 or (np.diff(first) < 0).any():
            raise FileError(checkpoint.path, 'is damaged: bonds are not in order')
        tables['solids'] = tables['solids']._replace(
            first_bond=first, bonds={f'bond {n}': u for n, u in bonds.items()}
        )
    numbers, values = numbersOf(checkpoint), valuesOf(checkpoint)
    for name in list(values):
        number = asNumber(values[name])
        if number is not None:
            numbers[name] = real(number, '')
            del values[name]
    return Snapshot(checkpoint.path, numbers, tables, values)
