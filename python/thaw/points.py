# SPDX-License-Identifier: Apache-2.0
"""Points of one file of a frame, with their fields."""
from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Dict, Iterator, List, NamedTuple, Optional, Tuple, Union

import numpy as np

from .errors import FieldError, FileError, unknownName
from .hdf_file import HdfFile, textOf
from .meanings import OUTPUT_FIELDS, meaningOf
from .scene_text import namesOf, numbersOf, sceneOf

if TYPE_CHECKING:
    import h5py

DATA = '/VTKHDF/PointData'


class Field(NamedTuple):
    """Metadata of a field, without its values."""

    unit: str
    meaning: str
    shape: Tuple[int, ...]
    dtype: np.dtype


@dataclasses.dataclass(frozen=True)
class Head:
    """A file without its rows."""

    time: float
    step: int
    count: int
    fields: Dict[str, Field]
    scene_name: str
    scene: str
    code: str
    ranks: int


def datasetOf(name: str) -> str:
    return '/VTKHDF/Points' if name == 'position' else f'{DATA}/{name}'


def fieldOf(data: h5py.Dataset, kind: str, name: str) -> Field:
    unit, meaning = (textOf(data.attrs.get(key, '')) for key in ('units', 'meaning'))
    return Field(unit, meaning or meaningOf(kind, name), data.shape, data.dtype)


def readHead(hdf: HdfFile, kind: str) -> Head:
    """Reads time, sizes and fields. Raises FileError where they do not fit together."""
    with hdf.open() as file:
        if 'VTKHDF/Points' not in file or DATA not in file:
            raise FileError(hdf.path, 'is not a frame: it has no points; expected a file of a folder frames/')
        points = file['VTKHDF/Points']
        count = len(points)
        pieces = file['VTKHDF/NumberOfPoints'][()]
        if points.shape != (count, 3) or pieces.sum() != count:
            raise FileError(hdf.path, 'is damaged: its pieces do not have as many points as the file')
        fields = {'position': fieldOf(points, kind, 'position')}
        for name, data in file[DATA].items():
            fields[name] = fieldOf(data, kind, name)
            if data.shape[:1] != (count,):
                raise FileError(
                    hdf.path, f'is damaged: field {name} has {data.shape} rows for {count} points'
                )
        run = file['run'] if 'run' in file else None
        text = {n: textOf(run[n][()]) if run and n in run else '' for n in ('scene_name', 'scene_toml')}
        return Head(
            time=float(file['VTKHDF/FieldData/Time'][0]),
            step=int(file['VTKHDF/FieldData/Step'][0]),
            count=count,
            fields=fields,
            scene_name=text['scene_name'],
            scene=text['scene_toml'],
            code=textOf(run.attrs.get('code', '')) if run else '',
            ranks=int(run.attrs.get('ranks', 0)) if run else 0,
        )


class Points:
    """Points with fields: `points['velocity']` is an array with a row for each point, in the file's order.

    The order of rows changes from frame to frame; `by_id` and `match` sort by id. Values are read
    on access and are not kept. All errors are `FileError` or `FieldError`.
    """

    kind = 'particles'

    def __init__(self, path: str) -> None:
        self.path = path
        self._hdf = HdfFile(path)
        self._known: Optional[Head] = None
        self._order: Optional[np.ndarray] = None

    def _head(self) -> Head:
        if self._known is None:
            self._known = readHead(self._hdf, self.kind)
        return self._known

    @property
    def time(self) -> float:
        """Simulated time, s."""
        return self._head().time

    @property
    def step(self) -> int:
        """Number of the time step."""
        return self._head().step

    @property
    def fields(self) -> Dict[str, Field]:
        """Fields of the file: name -> `Field(unit, meaning, shape, dtype)`."""
        return dict(self._head().fields)

    def __len__(self) -> int:
        """Number of points."""
        return self._head().count

    def __iter__(self) -> Iterator[str]:
        """Names of the fields."""
        return iter(self._head().fields)

    def __contains__(self, name: object) -> bool:
        return name in self._head().fields

    def __bool__(self) -> bool:
        return True  # a frame without points is a frame

    def __getitem__(self, name: str) -> np.ndarray:
        """Values of a field: shape (n,) or (n, components), SI units, with the type of the file.

        Raises FieldError for an unknown name, with a list of the known ones.
        """
        if name not in self._head().fields:
            raise self._unknown(name)
        with self._hdf.open() as file:
            return file[datasetOf(name)][()]

    def _unknown(self, name: object) -> FieldError:
        """The exception for a name that is not a field."""
        more = OUTPUT_FIELDS if self.kind == 'particles' else ()
        return unknownName(name, self._head().fields, f'{self.path} ({self.kind})', optional=more)

    @property
    def order(self) -> np.ndarray:
        """Rows of the file, ascending by id: int64 (n,)."""
        if self._order is None:
            self._order = np.argsort(self['id'], kind='stable')
        return self._order

    def by_id(self, name: str) -> np.ndarray:
        """Values of a field, ascending by id. Shape and unit are those of the field.

        Arrays of two frames match row by row if both frames have the same ids. If points enter or leave, use
        `match`.
        """
        return self[name][self.order]

    def match(self, other: 'Points') -> Tuple[np.ndarray, np.ndarray]:
        """Rows of this object and of `other` with the same id, ascending by id: two int64 arrays (m,).

        `rows, others = a.match(b)`, then `a['position'][rows] - b['position'][others]`.
        """
        own, theirs = self.by_id('id'), other.by_id('id')
        if len(theirs) == 0:
            return self.order[:0], other.order
        at = np.minimum(np.searchsorted(theirs, own), len(theirs) - 1)
        both = theirs[at] == own
        return self.order[both], other.order[at[both]]

    def __repr__(self) -> str:
        return f'<{self.kind} of {self.path}>'


class BodyPoints(Points):
    """Points that belong to bodies of the scene."""

    _body_field = 'body'

    @property
    def bodies(self) -> List[str]:
        """Names of the bodies in the scene, in the order of their numbers; emitters follow the bodies."""
        head = self._head()
        return namesOf(sceneOf(head.scene, self.path), self.kind)

    def body(self, which: Union[str, int]) -> np.ndarray:
        """Mask of the points of a body, by its name or its number in the scene: bool (n,).

        `frame['velocity'][frame.body('drop')]`. Raises FieldError for an unknown name.
        """
        numbers = [int(which)] if isinstance(which, (int, np.integer)) else numbersOf(self.bodies, which)
        if not numbers or not 0 <= numbers[0] < max(len(self.bodies), 1):
            raise unknownName(which, self.bodies, f'{self.path} ({self.kind})', 'body')
        return np.isin(self._bodyNumbers(), numbers)

    def _bodyNumbers(self) -> np.ndarray:
        return self[self._body_field]
