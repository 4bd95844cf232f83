# SPDX-License-Identifier: Apache-2.0
"""Reads the frames of thaw without h5py: HDF5 files of version 0 with contiguous datasets.

The layout is that of the HDF5 File Format Specification, version 2.0.
"""
import math
import struct

import numpy as np

SIGNATURE = b'\x89HDF\r\n\x1a\n'
UNDEFINED = 0xFFFFFFFFFFFFFFFF


class FormatError(Exception):
    """The file is damaged, or is not a frame of thaw."""


class Frame:
    """A frame: `names(group)` and `read(path)`, such as read('VTKHDF/Points')."""

    def __init__(self, path):
        self.path = str(path)
        with open(path, 'rb') as file:
            self.data = file.read()
        if self.data[:8] != SIGNATURE or len(self.data) < 96:
            raise FormatError(f'{path}: is not an HDF5 file')
        if self.data[8] != 0 or self.data[13] != 8 or self.data[14] != 8:
            raise FormatError(f'{path}: has an unsupported HDF5 version')
        # The root's symbol table entry ends the superblock: name offset, header address.
        self.root = struct.unpack_from('<Q', self.data, 56 + 8)[0]

    def names(self, group):
        return sorted(self._guarded(group, lambda: self._links(self._find(group))))

    def __contains__(self, path):
        try:
            self._guarded(path, lambda: self._find(path))
            return True
        except KeyError:
            return False

    def read(self, path):
        """Returns an array or a text. Raises KeyError if there is none of this name."""
        return self._guarded(path, lambda: self._dataset(self._find(path)))

    def _guarded(self, path, action):
        """Converts errors of damaged addresses and sizes to FormatError."""
        try:
            return action()
        except (struct.error, IndexError, ValueError, TypeError, OverflowError, RecursionError) as error:
            raise FormatError(f'{self.path}: {path} is damaged: {error}') from error

    def _find(self, path):
        at = self.root
        for part in path.strip('/').split('/'):
            links = self._links(at)
            if part not in links:
                raise KeyError(f'{self.path}: there is no {path}')
            at = links[part]
        return at

    def _messages(self, address):
        """Yields (type, position, size) of the messages of an object header of version 1."""
        if self.data[address] != 1:
            raise FormatError(f'{self.path}: has an object header of an unsupported version')
        count, size = struct.unpack_from('<H4xI', self.data, address + 2)
        blocks = [(address + 16, size)]
        while blocks and count > 0:
            at, left = blocks.pop(0)
            while left >= 8 and count > 0:
                kind, length = struct.unpack_from('<HH', self.data, at)
                if kind == 0x10:  # the header continues elsewhere
                    blocks.append(struct.unpack_from('<QQ', self.data, at + 8))
                else:
                    yield kind, at + 8, length
                at, left, count = at + 8 + length, left - 8 - length, count - 1

    def _links(self, address):
        for kind, at, _ in self._messages(address):
            if kind == 0x11:  # symbol table
                tree, heap = struct.unpack_from('<QQ', self.data, at)
                names = struct.unpack_from('<Q', self.data, heap + 24)[0]
                return dict(self._entries(tree, names))
        return {}

    def _entries(self, node, names):
        """Yields (name, address) below a node of a B-tree of version 1."""
        if self.data[node : node + 4] == b'SNOD':
            for k in range(struct.unpack_from('<H', self.data, node + 6)[0]):
                name, header = struct.unpack_from('<QQ', self.data, node + 8 + 40 * k)
                begin = names + name
                yield self.data[begin : self.data.index(b'\0', begin)].decode(), header
        elif self.data[node : node + 4] == b'TREE':
            used = struct.unpack_from('<H', self.data, node + 6)[0]
            for k in range(used):
                yield from self._entries(struct.unpack_from('<Q', self.data, node + 32 + 16 * k)[0], names)
        else:
            raise FormatError(f'{self.path}: has a damaged group')

    def _dataset(self, address):
        shape, dtype, place = (), None, None
        for kind, at, _ in self._messages(address):
            if kind == 0x01:
                shape = self._shape(at)
            elif kind == 0x03:
                dtype = self._type(at)
            elif kind == 0x08:
                if self.data[at] != 3 or self.data[at + 1] != 1:
                    raise FormatError(f'{self.path}: has a dataset that is not contiguous')
                place = struct.unpack_from('<Q', self.data, at + 2)[0]
        if dtype is None or place is None:
            raise FormatError(f'{self.path}: has an object that is not a dataset')
        count = math.prod(shape)
        if count == 0 or place == UNDEFINED:
            return np.zeros(shape, dtype)
        if place + count * dtype.itemsize > len(self.data):
            raise FormatError(f'{self.path}: is truncated')
        array = np.frombuffer(self.data, dtype, count, place).reshape(shape)
        return array.tobytes().rstrip(b'\0').decode('utf-8', 'replace') if dtype.kind == 'S' else array

    def _shape(self, at):
        version, rank = self.data[at], self.data[at + 1]
        return struct.unpack_from(f'<{rank}Q', self.data, at + (8 if version == 1 else 4))

    def _type(self, at):
        kind, flags, size = (
            self.data[at] & 15,
            self.data[at + 1],
            struct.unpack_from('<I', self.data, at + 4)[0],
        )
        order = '>' if flags & 1 else '<'
        if kind == 0:
            return np.dtype(f'{order}{"i" if flags & 8 else "u"}{size}')
        if kind == 1:
            return np.dtype(f'{order}f{size}')
        if kind == 3:
            return np.dtype(f'S{size}')
        raise FormatError(f'{self.path}: has values of an unknown type')
