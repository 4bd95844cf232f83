# SPDX-License-Identifier: Apache-2.0
"""Tables over time: ledger.csv, progress.csv, surface.csv, events.csv."""
from __future__ import annotations

import re
from typing import Dict, Iterator, List, Mapping, Tuple

import numpy as np

from .errors import FileError, unknownName

UNITS = {
    'kg_m2_per_s': 'kg m^2/s',
    'kg_m_per_s': 'kg m/s',
    'N_s': 'N s',
    'kg': 'kg',
    'm3': 'm^3',
    'm2': 'm^2',
    'J': 'J',
    's': 's',
    'm': 'm',
}
UNIT = re.compile(f'(.+?)_({"|".join(UNITS)})')
TEXTS = ('dt_limited_by', 'kind')
OTHER_UNITS = {'steps_per_second': '1/s', 'seconds_left': 's', 'seconds_per_update': 's'}


def nameAndUnit(column: str) -> Tuple[str, str]:
    """`kinetic_J` -> ('kinetic', 'J')."""
    match = UNIT.fullmatch(column)
    return (match[1], UNITS[match[2]]) if match else (column, OTHER_UNITS.get(column, '1'))


def arrayOf(column: str, texts: List[str], path: str) -> np.ndarray:
    """int64 or uint64 where all are whole, else float64 with NaN for empty texts."""
    if column in TEXTS:
        return np.array(texts, dtype=np.str_)
    for dtype in (np.int64, np.uint64):
        try:
            return np.array([int(t) for t in texts], dtype=dtype)
        except (ValueError, OverflowError):
            continue
    try:
        return np.array([float(t) if t else np.nan for t in texts])
    except ValueError as error:
        raise FileError(path, f'is damaged: column {column}: {error}') from error


def wholeOf(values: np.ndarray) -> np.ndarray:
    """The values as int64 if all are whole, as in arrayOf; else a copy."""
    whole = (
        np.isfinite(values).all() and (values == np.rint(values)).all() and (np.abs(values) < 2**53).all()
    )
    return values.astype(np.int64) if whole else np.array(values)


def readRows(path: str) -> Tuple[List[str], List[List[str]]]:
    """Header and complete rows. Leaves out a last line without a line break, which is still being written."""
    try:
        with open(path, encoding='utf-8', errors='replace', newline='') as file:
            text = file.read()
    except FileNotFoundError:
        raise FileError(path, 'no such file; a run writes it from its start') from None
    except OSError as error:
        raise FileError(path, f'cannot be read: {error.strerror}') from error
    lines = text[: text.rfind('\n') + 1].splitlines()
    if not lines:
        raise FileError(path, 'is empty; expected a line with the names of its columns')
    names = lines[0].split(',')
    rows = [line.split(',') for line in lines[1:]]
    for number, row in enumerate(rows, 2):
        if len(row) > len(names):
            raise FileError(
                f'{path}:{number}',
                f'has {len(row)} values; expected at most {len(names)}, one for each column',
            )
        row += [''] * (len(names) - len(row))
    return names, rows


class Log(Mapping[str, np.ndarray]):
    """Columns of a table by name, without their units: `log['kinetic']`; `log.units['kinetic']` is 'J'.

    Numbers are int64 or float64 (r,), with NaN where the file has none. Vectors x, y, z are one column of
    shape (r, 3): `log['momentum']`.
    """

    def __init__(self, path: str) -> None:
        names, rows = readRows(path)
        columns = {n: arrayOf(n, [row[k] for row in rows], path) for k, n in enumerate(names)}
        self._adopt(path, len(rows), columns)

    @classmethod
    def ofColumns(cls, name: str, names: List[str], values: List[np.ndarray]) -> 'Log':
        """A table of numbers in memory, with names as in a file."""
        log = cls.__new__(cls)
        rows = len(values[0]) if values else 0
        log._adopt(name, rows, {n: wholeOf(v) for n, v in zip(names, values)})
        return log

    def _adopt(self, path: str, rows: int, columns: Dict[str, np.ndarray]) -> None:
        self.path = path
        self.rows = rows  #: number of rows
        self.units: Dict[str, str] = {}  #: name -> unit
        self._columns: Dict[str, np.ndarray] = {}
        for column in columns:
            name, unit = nameAndUnit(column)
            vector = [re.sub('_x(?=_|$)', f'_{a}', column) for a in 'xyz']
            if vector[0] == column and vector[1] != column and all(v in columns for v in vector):
                name = nameAndUnit(vector[0])[0][:-2]
                self._columns[name] = np.stack([columns[v] for v in vector], axis=-1)
            elif re.search('_[yz](?=_|$)', column) and re.sub('_[yz](?=_|$)', '_x', column) in columns:
                continue
            else:
                self._columns[name] = columns[column]
            self.units[name] = unit

    def __getitem__(self, name: str) -> np.ndarray:
        """A column. Raises FieldError for an unknown name, with a list of the known ones."""
        if name not in self._columns:
            raise unknownName(name, self._columns, self.path, 'column')
        return self._columns[name]

    def __contains__(self, name: object) -> bool:
        return name in self._columns

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    def __repr__(self) -> str:
        return f'<{self.rows} rows of {self.path}: {", ".join(self._columns)}>'
