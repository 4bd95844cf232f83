# SPDX-License-Identifier: Apache-2.0
"""The frames of a run as a sequence."""
from __future__ import annotations

from typing import NamedTuple, Sequence, Tuple, Union, overload

import numpy as np

from .errors import MissingError
from .frame import Frame


class Entry(NamedTuple):
    number: int
    time: float  #: s


class Frames(Sequence[Frame]):
    """Frames, ascending by time. No file is opened until a frame's fields are read."""

    def __init__(self, folder: str, name: str, entries: Tuple[Entry, ...]) -> None:
        self._folder, self._name, self._entries = folder, name, entries

    @property
    def times(self) -> np.ndarray:
        """Times of the frames: float64 (n,), s."""
        return np.array([e.time for e in self._entries], dtype=np.float64)

    def __len__(self) -> int:
        return len(self._entries)

    @overload
    def __getitem__(self, which: int) -> Frame:
        ...

    @overload
    def __getitem__(self, which: slice) -> 'Frames':
        ...

    def __getitem__(self, which: Union[int, slice]) -> Union[Frame, 'Frames']:
        """One frame, or the frames of a slice. Raises IndexError beyond the end."""
        if isinstance(which, slice):
            return Frames(self._folder, self._name, self._entries[which])
        try:
            entry = self._entries[which]
        except IndexError:
            raise IndexError(f'{self._folder} has {len(self)} frames, so no frame [{which}]') from None
        return Frame(self._folder, self._name, entry.number, entry.time)

    def at(self, time: float) -> Frame:
        """The frame nearest to a time in s. Of two equally near frames, the earlier one.

        Raises MissingError if there are no frames.
        """
        if not self._entries:
            raise MissingError(f'{self._folder} has no frames')
        return self[int(np.argmin(np.abs(self.times - time)))]

    def __repr__(self) -> str:
        if not self._entries:
            return f'<no frames in {self._folder}>'
        return f'<{len(self)} frames, {self._entries[0].time:.6g} to {self._entries[-1].time:.6g} s>'
