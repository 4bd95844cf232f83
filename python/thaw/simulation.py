# SPDX-License-Identifier: Apache-2.0
"""Simulations: made from a scene, stepped, read and changed from Python, on any number of ranks."""

from __future__ import annotations

import contextlib
import sys
import weakref
from typing import Any, Callable, Iterator, Mapping, Optional, Sequence, Union

import numpy as np

from ._load import core
from .obstacles import Obstacles
from .picture import Picture, draw
from .scene import Scene

__all__ = ["Rows", "Simulation", "register_extension"]


class Rows:
    """The rows of one table on this rank, inside of a block `with sim.local() as p`.

    Fields are arrays over the simulation's own memory, without a copy: `p["temperature"]` or `p.temperature`.
    Outside of the block, access raises RuntimeError. Values of `velocity` and `temperature` of particles may
    be changed in place (`p.velocity += dv`); all other arrays are read-only.
    """

    def __init__(self, source: Any, table: str, changes: bool):
        self.__dict__.update(_source=source, _table=table, _changes=changes, _open=True)

    def __getitem__(self, field: str) -> np.ndarray:
        if not self._open:
            raise RuntimeError(
                f"'{field}': the block `with sim.local()` has ended; use sim.gather() outside of it"
            )
        try:
            return self._source.view(self._table, field, self._changes and field in self._WRITABLE)
        except KeyError:
            raise KeyError(
                f"unknown field '{field}'; the {self._table} have {', '.join(self.fields())}"
            ) from None

    _WRITABLE = ("velocity", "temperature")

    def __getattr__(self, field: str) -> np.ndarray:
        try:
            return self[field]
        except KeyError as error:
            raise AttributeError(error.args[0]) from None

    def __setitem__(self, field: str, values: Any) -> None:
        array = self[field]
        if values is not array:  # `p.velocity += dv` assigns the array to itself
            array[...] = values

    __setattr__ = __setitem__

    def __len__(self) -> int:
        return self._source.rows(self._table)

    def __contains__(self, field: str) -> bool:
        return field in self.fields()

    def fields(self) -> list[str]:
        """Names of the fields of this table."""
        return [name for name, _, _, _ in self._source.fields(self._table)]

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self.fields()})

    def _ipython_key_completions_(self) -> list[str]:
        return self.fields()


class Simulation:
    """A simulation of a scene.

    scene: a path, a thaw.Scene, or a dict of its keys.
    out: folder for frames, checkpoints and the summary; None: nothing is written.
    comm: an mpi4py communicator; None: all ranks. All ranks of it call all methods in the same order.
    restart: continue from the checkpoint in `out`, which has to be there; resume: continue if there is one.
    set: overrides of keys, such as {"numerics.cfl_sound": 0.2}.
    log: called with each line of progress and each warning, on the first rank.

    Raises thaw.SceneError (with file, line and what was expected), thaw.FileError, thaw.BlewUp.
    """

    def __init__(
        self,
        scene: Union[str, Scene, Mapping[str, Any]],
        out: Optional[str] = None,
        *,
        comm: Any = None,
        restart: bool = False,
        resume: bool = False,
        force: bool = False,
        set: Optional[Mapping[str, Any]] = None,
        log: Optional[Callable[[str], Any]] = None,
        time_limit: Optional[float] = None,
    ):
        scene = Scene.of(scene)
        options = {"scene": scene.name, "out": "" if out is None else str(out)}
        for key, on in (("restart", restart), ("resume", resume), ("force", force)):
            if on:
                options[key] = "1"
        if time_limit is not None:
            options["time_limit"] = repr(float(time_limit))
        for key, value in {**scene.overrides, **(set or {})}.items():
            options["set " + key] = Scene.toml_value(value)
        self._core = core().Simulation(scene.text, options, log, None if comm is None else comm.py2f())
        self.scene = scene
        # The compiled part has only weak references, so that a simulation ends with its last reference.
        self._on_step: list[Callable[[Simulation], Any]] = []
        self._on_frame: list[Callable[[Simulation], Any]] = []
        self._loads: list[Load] = []
        self._on_end: list[Callable[[Simulation], Any]] = []
        self._local: list[Rows] = []
        self._obstacles: Optional[Obstacles] = None
        me = weakref.ref(self)
        self._core.on_end(lambda: [call(me()) for call in me()._on_end])
        self._core.on_step(lambda: [call(me()) for call in me()._on_step])
        self._core.on_frame(lambda: [call(me()) for call in me()._on_frame])

    def close(self) -> None:
        """Frees the simulation's memory and its folder. No method may be called afterwards."""
        if self._obstacles is not None:
            self._obstacles._release()
        del self._core

    def __enter__(self) -> "Simulation":
        return self

    def __exit__(self, *error: Any) -> None:
        self.close()

    # -- time ------------------------------------------------------------------------------------------------
    @property
    def time(self) -> float:
        """Simulated time, s."""
        return self._core.time

    @property
    def end(self) -> float:
        """End of the scene, s."""
        return self._core.end

    @property
    def steps(self) -> int:
        """Number of steps since the start of the scene."""
        return self._core.steps

    @property
    def last_step(self) -> float:
        """Length of the last step, s."""
        return self._core.last_step

    def step(self) -> bool:
        """Takes one step. Returns False without a step at the end of the scene or after a stop request."""
        return self._core.step()

    def run(self, until: Optional[float] = None, steps: Optional[int] = None, progress: bool = False) -> None:
        """Steps until a time (s), for a number of steps, or to the end of the scene.

        progress: a bar in a terminal or a notebook, on the first rank. Ctrl-C stops after the current step
        and raises KeyboardInterrupt; the simulation can go on.
        """
        show = None
        if progress and self.rank == 0:
            begin = self.time

            def show(time: float, end: float, step: int) -> None:
                share = 1.0 if end <= begin else min(1.0, (time - begin) / (end - begin))
                bar = "#" * round(30 * share)
                sys.stderr.write(f"\r[{bar:<30}] {100 * share:5.1f} %  t {time:.6g} s  step {step} ")
                sys.stderr.flush()

        self._core.run(until, steps, show)
        if show:
            sys.stderr.write("\n")

    def finish(self) -> int:
        """Writes the last checkpoint and the summary of a run with a folder. No step may follow.

        Returns the exit code that `thaw run` would have: 0 at the end, 75 after a stop request.
        """
        return self._core.finish()

    @property
    def stopped(self) -> bool:
        """True after a stop request: a stop file, a time limit, request_stop(). resume() takes it back."""
        return self._core.stopped

    @property
    def stop_reason(self) -> str:
        """What asked to stop."""
        return self._core.stop_reason

    def request_stop(self) -> None:
        """Requests that all ranks stop after the next step. One rank suffices."""
        self._core.request_stop()

    def resume(self) -> None:
        """Lets a stopped simulation go on."""
        self._core.resume()

    # -- data ------------------------------------------------------------------------------------------------
    @property
    def rank(self) -> int:
        """Number of this rank."""
        return self._core.rank

    @property
    def ranks(self) -> int:
        """Number of ranks."""
        return self._core.ranks

    @property
    def warnings(self) -> list[str]:
        """Warnings so far, on the first rank."""
        return self._core.warnings

    @property
    def tables(self) -> list[str]:
        """Tables of the scene: "particles", and "solids", "surfels", "oriented", "sheets" if it has them."""
        return self._core.tables()

    def fields(self, table: str = "particles") -> dict[str, tuple[str, str, int]]:
        """Fields of a table: name -> (unit, meaning, number of components)."""
        return {name: (unit, about, n) for name, unit, about, n in self._core.fields(table)}

    @property
    def particles(self) -> Rows:
        """The particles of this rank, inside of a block `with sim.local()`: sim.particles["temperature"]."""
        if not self._local:
            raise RuntimeError("sim.particles: use it in a block `with sim.local()`, or sim.gather()")
        return self._local[-1]

    @contextlib.contextmanager
    def local(self, table: str = "particles") -> Iterator[Rows]:
        """The rows of this rank, as arrays without a copy. See Rows.

        All ranks enter the block. Where velocities or temperatures of particles were changed, forces are
        computed anew at its end, and the ledger records the change as work, impulse and heat from outside.
        """
        changes = table == "particles"
        if changes:
            self._core.begin_edit()
        rows = Rows(self._core, table, changes)
        if changes:
            self._local.append(rows)
        try:
            yield rows
        finally:
            if changes:
                self._local.pop()
            rows.__dict__["_open"] = False
            if changes:
                self._core.end_edit()

    def gather(self, field: str, by: str = "id", table: str = "particles") -> np.ndarray:
        """A copy of a field of all ranks on every rank, sorted by id. For small cases."""
        if by != "id":
            raise ValueError("rows are sorted by id: by='id'")
        return self._core.gather(table, field)

    @property
    def ledger(self) -> dict[str, float]:
        """Energies (J), mass (kg), momentum (kg m/s), heat (J) and their residuals over all ranks."""
        return self._core.ledger()

    def picture(
        self,
        field: Optional[str] = None,
        *,
        size: Sequence[int] = (640, 480),
        limits: Sequence[Optional[float]] = (None, None),
        eye: Optional[Sequence[float]] = None,
        at: Optional[Sequence[float]] = None,
    ) -> Picture:
        """Returns a picture of the current points, which notebooks show. All ranks call it.

        field: of particles, for their colours; default: "temperature" with heat, else the speed.
        size: width and height in pixels. limits: lowest and highest value of the colours. eye, at: points
        in m that give the direction of the view. `thaw render` draws better pictures of frames.
        """
        points, values = [], []
        for table in ("particles", "oriented", "sheets"):
            if table not in self.tables or not (table != "particles" or field or self._total()):
                continue
            points.append(self.gather("position", table=table))
            values.append(self._colour(table, field, len(points[-1])))
        x = np.concatenate(points) if points else np.zeros((0, 3))
        of = np.concatenate(values) if values else np.zeros(0)
        return draw(x, of, size=size, limits=limits, eye=eye, at=at)

    def _total(self) -> int:
        return len(self.gather("id"))

    def _colour(self, table: str, field: Optional[str], n: int) -> np.ndarray:
        known = self.fields(table)
        name = field or ("temperature" if "temperature" in known else "velocity")
        if name not in known:
            if field and table == "particles":
                raise KeyError(f"unknown field '{field}'; the particles have {', '.join(known)}")
            return np.full(n, np.nan)
        values = np.asarray(self.gather(name, table=table), float)
        return values if values.ndim == 1 else np.sqrt((values.reshape(n, -1) ** 2).sum(axis=1))

    @property
    def obstacles(self) -> Obstacles:
        """Obstacles by name, which the program may move and whose loads it may read. See Obstacle."""
        if self._obstacles is None:
            self._obstacles = Obstacles(self._core, core().obstacle_names(self._core))
        return self._obstacles

    # -- output ----------------------------------------------------------------------------------------------
    def write_frame(self) -> None:
        """Writes a frame now."""
        self._core.write_frame()

    def write_checkpoint(self) -> None:
        """Writes a checkpoint now."""
        self._core.write_checkpoint()

    # -- functions of the program ----------------------------------------------------------------------------
    def on_step(self, call: Callable[["Simulation"], Any]) -> None:
        """Calls call(sim) after each step. run() raises its exceptions, after the step."""
        self._on_step.append(call)

    def on_frame(self, call: Callable[["Simulation"], Any]) -> None:
        """Calls call(sim) after each frame."""
        self._on_frame.append(call)

    def on_phase(self, phase: str, call: Callable[[Rows, float], Any]) -> None:
        """Calls call(p, t) after a phase of each step, with the particles p of this rank.

        phase: "predict" (half kick, drift), "redistribute" (emission, migration, sort), "density", "forces",
        "integrate" (second half kick), "phase_change" (heat, melting) or "end_of_step" (next step known).
        t is the time of the last complete step, s; after "end_of_step" that of this one. Arrays are
        read-only, except for fields of extensions. Raises ValueError for an unknown phase.
        """

        def after(source: Any, time: float) -> None:
            rows = Rows(source, "particles", False)
            try:
                call(rows, time)
            finally:
                rows.__dict__["_open"] = False

        self._core.on_phase(phase, after)

    def on_end(self, call: Callable[["Simulation"], Any]) -> None:
        """Calls call(sim) in finish(), before the last checkpoint."""
        self._on_end.append(call)

    def add_force(self, force: Callable[[Rows, float], Any]) -> None:
        """Adds a force: force(p, t) returns newtons of shape (n, 3) for the n particles p of this rank.

        Called once a step at their positions at time t (s). Its work and impulse are in the ledger. For the
        same bits on any number of ranks, a particle's force must follow from its own fields and t alone.
        The automatic sound speed of liquids does not include it: give material.NAME.sound_speed, ten times
        the largest speed of the flow.
        """

        def load(p: Rows, time: float, forces: np.ndarray, flow: Optional[np.ndarray]) -> None:
            forces += force(p, time)

        self._add_load(load)

    def add_heat(self, heat: Callable[[Rows, float], Any]) -> None:
        """Adds a source of heat: heat(p, t) returns watts of shape (n,). Requires a scene with heat."""
        if "temperature" not in self.fields():
            raise ValueError("the scene has no heat: nothing in it can change its temperature")

        def load(p: Rows, time: float, forces: np.ndarray, flow: Optional[np.ndarray]) -> None:
            flow += heat(p, time)

        self._add_load(load)

    def _add_load(self, load: Load) -> None:
        self._loads.append(load)
        if len(self._loads) > 1:
            return
        me = weakref.ref(self)
        self._core.add_load(lambda *given: _call(me()._loads, *given))


Load = Callable[[Rows, float, np.ndarray, Optional[np.ndarray]], None]


def _call(loads: Sequence[Load], source: Any, time: float, forces: np.ndarray, flow: Optional[np.ndarray]):
    rows = Rows(source, "particles", False)
    for load in loads:
        load(rows, time, forces, flow)
    rows.__dict__["_open"] = False


def register_extension(
    name: str,
    keys: Optional[Mapping[str, Any]] = None,
    *,
    force: Optional[Callable[[Rows, float, Mapping[str, float]], Any]] = None,
    heat: Optional[Callable[[Rows, float, Mapping[str, float]], Any]] = None,
    step_limit: Optional[Callable[[Mapping[str, float]], float]] = None,
    fields: Optional[Mapping[str, Any]] = None,
    update: Optional[Callable[[Rows, float, float, Mapping[str, float]], Any]] = None,
    about: str = "",
) -> None:
    """Registers a force, a source of heat, or fields that scenes name as [extension.NAME].

    keys: name -> default, or (default, unit), or (default, unit, least, most, meaning).
    force(p, t, values) returns newtons of shape (n, 3), heat(p, t, values) watts of shape (n,), for the n
    particles p of this rank at time t (s). step_limit(values) returns the longest stable step, s.
    fields: name -> unit, or (unit, meaning, components, start value). They are arrays of doubles that move
    with their particles, are in checkpoints, and in frames that list them in output.fields.
    update(p, t, dt, values) sets them at the end of each step of dt seconds, by p.name[...] = values.
    Scenes that name an unregistered extension are refused, also at a restart. With `heat`, scenes that name
    this extension have heat.
    """

    def note(key: str, given: Any) -> tuple[str, str, float, float, float, str]:
        given = given if isinstance(given, (tuple, list)) else (given,)
        default, unit, least, most, meaning = (*given, *("", -np.inf, np.inf, "")[len(given) - 1 :])
        return key, unit, float(default), float(least), float(most), meaning

    def load(values: Mapping[str, float]) -> Callable[..., None]:
        def add(p: Rows, time: float, forces: np.ndarray, flow: Optional[np.ndarray]) -> None:
            if force is not None:
                forces += force(p, time, values)
            if heat is not None:
                flow += heat(p, time, values)

        return lambda *given: _call([add], *given)

    def field_note(field: str, given: Any) -> tuple[str, str, str, int, float]:
        given = (given,) if isinstance(given, str) else tuple(given)
        unit, meaning, components, start = (*given, *("", 1, 0.0)[len(given) - 1 :])
        return field, unit, meaning, int(components), float(start)

    def make_update(values: Mapping[str, float]) -> Callable[..., None]:
        def advance(source: Any, time: float, dt: float) -> None:
            rows = Rows(source, "particles", False)
            try:
                update(rows, time, dt, values)
            finally:
                rows.__dict__["_open"] = False

        return advance

    core().register_extension(
        name,
        about,
        [note(key, given) for key, given in (keys or {}).items()],
        [field_note(field, given) for field, given in (fields or {}).items()],
        load if force is not None or heat is not None else None,
        make_update if update is not None else None,
        step_limit,
        heat is not None,
    )
