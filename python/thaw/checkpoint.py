# SPDX-License-Identifier: Apache-2.0
"""Checkpoints: the whole state of a run in double precision."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING, Dict, List, Optional, Tuple

import numpy as np

from .errors import FileError, unknownName
from .hdf_file import HdfFile, checksumOfRows, textOf
from .points import Field

if TYPE_CHECKING:
    import h5py

FORMAT = 8
TABLES = {
    'particles': '/particles',
    'solids': '/solids',
    'bonds': '/bonds',
    'surfels': '/surfels',
    'components': '/surface/components',
    'events': '/surface/events',
    'oriented': '/oriented',
    'sheet': '/sheet',
}


class Checkpoint:
    """A checkpoint: `checkpoint['particles/position']` is float64 (n, 3), in m.

    The names of tables and columns are those of the program's state and change with its version.
    """

    def __init__(self, path: str) -> None:
        self.path = path
        self._hdf = HdfFile(path)
        with self._hdf.open() as file:
            about = dict(file['checkpoint'].attrs) if 'checkpoint' in file else {}
            if 'format' not in about:
                raise FileError(path, 'is not a checkpoint; expected a.hdf or b.hdf of a folder checkpoint/')
            if about['format'] != FORMAT:
                raise FileError(
                    path, f'has checkpoint format {about["format"]}; this version reads format {FORMAT}'
                )
            self.time = float(about['time'])  #: s
            self.step = int(about['step'])
            self.sequence = int(about['sequence'])
            self.scene = textOf(file['run/scene_toml'][()])
            self.scene_name = textOf(file['run/scene_name'][()])
            self.fields = fieldsIn(file)  #: 'table/column' -> Field(unit, meaning, shape, dtype)

    def __getitem__(self, name: str) -> np.ndarray:
        """A column by `table/column`: SI units. Raises FileError if its checksum is wrong."""
        if name not in self.fields:
            raise unknownName(name, self.fields, self.path, 'column')
        table, column = name.split('/')
        with self._hdf.open() as file:
            data = file[f'{TABLES[table]}/{column}']
            rows = data[()]
            if 'checksum' in data.attrs and int(data.attrs['checksum']) % 2**64 != checksumOfRows(rows):
                raise FileError(self.path, f'is damaged: the checksum of {name} is wrong')
        return rows

    def __contains__(self, name: object) -> bool:
        return name in self.fields

    def __repr__(self) -> str:
        return f'<Checkpoint {self.path} at {self.time:.6g} s, step {self.step}>'


def fieldsIn(file: h5py.File) -> Dict[str, Field]:
    fields = {}
    for table, group in TABLES.items():
        for name, data in file[group].items() if group in file else ():
            fields[f'{table}/{name}'] = Field(textOf(data.attrs.get('units', '')), '', data.shape, data.dtype)
    return fields


def newestCheckpoint(run: str) -> Tuple[Optional[Checkpoint], List[str]]:
    """The newest readable checkpoint of a run's folder, and the errors of the others."""
    found: List[Checkpoint] = []
    problems: List[str] = []
    for name in ('a.hdf', 'b.hdf'):
        path = os.path.join(run, 'checkpoint', name)
        if os.path.exists(path):
            try:
                found.append(Checkpoint(path))
            except FileError as error:
                problems.append(str(error))
    newest = max(found, key=lambda c: c.sequence) if found else None
    return newest, problems
