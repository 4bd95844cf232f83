# SPDX-License-Identifier: Apache-2.0
"""A frame of a run: particles, surfels, sheets and oriented particles at one time."""
from __future__ import annotations

import dataclasses
import os
from typing import TYPE_CHECKING, Callable, Dict, Optional, Tuple, Type, TypeVar

import numpy as np

from .errors import FieldError, FileError, MissingError
from .mesh import Mesh, exportedMesh, makeMesh, readPly, surfaceMesh
from .points import BodyPoints, Head, Points

if TYPE_CHECKING:
    from .compare import Comparison

SUFFIXES = {'particles': '', 'surface': '_surface', 'sheets': '_sheet', 'oriented': '_oriented'}
TRIANGLE = 5  # type of a cell in VTK


def frameFile(folder: str, name: str, kind: str, number: int) -> str:
    return os.path.join(folder, f'{name}{SUFFIXES[kind]}_{number:06}.hdf')


def exportedElse(make: Callable[[str, Optional[float]], Mesh], path: str, cell: Optional[float]) -> Mesh:
    exported = exportedMesh(path) if cell is None else None
    return readPly(exported) if exported else make(path, cell)


class Surface(Points):
    """Surfels of a frame: oriented discs that cover the surfaces of bodies."""

    kind = 'surface'

    def mesh(self, cell: Optional[float] = None) -> Mesh:
        """Closed triangle meshes of all components.

        cell: edge of the cubes of the mesh's grid, in mean radii of the surfels. Default: reads a mesh that
        `thaw export --as ply` has left in the run's folder export/; if there is none, uses 1.

        The compiled part of the package makes the mesh. Without it, or if THAW_PROGRAM is set, the program
        thaw makes it: the one that THAW_PROGRAM names, else the one on PATH. Raises ProgramError if there is
        no program, or if it fails.
        """
        return exportedElse(surfaceMesh, self.path, cell)


class Oriented(BodyPoints):
    """Oriented particles of a frame."""

    kind = 'oriented'
    _body_field = 'oriented_body'

    def mesh(self) -> Mesh:
        """Triangles of surfaces and lines of curves, with the ids of the particles at their vertices.

        As for `Surface.mesh`, an exported mesh is read. If there is none, the program thaw makes the mesh:
        the one that THAW_PROGRAM names, else the one on PATH.
        """
        return exportedElse(makeMesh, self.path, None)


class Sheets(BodyPoints):
    """Vertices of the sheets of a frame."""

    kind = 'sheets'
    _body_field = 'sheet_body'

    @property
    def triangles(self) -> np.ndarray:
        """Rows of the three vertices of each triangle, in the order of the file: int32 or int64 (t, 3)."""
        head = self._head()
        with self._hdf.open() as file:
            types, corners = file['VTKHDF/Types'][()], file['VTKHDF/Connectivity'][()]
        if (types != TRIANGLE).any() or len(corners) != 3 * len(types):
            raise FileError(self.path, 'is damaged: its cells are not triangles')
        if len(corners) and not 0 <= corners.min() <= corners.max() < head.count:
            raise FileError(self.path, 'is damaged: a triangle has a vertex that does not exist')
        return corners.reshape(-1, 3)

    def mesh(self) -> Mesh:
        """The sheets as a mesh. Its vertices are in the order of the file; no program is needed."""
        x, triangles, body = self['position'], self.triangles, self['sheet_body']
        a, b, c = (x[triangles[:, k]].astype(np.float64) for k in range(3))
        normals = np.zeros((len(x), 3))
        for k in range(3):
            np.add.at(normals, triangles[:, k], np.cross(b - a, c - a))
        length = np.linalg.norm(normals, axis=1, keepdims=True)
        normals = np.where(length > 0, normals / np.where(length > 0, length, 1), [0.0, 0.0, 1.0])
        labels, component = np.unique(body[triangles[:, 0]], return_inverse=True)
        return Mesh(
            vertices=x,
            triangles=triangles.astype(np.int32),
            normals=normals.astype(np.float32),
            colors=self['color'],
            lines=np.empty((0, 2), np.int32),
            component=component.astype(np.int32),
            labels=labels.astype(np.uint64),
            ids=self['id'],
        )


PARTS: Dict[str, Type[Points]] = {'surface': Surface, 'sheets': Sheets, 'oriented': Oriented}
Part = TypeVar('Part', bound=Points)


class Frame(BodyPoints):
    """Particles of a frame, and its surface, sheets and oriented particles.

    `frame['temperature']` is an array over the particles; `frame.surface['normal']` is one over the surfels.
    A scene without bodies and emitters has frames without particles: `len(frame)` is 0.
    """

    def __init__(self, folder: str, name: str, number: int, time: float) -> None:
        super().__init__(frameFile(folder, name, 'particles', number))
        self._folder, self._name, self.number = folder, name, number
        self._time = time
        self._made: Dict[str, Points] = {}

    @property
    def time(self) -> float:
        """Simulated time, s."""
        return self._time

    @property
    def parts(self) -> Tuple[str, ...]:
        """Contents of the frame, from 'particles', 'surface', 'sheets' and 'oriented'."""
        return tuple(k for k in SUFFIXES if os.path.exists(self._file(k)))

    def _file(self, kind: str) -> str:
        return frameFile(self._folder, self._name, kind, self.number)

    def _part(self, cls: Type[Part]) -> Part:
        if cls.kind not in self._made:
            if cls.kind not in self.parts:
                raise MissingError(
                    f'{self.path}: this frame has no {cls.kind}; it has: {", ".join(self.parts) or "nothing"}'
                )
            self._made[cls.kind] = cls(self._file(cls.kind))
        return self._made[cls.kind]  # type: ignore[return-value]

    @property
    def surface(self) -> Surface:
        """Surfels. Raises MissingError if the scene has no [surface]."""
        return self._part(Surface)

    @property
    def sheets(self) -> Sheets:
        """Vertices of sheets. Raises MissingError if the scene has no [[sheet]]."""
        return self._part(Sheets)

    @property
    def oriented(self) -> Oriented:
        """Oriented particles. Raises MissingError if the scene has no [[oriented]]."""
        return self._part(Oriented)

    def _head(self) -> Head:
        if self._known is None and not os.path.exists(self.path):
            others = [k for k in self.parts if k in PARTS]
            if others:
                other = self._part(PARTS[others[0]])._head()
                self._known = dataclasses.replace(other, count=0, fields={})
        return super()._head()

    def _unknown(self, name: object) -> FieldError:
        if self.fields:
            return super()._unknown(name)
        others = ' or '.join(f"frame.{k}['{name}']" for k in self.parts)
        return FieldError(f"{self.path}: the run has no particles, so no field '{name}'; see {others}")

    def _bodyNumbers(self) -> np.ndarray:
        if 'body' in self or not self.fields:
            return self['body']
        return (self['id'] >> np.uint64(40)).astype(np.int64)

    def compare(self, other: 'Frame', tolerance: Optional[float] = None) -> 'Comparison':
        """Differences from another frame, as `thaw compare` finds them: see `Run.compare`."""
        from .compare import compareFrames

        return compareFrames(self, other, tolerance)

    def __repr__(self) -> str:
        return f'<Frame {self.number} at {self.time:.6g} s: {", ".join(self.parts)}>'
