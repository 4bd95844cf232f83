# SPDX-License-Identifier: Apache-2.0
"""Comparison of two frames or checkpoints by id, with the meaning of `thaw compare`."""
from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Dict, List, Optional, Tuple

import numpy as np

from .snapshot import TITLES, Snapshot, Table, snapshotOfPoints

if TYPE_CHECKING:
    from .frame import Frame


@dataclasses.dataclass
class FieldDifference:
    """Differences of one field, over the ids that both sides have."""

    unit: str  #: unit of `largest` and `rms`
    ids: int  #: ids in both
    rows: int  #: ids with a difference: of bits, or above the tolerance
    largest: float  #: largest abs(a - b) of a component; infinite where only one of them is NaN
    largest_id: Optional[int]  #: id with the largest difference; None if no id differs
    rms: float  #: root of the mean over ids (of bonds, over bonds) of the squared length of a - b

    @property
    def equal(self) -> bool:
        """Whether no id differs."""
        return self.rows == 0


@dataclasses.dataclass
class Comparison:
    """Result of `Run.compare` and `Frame.compare`. `fields` has all fields that were compared."""

    a: str  #: path of the first file
    b: str  #: path of the second file
    general: List[str]  #: other differences: times, counters, sets of ids, fields of one side only
    fields: Dict[str, FieldDifference]  #: 'particles/velocity' -> differences
    frames: List['Comparison']  #: of `Run.compare(..., frames=True)`

    @property
    def equal(self) -> bool:
        """Whether all bits are equal or, with a tolerance, all differences are within the tolerance."""
        fields = all(f.equal for f in self.fields.values())
        return not self.general and fields and all(f.equal for f in self.frames)

    def __str__(self) -> str:
        lines = [f'A: {self.a}', f'B: {self.b}', 'equal' if self.equal else 'different', *self.general]
        for name, f in self.fields.items():
            if not f.equal:
                lines.append(
                    f'{name}: {f.rows} of {f.ids} ids differ, by at most {f.largest:.3g} {f.unit} at id '
                    f'{f.largest_id}, rms {f.rms:.3g} {f.unit}'
                )
        return '\n'.join(lines + [str(f) for f in self.frames if not f.equal])


Matches = Tuple[np.ndarray, np.ndarray]  # rows of A and rows of B


def sortedIds(ids: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Rows ascending by id, and for each row the number of earlier rows with its id: 0 without duplicates."""
    order = np.argsort(ids, kind='stable')
    first = np.searchsorted(ids[order], ids[order])
    return order, np.arange(len(ids)) - first


def pairsOf(ids: np.ndarray, nth: np.ndarray) -> np.ndarray:
    pairs = np.empty(len(ids), dtype=[('id', np.uint64), ('nth', np.int64)])
    pairs['id'], pairs['nth'] = ids, nth
    return pairs


def distinct(ids: np.ndarray) -> int:
    """Number of different values of an ascending array."""
    return int(np.count_nonzero(ids[1:] != ids[:-1])) + (len(ids) > 0)


def matchIds(a: Table, b: Table, general: List[str]) -> Matches:
    """Rows of both with the same id, ascending by id. Ids of one side only are added to `general`."""
    (order_a, nth_a), (order_b, nth_b) = sortedIds(a.ids), sortedIds(b.ids)
    ids_a, ids_b = a.ids[order_a], b.ids[order_b]
    unique = not nth_a.any() and not nth_b.any()
    keys = (ids_a, ids_b) if unique else (pairsOf(ids_a, nth_a), pairsOf(ids_b, nth_b))
    _, at_a, at_b = np.intersect1d(*keys, assume_unique=True, return_indices=True)
    for side, ids, at in (('A', ids_a, at_a), ('B', ids_b, at_b)):
        alone = np.delete(ids, at)
        if len(alone):
            general.append(f'{a.title}: {len(alone)} ids are in {side} only, the first {alone[0]}')
    twice = np.count_nonzero(nth_a[at_a])
    if twice:
        general.append(f'{a.title}: {twice} ids are duplicates')
    return order_a[at_a], order_b[at_b]


def commonColumns(
    a: Table, b: Table, own: Dict[str, str], theirs: Dict[str, str], out: List[str]
) -> List[str]:
    for name in own:
        if name not in theirs:
            out.append(f'{a.title}: field {name} is in A only')
    out += [f'{b.title}: field {name} is in B only' for name in theirs if name not in own]
    return [name for name in own if name in theirs]


def differ(x: np.ndarray, y: np.ndarray, allowed: Optional[float]) -> Tuple[np.ndarray, np.ndarray]:
    """For each value: whether it differs, and |x - y|. NaN equals NaN only."""
    bits = f'u{x.dtype.itemsize}'
    different = x.view(bits) != y.view(bits)
    with np.errstate(invalid='ignore', over='ignore'):
        far = np.abs(x.astype(np.float64) - y.astype(np.float64))
        far = np.where(x == y, 0.0, far)
    if x.dtype.kind == 'f':
        far = np.where(np.isnan(x) & np.isnan(y), 0.0, np.where(np.isnan(far), np.inf, far))
        if allowed is not None:
            different &= far > allowed
    return different, far


def scaleOf(arrays: Tuple[np.ndarray, ...]) -> float:
    """Largest finite magnitude."""
    finite = [np.abs(x[np.isfinite(x)]) for x in arrays]
    return max((float(x.max()) for x in finite if x.size), default=0.0)


@dataclasses.dataclass
class Pair:
    """Both sides, the tolerance, and the result."""

    a: Snapshot
    b: Snapshot
    tolerance: Optional[float]
    result: Comparison

    def compareColumn(self, tables: Tuple[Table, Table], name: str, rows: Matches, ids: np.ndarray) -> None:
        """Compares a column. ids: id of each pair of rows; a bond has that of its particle."""
        x, y = (t.read(name) for t in tables)
        title = tables[0].title
        if x.dtype != y.dtype or x.shape[1:] != y.shape[1:]:
            self.result.general.append(
                f'{title}: field {name} is {x.dtype} {x.shape[1:]} in A and {y.dtype} {y.shape[1:]} in B'
            )
            return
        allowed = None if self.tolerance is None or x.dtype.kind != 'f' else self.tolerance * scaleOf((x, y))
        pairs = [np.ascontiguousarray(v[r]) for v, r in zip((x, y), rows)]
        width = int(np.prod(x.shape[1:]))
        different, far = (v.reshape(len(ids), width) for v in differ(pairs[0], pairs[1], allowed))
        bad = different.any(axis=1)
        worst = far.max(axis=1, initial=0.0)
        units = tables[0].columns if name in tables[0].columns else tables[0].bonds
        self.result.fields[f'{title}/{name}'] = FieldDifference(
            unit=units[name],
            ids=distinct(ids),
            rows=distinct(ids[bad]),
            largest=float(worst.max(initial=0.0)),
            largest_id=int(ids[bad][np.argmax(worst[bad])]) if bad.any() else None,
            rms=float(np.sqrt(np.mean(np.sum(far**2, axis=1)))) if len(ids) else 0.0,
        )

    def compareBonds(self, a: Table, b: Table, rows: Matches) -> None:
        if a.first_bond is None or b.first_bond is None:
            return
        count_a, count_b = np.diff(a.first_bond)[rows[0]], np.diff(b.first_bond)[rows[1]]
        ids = a.ids[rows[0]]
        far = np.abs(count_a - count_b)
        if far.any():
            self.result.fields[f'{a.title}/number of bonds'] = FieldDifference(
                unit='1',
                ids=len(ids),
                rows=int((far > 0).sum()),
                largest=float(far.max()),
                largest_id=int(ids[np.argmax(far)]),
                rms=float(np.sqrt(np.mean(far.astype(float) ** 2))),
            )
        same = far == 0
        count = count_a[same]
        nth = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
        bonds = (
            np.repeat(a.first_bond[rows[0][same]], count) + nth,
            np.repeat(b.first_bond[rows[1][same]], count) + nth,
        )
        for name in commonColumns(a, b, a.bonds, b.bonds, self.result.general):
            self.compareColumn((a, b), name, bonds, np.repeat(ids[same], count))

    def compareTables(self) -> None:
        for title, a in self.a.tables.items():
            b = self.b.tables.get(title)
            if b is None:
                if len(a.ids):
                    self.result.general.append(f'{title} are in A only')
                continue
            rows = matchIds(a, b, self.result.general)
            if not len(a.ids) and not len(b.ids):
                continue
            for name in commonColumns(a, b, a.columns, b.columns, self.result.general):
                self.compareColumn((a, b), name, rows, a.ids[rows[0]])
            self.compareBonds(a, b, rows)
        for title, b in self.b.tables.items():
            if title not in self.a.tables and len(b.ids):
                self.result.general.append(f'{title} are in B only')

    def compareNumbers(self) -> None:
        scale: Dict[str, float] = {}
        for n in [*self.a.numbers.values(), *self.b.numbers.values()]:
            if np.isfinite(n.value):
                scale[n.unit] = max(scale.get(n.unit, 0.0), abs(n.value))
        for name, x in self.a.numbers.items():
            y = self.b.numbers.get(name)
            if y is None:
                self.result.general.append(f'{name} is in A only')
            elif x.bits != y.bits and not (x.value == y.value and self.tolerance is not None):
                far = abs(x.value - y.value)
                if self.tolerance is None or x.whole or not far <= self.tolerance * scale[x.unit]:
                    self.result.general.append(f'{name}: A {x.value!r}, B {y.value!r} {x.unit}'.rstrip())
        self.result.general += [
            f'{name} is in B only' for name in self.b.numbers if name not in self.a.numbers
        ]

    def compareValues(self) -> None:
        for name, x in self.a.values.items():
            y = self.b.values.get(name)
            if y is None:
                self.result.general.append(f'{name} is in A only')
            elif x != y:
                self.result.general.append(f'{name}: A {x}, B {y}')
        self.result.general += [f'{name} is in B only' for name in self.b.values if name not in self.a.values]


def compareSnapshots(a: Snapshot, b: Snapshot, tolerance: Optional[float]) -> Comparison:
    result = Comparison(a.path, b.path, [], {}, [])
    pair = Pair(a, b, tolerance, result)
    pair.compareNumbers()
    pair.compareValues()
    pair.compareTables()
    return result


def compareFrames(a: 'Frame', b: 'Frame', tolerance: Optional[float]) -> Comparison:
    """Compares all parts of two frames."""
    result = Comparison(a.path, b.path, [], {}, [])
    for kind, title in TITLES.items():
        if kind in a.parts and kind in b.parts:
            one, other = (snapshotOfPoints(x if kind == 'particles' else getattr(x, kind)) for x in (a, b))
            part = compareSnapshots(one, other, tolerance)
            result.general += [line for line in part.general if line not in result.general]
            result.fields.update(part.fields)
        elif kind in a.parts or kind in b.parts:
            result.general.append(f'{title} are in {"A" if kind in a.parts else "B"} only')
    return result
