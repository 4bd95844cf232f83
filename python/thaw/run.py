# SPDX-License-Identifier: Apache-2.0
"""A run's folder."""
from __future__ import annotations

import os
import warnings
from typing import Dict, List, Optional, Sequence, Tuple, Union

from .checkpoint import Checkpoint, newestCheckpoint
from .compare import Comparison, compareFrames, compareSnapshots
from .errors import DamageWarning, FileError, MissingError
from .frame import Frame
from .frames import Frames
from .log import Log
from .scene_text import RunDomain, domainOf, namesOf, sceneOf, spacingOf
from .series import findFrames
from .snapshot import snapshotOfCheckpoint
from .summary import Summary, isLive, readSummary


# files that a run's folder has before its first frame
SIGNS = ('lock', 'summary.json', 'checkpoint/a.hdf', 'checkpoint/b.hdf')


class Run:
    """The results of a run, finished or still running.

    No file is kept open. Values that were read do not change until `refresh`, so frames and logs of a run in
    progress are consistent.
    """

    def __init__(self, path: str, scene: Optional[str] = None) -> None:
        self.path = path
        self._asked_scene = scene
        self._logs: Dict[str, Log] = {}
        self.refresh()

    def refresh(self) -> 'Run':
        """Looks for new frames, checkpoints and rows of a running run. Returns the run itself."""
        if not os.path.isdir(self.path):
            raise FileError(self.path, noFolder(self.path))
        found = findFrames(self._file('frames'), self._asked_scene)
        if not found.name and not any(os.path.exists(self._file(f)) for f in SIGNS):
            raise FileError(self.path, 'is not a run folder: expected frames/, checkpoint/ or summary.json')
        self._logs = {}
        self._summary: Optional[Summary] = None
        self._newest: Optional[Checkpoint] = None
        self._name = found.name
        #: Frames, ascending by time, without incomplete ones at the end.
        self.frames = Frames(self._file('frames'), found.name, found.entries)
        self.problems: Tuple[str, ...] = ()  #: damaged or incomplete files that were left out
        self._leaveOut(found.problems)
        return self

    def _file(self, name: str) -> str:
        return os.path.join(self.path, name)

    def _leaveOut(self, problems: Sequence[str]) -> None:
        self.problems += tuple(problems)
        for problem in problems:
            if 'not written yet' not in problem:
                warnings.warn(f'left out: {problem}', DamageWarning, stacklevel=3)

    @property
    def name(self) -> str:
        """Name of the scene: its file name without .toml. Empty before the first frame or checkpoint."""
        if not self._name and self._checkpoint() is not None:
            self._name = self.checkpoint.scene_name
        return self._name

    @property
    def running(self) -> Optional[bool]:
        """Whether a process still writes this run; None if it is on another host."""
        return isLive(self._file('lock'))

    def _checkpoint(self) -> Optional[Checkpoint]:
        if self._newest is None:
            self._newest, problems = newestCheckpoint(self.path)
            self._leaveOut([line for line in problems if line not in self.problems])
        return self._newest

    @property
    def checkpoint(self) -> Checkpoint:
        """The newest checkpoint. Raises MissingError if there is none."""
        newest = self._checkpoint()
        if newest is None:
            raise MissingError(f'{self.path}: there is no checkpoint that can be read')
        return newest

    @property
    def scene(self) -> str:
        """The scene as TOML, with includes and settings resolved. Raises MissingError if none is stored."""
        if self.frames:
            frame = self.frames[-1]
            return frame._head().scene
        return self.checkpoint.scene

    @property
    def bodies(self) -> List[str]:
        """Names of the bodies and emitters, in the order of their numbers in frames."""
        return namesOf(sceneOf(self.scene, self.path), 'particles')

    @property
    def domain(self) -> RunDomain:
        """The simulated box: `RunDomain(min, max, periodic)`, m."""
        return domainOf(sceneOf(self.scene, self.path), self.path)

    @property
    def spacing(self) -> float:
        """Distance of particles at rest, m."""
        return spacingOf(sceneOf(self.scene, self.path), self.path)

    @property
    def summary(self) -> Summary:
        """summary.json: a dict whose keys are also attributes. Raises FileError if it is missing."""
        if self._summary is None:
            self._summary = readSummary(self._file('summary.json'))
        return self._summary

    def _log(self, name: str) -> Log:
        if name not in self._logs:
            self._logs[name] = Log(self._file(name))
        return self._logs[name]

    @property
    def ledger(self) -> Log:
        """Mass, momentum, energy and heat over simulated time: columns of ledger.csv."""
        return self._log('ledger.csv')

    @property
    def progress(self) -> Log:
        """Progress lines: columns of progress.csv. They depend on wall-clock time."""
        return self._log('progress.csv')

    @property
    def components(self) -> Log:
        """Components of the surface, a row for each of them and each frame: columns of surface.csv."""
        return self._log('surface.csv')

    @property
    def events(self) -> Log:
        """Splits and merges of components: columns of events.csv."""
        return self._log('events.csv')

    def compare(
        self, other: Union['Run', str], tolerance: Optional[float] = None, frames: bool = False
    ) -> Comparison:
        """Compares the newest checkpoints of two runs by id, as `thaw compare` does.

        other: a run, or the path of its folder.
        tolerance: None compares bits. Otherwise floating-point values may differ by this times the largest
        magnitude of their field; whole numbers must be equal.
        frames: compares all frames too. Frames that only one run has are differences.
        Raises MissingError if a run has no checkpoint, FileError if a file is damaged.
        """
        if not isinstance(other, Run):
            other = openRun(os.fspath(other))
        result = compareSnapshots(
            snapshotOfCheckpoint(self.checkpoint), snapshotOfCheckpoint(other.checkpoint), tolerance
        )
        if frames:
            self._compareFrames(other, tolerance, result)
        return result

    def _compareFrames(self, other: 'Run', tolerance: Optional[float], result: Comparison) -> None:
        own = {os.path.basename(f.path): f for f in self.frames}
        theirs = {os.path.basename(f.path): f for f in other.frames}
        for key in sorted({**own, **theirs}):
            if key in own and key in theirs:
                result.frames.append(compareFrames(own[key], theirs[key], tolerance))
            else:
                frame: Frame = own.get(key) or theirs[key]
                result.general.append(f'{frame.path}: is in {"A" if key in own else "B"} only')

    def __repr__(self) -> str:
        return f'<Run {self.path}: {self.frames!r}>'


def noFolder(path: str) -> str:
    """Returns the reason why a path is not a run."""
    if not os.path.exists(path):
        return 'no such folder; expected the folder of a run, such as out/NAME'
    folder = os.path.dirname(os.path.dirname(path)) or 'out/NAME'
    return f'is a file; expected the folder of a run, such as {folder}'


def openRun(path: 'str | os.PathLike[str]', scene: Optional[str] = None) -> Run:
    """Opens the folder of a run, such as out/melt: finished, still running, or with only a checkpoint.

    scene: name of the scene, for a folder with frames of several scenes.
    Raises FileError if the folder is missing or has no results of thaw.
    """
    return Run(os.fspath(path), scene)
