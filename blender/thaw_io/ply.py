# SPDX-License-Identifier: Apache-2.0
"""Reads the PLY files of `thaw export --as ply`, and writes meshes for scenes."""
import numpy as np

TYPES = {'char': 'i1', 'uchar': 'u1', 'short': 'i2', 'ushort': 'u2', 'int': 'i4', 'uint': 'u4', 'float': 'f4'}
TYPES['double'] = 'f8'


class PlyError(Exception):
    """The file is damaged, or does not have the form that thaw writes."""


def _header(file, path, comments):
    """Returns the elements as (name, count, fields), and lists the comments."""
    if file.readline().strip() != b'ply':
        raise PlyError(f'{path}: is not a PLY file')
    elements, order = [], None
    for line in file:
        words = line.decode('utf-8', 'replace').split()
        if words[:1] == ['end_header']:
            break
        if words[:1] == ['comment']:
            comments.append(line.decode('utf-8', 'replace').strip()[len('comment ') :])
        if words[:1] == ['format']:
            order = {'binary_little_endian': '<', 'binary_big_endian': '>'}.get(words[1])
        elif words[:1] == ['element']:
            elements.append((words[1], int(words[2]), []))
        elif words[:2] == ['property', 'list']:
            # Lists are those of triangles, as `thaw export` writes them.
            elements[-1][2].append(('count', order + TYPES[words[2]]))
            elements[-1][2].append((words[4], order + TYPES[words[3]], (3,)))
        elif words[:1] == ['property']:
            elements[-1][2].append((words[2], order + TYPES[words[1]]))
    if order is None:
        raise PlyError(f'{path}: expected a binary file of `thaw export --as ply`')
    return elements


def read(path):
    """Returns vertices (n, 3), triangles (m, 3), and the values of each further property of vertices."""
    vertices, face, others = _tables(path, [])
    return vertices, face['vertex_indices'], others


def objects(path):
    """Returns vertices and triangles of each named object: {name: (vertices, triangles)}."""
    comments, parts = [], {}
    vertices, face, _ = _tables(path, comments)
    names = [c[len('object ') :] for c in comments if c.startswith('object ')]
    for k, name in enumerate(names):
        triangles = face['vertex_indices'][face['component'] == k]
        used, numbers = np.unique(triangles, return_inverse=True)
        parts[name] = vertices[used], numbers.reshape(-1, 3)
    return parts


def _tables(path, comments):
    """Returns vertices, the table of faces, and the further properties of vertices."""
    tables = {}
    with open(path, 'rb') as file:
        try:
            for name, count, fields in _header(file, path, comments):
                dtype = np.dtype(fields)
                data = file.read(count * dtype.itemsize)
                if len(data) < count * dtype.itemsize:
                    raise PlyError(f'{path}: is truncated')
                tables[name] = np.frombuffer(data, dtype, count)
        except (KeyError, IndexError, TypeError, ValueError) as error:
            raise PlyError(f'{path}: has a damaged header: {error}') from error
    vertex, face = tables.get('vertex'), tables.get('face')
    if vertex is None or face is None or (len(face) and (face['count'] != 3).any()):
        raise PlyError(f'{path}: expected triangles of `thaw export --as ply`')
    vertices = np.column_stack([vertex[axis] for axis in 'xyz'])
    others = {name: vertex[name] for name in vertex.dtype.names if name not in 'xyz'}
    return vertices, face, others


def vectors(others, names):
    """Returns properties as one array (n, k), or None if one is missing."""
    return np.column_stack([others[n] for n in names]) if all(n in others for n in names) else None


def write(path, vertices, triangles):
    """Writes a closed mesh for a scene."""
    head = (
        f'ply\nformat binary_little_endian 1.0\nelement vertex {len(vertices)}\nproperty float x\n'
        f'property float y\nproperty float z\nelement face {len(triangles)}\n'
        'property list uchar int vertex_indices\nend_header\n'
    )
    faces = np.zeros(len(triangles), [('count', 'u1'), ('vertices', '<i4', (3,))])
    faces['count'], faces['vertices'] = 3, triangles
    with open(path, 'wb') as file:
        file.write(head.encode() + np.asarray(vertices, '<f4').tobytes() + faces.tobytes())
