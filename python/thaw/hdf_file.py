# SPDX-License-Identifier: Apache-2.0
"""HDF5 files of thaw, opened only while they are read, and checked before HDF5 parses them."""
from __future__ import annotations

import contextlib
import os
import struct
from typing import TYPE_CHECKING, Iterator, Optional, Tuple

import numpy as np

from .errors import FileError, ThawError

if TYPE_CHECKING:
    import h5py

MASK = (1 << 64) - 1
START = 0x9E3779B97F4A7C15
MAGIC = 0x316B6377616874  # "thawck1"
FIXED_WORDS = 5
PIECE = 1 << 20


def mix(x: int) -> int:
    """Finalizer of splitmix64, as in io/hdf5/parallel_file.cpp."""
    x = ((x ^ x >> 30) * 0xBF58476D1CE4E5B9) & MASK
    x = ((x ^ x >> 27) * 0x94D049BB133111EB) & MASK
    return x ^ x >> 31


def mixAll(x: np.ndarray) -> np.ndarray:
    x = (x ^ x >> np.uint64(30)) * np.uint64(0xBF58476D1CE4E5B9)
    x = (x ^ x >> np.uint64(27)) * np.uint64(0x94D049BB133111EB)
    return x ^ x >> np.uint64(31)


def checksumOfBytes(data: bytes, at: int) -> int:
    """Checksum of a piece of a file that begins at byte `at`."""
    whole = len(data) // 8
    h = mix((at + START) & MASK)
    for word in struct.unpack_from(f'<{whole}Q', data):
        h = mix(h ^ word)
    if len(data) % 8:
        h = mix(h ^ int.from_bytes(data[8 * whole :], 'little'))
    return h


def checksumOfRows(rows: np.ndarray) -> int:
    """Sum of the checksums of all rows of an array, which a checkpoint stores with each dataset."""
    rows = np.ascontiguousarray(rows)
    count = len(rows)
    width = rows.itemsize * (rows.size // count if count else 0)
    sum_ = 0
    for first in range(0, count, PIECE):
        part = rows[first : first + PIECE]
        words = np.zeros((len(part), -(-width // 8)), dtype='<u8')
        words.view(np.uint8)[:, :width] = part.reshape(len(part), -1).view(np.uint8)
        h = mixAll(np.arange(first, first + len(part), dtype=np.uint64) + np.uint64(START))
        for k in range(words.shape[1]):
            h = mixAll(h ^ words[:, k])
        sum_ += int(np.sum(h, dtype=np.uint64))
    return sum_ & MASK


class Trailer:
    """Checksum at the end of a file, over everything that HDF5 parses (io/hdf5/file_trailer.hpp)."""

    def __init__(self, path: str, fd: int) -> None:
        self.path, self.fd, self.size = path, fd, os.fstat(fd).st_size

    def read(self, at: int, count: int) -> bytes:
        data = os.pread(self.fd, count, at)
        while len(data) < count:
            more = os.pread(self.fd, count - len(data), at + len(data))
            if not more:
                raise FileError(self.path, 'is damaged: it is shorter than expected')
            data += more
        return data

    def words(self, at: int, count: int) -> Tuple[int, ...]:
        return struct.unpack(f'<{count}Q', self.read(at, 8 * count))

    def check(self) -> bool:
        """Returns whether the file has a trailer. Raises FileError where file and trailer differ."""
        before = self.size - 8 * FIXED_WORDS
        fixed = self.words(before, FIXED_WORDS) if before >= 0 else (0,) * FIXED_WORDS
        if fixed[-1] != MAGIC:
            return False
        ranges, end, checksum = fixed[:3]
        if ranges > before // 16 or end != before - 16 * ranges:
            raise FileError(self.path, 'is damaged: its trailer does not match its length')
        rows = self.words(end, 2 * ranges)
        if checksumOfRows(np.array(rows + fixed[:3], dtype='<u8')) != fixed[3]:
            raise FileError(self.path, 'is damaged: the checksum of its trailer is wrong')
        if self.checksumBetween(rows, end) != checksum:
            raise FileError(self.path, 'is damaged: its checksum is wrong')
        return True

    def checksumBetween(self, rows: Tuple[int, ...], end: int) -> int:
        """Checksum of the bytes before `end` that are not rows of a dataset."""
        sum_ = at = 0
        for first, count in list(zip(rows[::2], rows[1::2])) + [(end, 0)]:
            if first < at or first + count > end:
                raise FileError(self.path, 'is damaged: the ranges of its trailer are wrong')
            while at < first:
                n = min(PIECE, first - at)
                sum_ += checksumOfBytes(self.read(at, n), at)
                at += n
            at = first + count
        return sum_ & MASK


class HdfFile:
    """A file that must not change between two reads of the same object."""

    def __init__(self, path: str) -> None:
        self.path = path
        self.seen: Optional[Tuple[int, int, int]] = None

    @contextlib.contextmanager
    def open(self) -> Iterator[h5py.File]:
        """Opens the file for the duration of a `with`. Any failure becomes a FileError."""
        try:
            import h5py  # simulations do not need it
        except ImportError:
            raise ImportError(
                "results are read with h5py (Debian: python3-h5py), which is not installed"
            ) from None
        self.check()
        try:
            with h5py.File(self.path, 'r') as file:
                yield file
        except (ThawError, MemoryError):
            raise
        except Exception as error:  # h5py raises many types for damaged files
            raise FileError(self.path, f'is damaged, or not a file of thaw: {error}') from error

    def check(self) -> None:
        try:
            fd = os.open(self.path, os.O_RDONLY)
        except FileNotFoundError:
            raise FileError(self.path, 'no such file; run.refresh() finds those there are') from None
        except OSError as error:
            raise FileError(self.path, f'cannot be read: {error.strerror}') from error
        try:
            about = os.fstat(fd)
            now = (about.st_ino, about.st_size, about.st_mtime_ns)
            if self.seen is None:
                if not Trailer(self.path, fd).check() and os.pread(fd, 8, 0) != b'\x89HDF\r\n\x1a\n':
                    raise FileError(self.path, 'is damaged, half written, or not a file of thaw')
                self.seen = now
            elif now != self.seen:
                raise FileError(
                    self.path, 'was replaced by the run since it was first read: call run.refresh()'
                )
        except OSError as error:
            raise FileError(self.path, f'cannot be read: {error.strerror}') from error
        finally:
            os.close(fd)


def textOf(value: object) -> str:
    """Text of an attribute or a dataset of fixed length."""
    return value.decode('utf-8', 'replace') if isinstance(value, bytes) else str(value)
