# SPDX-License-Identifier: Apache-2.0
"""Triangles of surfaces, from the compiled part, the program thaw, or files of `thaw export`."""
from __future__ import annotations

import dataclasses
import os
import shutil
import subprocess
import tempfile
from typing import BinaryIO, Dict, List, Optional, Tuple

import numpy as np

from ._load import core
from .errors import FileError, ProgramError

TYPES = {'char': 'i1', 'uchar': 'u1', 'short': 'i2', 'ushort': 'u2', 'int': 'i4', 'uint': 'u4'}
TYPES.update({'float': 'f4', 'double': 'f8'})


@dataclasses.dataclass
class Mesh:
    """Triangles with vertices. Closed meshes have their normals outward."""

    vertices: np.ndarray  #: float32 (v, 3), m
    triangles: np.ndarray  #: int32 (t, 3), rows of `vertices`, counter-clockwise from outside
    normals: np.ndarray  #: float32 (v, 3), unit vectors
    colors: np.ndarray  #: uint8 (v, 3), red, green, blue
    lines: np.ndarray  #: int32 (l, 2), joined vertices of curves of oriented particles
    component: np.ndarray  #: int32 (t,), component or body of each triangle, an index of `labels`
    labels: np.ndarray  #: uint64 (c,), component label, or number of the sheet or oriented body
    ids: Optional[np.ndarray]  #: uint64 (v,), ids of the vertices; None for meshes around surfels

    def __repr__(self) -> str:
        return f'<Mesh of {len(self.vertices)} vertices, {len(self.triangles)} triangles>'


Element = Tuple[str, int, List[str]]


def readHeader(file: BinaryIO, path: str) -> Tuple[List[Element], List[int], str]:
    """Elements with their properties, the labels of the components, and the byte order."""
    elements: List[Element] = []
    labels: List[int] = []
    order = ''
    for number in range(1_000_000):
        line = file.readline(4096).decode('utf-8', 'replace')
        words = line.split()
        if not line.endswith('\n') or (number == 0 and words != ['ply']):
            break
        if words[0] == 'format':
            order = {'binary_little_endian': '<', 'binary_big_endian': '>'}.get(words[1], '')
        elif words[:2] == ['comment', 'component']:
            labels.append(int(words[2].rstrip(',')))
        elif words[0] == 'element':
            elements.append((words[1], int(words[2]), []))
        elif words[0] == 'property':
            elements[-1][2].append(' '.join(words[1:]))
        elif words == ['end_header'] and order:
            return elements, labels, order
    raise FileError(path, 'is not a mesh that `thaw export --as ply` has written')


def rowType(properties: List[str], order: str) -> np.dtype:
    """Type of a row; each list is a triangle."""
    fields: List[tuple] = []
    for text in properties:
        *kinds, name = text.split()
        if kinds[0] == 'list':
            fields += [('corners', order + TYPES[kinds[1]]), (name, order + TYPES[kinds[2]], 3)]
        else:
            fields.append((name, order + TYPES[kinds[0]]))
    return np.dtype(fields)


def readPly(path: str) -> Mesh:
    """Reads a file of `thaw export --as ply`. Raises FileError if it is damaged or of another program."""
    try:
        with open(path, 'rb') as file:
            elements, labels, order = readHeader(file, path)
            read: Dict[str, np.ndarray] = {}
            for name, count, properties in elements:
                rows = rowType(properties, order)
                data = file.read(count * rows.itemsize)
                if len(data) != count * rows.itemsize:
                    raise FileError(path, f'is cut short: it has fewer than {count} rows of {name}')
                read[name] = np.frombuffer(data, rows)
        return meshOf(read, labels, path)
    except OSError as error:
        raise FileError(path, f'cannot be read: {error.strerror}') from error
    except (ValueError, KeyError, IndexError, TypeError) as error:
        raise FileError(path, 'is not a mesh that `thaw export --as ply` has written') from error


def meshOf(read: Dict[str, np.ndarray], labels: List[int], path: str) -> Mesh:
    def columns(rows: np.ndarray, names: Tuple[str, ...], dtype: str) -> np.ndarray:
        return np.stack([rows[n] for n in names], axis=-1).astype(dtype)

    vertex, face, edge = read['vertex'], read['face'], read.get('edge')
    if len(face) and (face['corners'] != 3).any():
        raise FileError(path, 'has faces that are not triangles; expected a file of `thaw export --as ply`')
    ids = None
    if 'id_high' in (vertex.dtype.names or ()):
        ids = vertex['id_high'].astype(np.uint64) << np.uint64(32) | vertex['id_low'].astype(np.uint64)
    lines = np.empty((0, 2), np.int32) if edge is None else columns(edge, ('vertex1', 'vertex2'), 'i4')
    return Mesh(
        vertices=columns(vertex, ('x', 'y', 'z'), 'f4'),
        triangles=face['vertex_indices'].astype(np.int32),
        normals=columns(vertex, ('nx', 'ny', 'nz'), 'f4'),
        colors=columns(vertex, ('red', 'green', 'blue'), 'u1'),
        lines=lines,
        component=face['component'].astype(np.int32),
        labels=np.array(labels, dtype=np.uint64),
        ids=ids,
    )


def exportedMesh(frame: str) -> Optional[str]:
    """The file export/NAME_000012.ply of a frame in frames/, if it is not older than the frame."""
    folder, name = os.path.split(os.path.abspath(frame))
    path = os.path.join(os.path.dirname(folder), 'export', os.path.splitext(name)[0] + '.ply')
    try:
        return path if os.stat(path).st_mtime_ns >= os.stat(frame).st_mtime_ns else None
    except OSError:
        return None


def findProgram(purpose: str = '') -> str:
    """Path of the program thaw: the environment variable THAW_PROGRAM, else the one on PATH."""
    given = os.environ.get('THAW_PROGRAM')
    found = shutil.which(given or 'thaw')
    if found:
        return found
    raise ProgramError(
        f'THAW_PROGRAM names {given}, which is not a program; expected the path of thaw'
        if given
        else f'the program thaw is needed {purpose}: put it on PATH, or name it in THAW_PROGRAM'
        if purpose
        else 'triangles of this frame need the program thaw: put it on PATH, name it in THAW_PROGRAM, or run '
        '`thaw export RUN --as ply`, whose files are read'
    )


def surfaceMesh(frame: str, cell: Optional[float]) -> Mesh:
    """Meshes of a frame of surfels by the compiled part, if it is available and THAW_PROGRAM is not set."""
    if os.environ.get('THAW_PROGRAM'):
        return makeMesh(frame, cell)
    try:
        compiled = core()
    except ImportError:
        return makeMesh(frame, cell)
    with tempfile.TemporaryDirectory(prefix='thaw_') as folder:
        out = os.path.join(folder, 'mesh.ply')
        compiled.write_surface_file(os.fspath(frame), out, 1.0 if cell is None else float(cell))
        return readPly(out)


def makeMesh(frame: str, cell: Optional[float]) -> Mesh:
    """Calls `thaw export` for one frame, with a file in a temporary folder."""
    program = findProgram()
    with tempfile.TemporaryDirectory(prefix='thaw_') as folder:
        out = os.path.join(folder, 'mesh.ply')
        command = [program, 'export', frame, '--as', 'ply', '--out', out]
        command += [] if cell is None else ['--cell', repr(float(cell))]
        try:
            done = subprocess.run(command, capture_output=True, text=True, errors='replace')
        except OSError as error:
            raise ProgramError(f'{program} cannot be started: {error.strerror}') from error
        if done.returncode != 0:
            lines = (done.stderr or done.stdout).strip().splitlines() or ['no message']
            raise ProgramError(f'{" ".join(command)} failed with exit code {done.returncode}: {lines[-1]}')
        return readPly(out)
