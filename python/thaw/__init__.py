# SPDX-License-Identifier: Apache-2.0
"""Reads runs of thaw: frames, logs, summaries and checkpoints as numpy arrays.

    import thaw

    run = thaw.open('out/melt')
    frame = run.frames[-1]
    print(frame.time, frame['temperature'].max(), frame.fields['temperature'].unit)
"""
from __future__ import annotations

from typing import Any

from .checkpoint import Checkpoint
from .compare import Comparison, FieldDifference
from .errors import DamageWarning, FieldError, FileError, MissingError, ProgramError, ThawError
from .frame import Frame, Oriented, Sheets, Surface
from .frames import Frames
from .log import Log
from .mesh import Mesh
from .points import Field, Points
from .run import Run
from .run import openRun as open  # noqa: A001
from .scene_text import Domain
from .summary import Summary
from .version import readVersion

__version__ = readVersion()

COMPILED = ('Scene', 'Simulation')  # the module thaw._core has these; reading does not need it

__all__ = [
    'Checkpoint',
    'Comparison',
    'DamageWarning',
    'Domain',
    'Field',
    'FieldDifference',
    'FieldError',
    'FileError',
    'Frame',
    'Frames',
    'Log',
    'Mesh',
    'MissingError',
    'Oriented',
    'Points',
    'ProgramError',
    'Run',
    'Sheets',
    'Summary',
    'Surface',
    'ThawError',
    'open',
]


def __getattr__(name: str) -> Any:
    if name not in COMPILED:
        raise AttributeError(f"module 'thaw' has no attribute '{name}'")
    try:
        from . import _core
    except ImportError as error:
        raise ImportError(
            f'thaw.{name} needs the compiled module thaw._core, which this installation does not have '
            f'({error}); reading of runs works without it'
        ) from error
    return getattr(_core, name)
