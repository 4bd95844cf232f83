# SPDX-License-Identifier: Apache-2.0
"""thaw: particle simulations of solids and liquids that deform, melt, flow, freeze and break.

Runs are read with numpy and h5py alone; simulations need the compiled part of the package.

    import thaw

    run = thaw.open('out/melt')
    frame = run.frames[-1]
    print(frame.time, frame['temperature'].max(), frame.fields['temperature'].unit)

    sim = thaw.Simulation('melt.toml', 'out/melt')
    sim.run(progress=True)
"""
from __future__ import annotations

from typing import Any

from .checkpoint import Checkpoint
from .compare import Comparison, FieldDifference
from .errors import (
    BlewUp,
    DamageWarning,
    FieldError,
    FileError,
    MissingError,
    ProgramError,
    SceneError,
    ThawError,
)
from .frame import Frame, Oriented, Sheets, Surface
from .frames import Frames
from .log import Log
from .mesh import Mesh
from .obstacles import Obstacle, Obstacles
from .points import Field, Points
from .run import Run
from .run import openRun as open  # noqa: A001
from .picture import Picture
from .scene import Scene, SceneReport
from .scene_text import Domain
from .simulation import Rows, Simulation, register_extension
from .summary import Summary
from .version import readVersion

__version__ = readVersion()

__all__ = [
    'BlewUp',
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
    'Obstacle',
    'Obstacles',
    'Oriented',
    'Points',
    'Picture',
    'ProgramError',
    'Rows',
    'Run',
    'Scene',
    'SceneError',
    'SceneReport',
    'Sheets',
    'Simulation',
    'Summary',
    'Surface',
    'ThawError',
    'open',
    'register_extension',
]
