# SPDX-License-Identifier: Apache-2.0
"""Checks the texture coordinates of a VTKHDF file of three frames, or of three bgeo files: read_uv.py FILE...

The body is a cube of 0.2 m that has moved by 0.05 m along x in each frame. Its texture has u = x and v = z.
"""
import struct
import sys

import numpy as np


def vtkhdf(path):
    """Returns points and texture coordinates of each frame."""
    import h5py

    file = h5py.File(path)['VTKHDF']
    begin = list(file['Steps/PointOffsets']) + [len(file['Points'])]
    return [(file['Points'][a:b], file['PointData/uv'][a:b]) for a, b in zip(begin, begin[1:])]


class Bgeo:
    """Houdini geometry of one frame, read as its documentation describes it."""

    def __init__(self, path):
        self.bytes, self.at = open(path, 'rb').read(), 5
        version, points, polygons, _, _, of_points, of_corners, _, _ = self.numbers('9i')
        assert self.bytes[:5] == b'BgeoV' and version == 5 and of_corners == 1
        floats = 4 + sum(self.attribute()[1] for _ in range(of_points))
        position = np.frombuffer(self.bytes, '>f4', points * floats, self.at).reshape(points, floats)[:, :3]
        self.at += 4 * points * floats
        assert self.attribute() == ('uv', 3)
        index, self.uv = [], []
        while len(index) < 3 * polygons:
            run, count, kind = self.numbers('ihi')
            assert (run, kind) == (-1, 1)
            for _ in range(count):
                assert self.numbers('ic') == (3, b'<')
                for _ in range(3):
                    corner, *uv = self.numbers('H3f' if points <= 0xFFFF else 'I3f')
                    index.append(corner), self.uv.append(uv[:2])
        assert self.bytes[self.at :] == b'\x00\xff'
        self.points, self.uv = position[index].astype(float), np.array(self.uv)

    def numbers(self, form):
        found = struct.unpack_from('>' + form, self.bytes, self.at)
        self.at += struct.calcsize('>' + form)
        return found

    def attribute(self):
        length = self.numbers('h')[0]
        name = self.bytes[self.at : self.at + length].decode()
        self.at += length
        size, _ = self.numbers('hi')
        self.at += 4 * size
        return name, size


def frames(paths):
    if paths[0].endswith('.vtkhdf'):
        return vtkhdf(paths[0])
    return [(geo.points, geo.uv) for geo in map(Bgeo, paths)]


read = frames(sys.argv[1:])
assert len(read) == 3
for k, (x, uv) in enumerate(read):
    exact = np.stack([(x[:, 0] - 0.05 * k) / 0.2 + 0.5, x[:, 2] / 0.2 + 0.5], axis=1)
    away = np.hypot(*(uv - exact).T)
    # in the texture, an edge of the mesh is about 0.05 long
    assert np.median(away) < 0.02 and away.max() < 0.1, (k, np.median(away), away.max())
