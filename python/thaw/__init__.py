# SPDX-License-Identifier: Apache-2.0
"""thaw: particle simulations of solids and liquids that deform, melt, flow, freeze and break.

Runs are read with numpy and h5py alone; simulations need numpy and the compiled part of the package.

    import thaw

    run = thaw.open('out/melt')
    frame = run.frames[-1]
    print(frame.time, frame['temperature'].max(), frame.fields['temperature'].unit)

    sim = thaw.Simulation('melt.toml', 'out/melt')
    sim.run(progress=True)
"""
from __future__ import annotations

from typing import Any

from .build import (
    Body,
    Domain,
    Emitter,
    HeatedRegion,
    Lamp,
    Laser,
    Material,
    Numerics,
    Obstacle,
    OrientedBody,
    Output,
    SheetBody,
    SurfaceSettings,
    Thermostat,
)
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
from .extension import register_extension
from .frame import Frame, Oriented, Sheets, Surface
from .frames import Frames
from .log import Log
from .mesh import Mesh
from .obstacles import DrivenObstacle, Obstacles
from .points import Field, Points
from .run import Run
from .run import openRun as open  # noqa: A001
from .picture import Picture
from .scene import Scene, SceneReport
from .scene_text import RunDomain
from .rows import Rows
from .simulation import Simulation
from .summary import Summary
from .version import readVersion

__version__ = readVersion()

__all__ = [
    'BlewUp',
    'Body',
    'Checkpoint',
    'Comparison',
    'DamageWarning',
    'Domain',
    'DrivenObstacle',
    'Emitter',
    'Field',
    'FieldDifference',
    'FieldError',
    'FileError',
    'Frame',
    'Frames',
    'HeatedRegion',
    'Lamp',
    'Laser',
    'Log',
    'Material',
    'Mesh',
    'MissingError',
    'Numerics',
    'Obstacle',
    'Obstacles',
    'Oriented',
    'OrientedBody',
    'Output',
    'Picture',
    'Points',
    'ProgramError',
    'Rows',
    'Run',
    'RunDomain',
    'Scene',
    'SceneError',
    'SceneReport',
    'SheetBody',
    'Sheets',
    'Simulation',
    'Summary',
    'Surface',
    'SurfaceSettings',
    'ThawError',
    'Thermostat',
    'open',
    'register_extension',
]
