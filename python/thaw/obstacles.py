# SPDX-License-Identifier: Apache-2.0
"""Obstacles that a program moves, for coupling with bodies outside of thaw."""

from __future__ import annotations

from typing import Any, Dict, Iterator, Mapping, Optional, Sequence

import numpy as np

from ._load import core

__all__ = ["DrivenObstacle", "Obstacles"]

ZERO = (0.0, 0.0, 0.0)


class DrivenObstacle:
    """An obstacle of the scene that the program moves: `ball = sim.obstacles["ball"]`.

    All ranks make the same calls. The pose maps the shape of the scene, with its `place`:
    x = position + R(rotation) x_scene, with R = Rz Ry Rx. A shape without `place` has its origin at
    `position`. Frames, pictures and exports show the motion of the scene, not this one.
    """

    def __init__(self, simulation: Any, name: str):
        self.name = name  #: name in the scene
        try:
            self._core: Any = core().Obstacle(simulation, name)
        except ValueError as error:
            raise (KeyError if "unknown obstacle" in str(error) else ValueError)(str(error)) from None

    def _open(self) -> Any:
        if self._core is None:
            raise RuntimeError(f"obstacle '{self.name}': its simulation has been closed")
        return self._core

    def move(
        self,
        position: Optional[Sequence[float]] = None,
        velocity: Sequence[float] = ZERO,
        rotation: Optional[Sequence[float]] = None,
        rotation_rate: Sequence[float] = ZERO,
    ) -> None:
        """Sets the motion from now on: a pose and constant rates, until the next call.

        position: m, shape (3,); default: the current one.
        velocity: m/s, shape (3,).
        rotation: angles about x, then y, then z, rad; default: the current ones.
        rotation_rate: rate of these angles, rad/s.

        After a restart, call it before the first step: checkpoints do not contain it.
        Raises ValueError for values that are not finite.
        """
        self._open().move(
            list(self.position if position is None else position),
            list(velocity),
            list(self.rotation if rotation is None else rotation),
            list(rotation_rate),
        )

    @property
    def position(self) -> np.ndarray:
        """Displacement of the origin of the shape, m, shape (3,)."""
        return np.array(self._open().position)

    @property
    def velocity(self) -> np.ndarray:
        """Velocity of the origin of the shape, m/s, shape (3,)."""
        return np.array(self._open().velocity)

    @property
    def rotation(self) -> np.ndarray:
        """Angles about x, then y, then z, rad, shape (3,)."""
        return np.array(self._open().rotation)

    @property
    def force(self) -> np.ndarray:
        """Force of all particles of all ranks on the obstacle at the end of the last step, N, shape (3,).

        Zero before the first step after sim.obstacles[name]. Collective: all ranks must read it.
        """
        return np.array(self._open().load()[0])

    @property
    def torque(self) -> np.ndarray:
        """Torque about `position` at the end of the last step, N m, shape (3,). Collective."""
        return np.array(self._open().load()[1])

    def __repr__(self) -> str:
        if self._core is None:
            return f"<DrivenObstacle {self.name} of a closed simulation>"
        return f"<DrivenObstacle {self.name} at {self.position.tolist()} m>"


class Obstacles(Mapping):
    """Obstacles of a simulation by name. The first access to an obstacle starts the measurement of its load.

    Raises KeyError for an unknown name. Raises ValueError for static obstacles (give them
    `motion = [{ time = 0 }]`) and for obstacles shorter than a periodic domain. Raises it also in scenes with
    the incompressible solver, implicit viscosity, contact angles, rigid solids, sheets, oriented or sleeping
    particles.
    """

    def __init__(self, simulation: Any, names: Sequence[str]):
        self._simulation: Any = simulation
        self._names = list(names)
        self._known: Dict[str, DrivenObstacle] = {}

    def __getitem__(self, name: str) -> DrivenObstacle:
        if name not in self._known:
            self._known[name] = DrivenObstacle(self._simulation, name)
        return self._known[name]

    def _release(self) -> None:
        """Drops all references to the simulation, which has been closed."""
        self._simulation = None
        for obstacle in self._known.values():
            obstacle._core = None

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)
