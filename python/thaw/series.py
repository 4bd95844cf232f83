# SPDX-License-Identifier: Apache-2.0
"""The list of frames of a run, from the indices NAME.hdf.series, else from the names of the files."""
from __future__ import annotations

import json
import os
import re
from typing import Dict, List, NamedTuple, Optional, Set, Tuple

from .errors import FileError
from .frame import SUFFIXES, frameFile
from .frames import Entry
from .hdf_file import HdfFile
from .points import readHead

FRAME = re.compile(r'(.+)_(\d{6,})\.hdf')
INDEX = '.hdf.series'


class Found(NamedTuple):
    name: str  #: of the scene
    entries: Tuple[Entry, ...]
    problems: Tuple[str, ...]  #: damaged or incomplete files that were left out


def readIndex(path: str) -> Dict[int, float]:
    """Number and time of each frame of an index. Raises ValueError if it is missing or damaged."""
    try:
        with open(path, encoding='utf-8') as file:
            files = json.load(file)['files']
        found = [(FRAME.fullmatch(f['name']), float(f['time'])) for f in files]
    except (OSError, KeyError, TypeError) as error:
        raise ValueError(str(error)) from error
    return {int(match[2]): time for match, time in found if match}


def stemsIn(names: List[str]) -> Dict[str, Set[int]]:
    """Names of frame files without their numbers, each with the numbers of its files."""
    stems: Dict[str, Set[int]] = {}
    for name in names:
        match = FRAME.fullmatch(name)
        if match:
            stems.setdefault(match[1], set()).add(int(match[2]))
    return stems


def sceneNameOf(folder: str, stem: str, numbers: Set[int]) -> str:
    """Name of the scene: from a readable file, else the file name without the suffix of its kind."""
    for number in sorted(numbers, reverse=True):
        try:
            return readHead(HdfFile(os.path.join(folder, f'{stem}_{number:06}.hdf')), '').scene_name
        except FileError:
            continue
    return re.sub('_(surface|sheet|oriented)$', '', stem)


def timesOf(folder: str, stem: str, numbers: Set[int], problems: List[str]) -> Dict[int, float]:
    """Numbers and times of the frames of a stem that are on disk."""
    try:
        listed = readIndex(os.path.join(folder, stem + INDEX))
        return {n: t for n, t in listed.items() if n in numbers}
    except ValueError:
        times = {}
        for number in numbers:
            try:
                times[number] = readHead(HdfFile(os.path.join(folder, f'{stem}_{number:06}.hdf')), '').time
            except FileError as error:
                problems.append(str(error))
        return times


def isComplete(folder: str, name: str, kinds: List[str], number: int) -> str:
    """Returns an empty text for a frame with all of its files, else the error."""
    for kind in kinds:
        path = frameFile(folder, name, kind, number)
        try:
            readHead(HdfFile(path), kind)
        except FileError as error:
            return str(error) if os.path.exists(path) else f'{path}: not written yet'
    return ''


def findFrames(folder: str, scene: Optional[str] = None) -> Found:
    """Frames of a folder frames/, without incomplete ones at the end.

    scene: name of the scene. Without it, frames of several scenes raise FileError.
    """
    try:
        stems = stemsIn(os.listdir(folder))
    except FileNotFoundError:
        return Found('', (), ())
    except OSError as error:
        raise FileError(folder, f'cannot be read: {error.strerror}') from error
    scenes = {stem: sceneNameOf(folder, stem, numbers) for stem, numbers in stems.items()}
    names = sorted(set(scenes.values()))
    if scene is not None and scene not in names:
        raise FileError(folder, f'has no frames of scene {scene!r}; it has: {", ".join(names) or "none"}')
    if scene is None and len(names) > 1:
        raise FileError(
            folder,
            f'has frames of several scenes: {", ".join(names)}; choose one: thaw.open(path, scene=...)',
        )
    if not names:
        return Found('', (), ())
    name = scene or names[0]
    kinds = [kind for kind, suffix in SUFFIXES.items() if name + suffix in stems]
    problems: List[str] = []
    times: Dict[int, float] = {}
    for kind in kinds:
        stem = name + SUFFIXES[kind]
        times.update(timesOf(folder, stem, stems[stem], problems))
    entries = sorted((Entry(n, t) for n, t in times.items()), key=lambda e: (e.time, e.number))
    while entries:
        problem = isComplete(folder, name, kinds, entries[-1].number)
        if not problem:
            break
        problems.append(problem)
        entries.pop()
    return Found(name, tuple(entries), tuple(problems))
