# SPDX-License-Identifier: Apache-2.0
"""thaw: particle simulations of solids and fluids that deform, melt, flow, freeze and break."""

from .scene import Scene
from .simulation import Rows, Simulation, register_extension

__all__ = ["BlewUp", "FileError", "Rows", "Scene", "SceneError", "Simulation", "register_extension"]


def __getattr__(name: str):
    if name in ("BlewUp", "FileError", "SceneError"):
        from ._load import core

        return getattr(core(), name)
    raise AttributeError(f"module 'thaw' has no attribute '{name}'")
