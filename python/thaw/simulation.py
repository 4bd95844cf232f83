# SPDX-License-Identifier: Apache-2.0
"""Simulations: made from a scene, stepped, read and changed from Python, on any number of ranks."""

from __future__ import annotations

import contextlib
import sys
import weakref
from typing import Any, Callable, Iterator, Mapping, Optional, Sequence, Union

import numpy as np

from . import arguments
from ._load import core
from .errors import BlewUp, unknownName
from .extension import Load, callLoad, checkedLoad
from .log import Log
from .obstacles import Obstacles
from .picture import Picture, draw
from .rows import Rows
from .scene import Scene
from .signals import StopSignals
from .uncaught import end_all_ranks_on_exceptions

__all__ = ["Rows", "Simulation"]


class _Closed:
    """In place of the compiled part after close()."""

    def __getattr__(self, name: str) -> Any:
        raise RuntimeError("the simulation is closed")


class Simulation:
    """A simulation of a scene.

    scene: a path, a thaw.Scene, or a dict of its keys.
    out: folder for frames, checkpoints and the summary; None: nothing is written.
    comm: an mpi4py communicator; None: all ranks. All of its ranks call all methods in the same order.
    restart: continue from the checkpoint in `out`, which must exist.
    resume: continue from the checkpoint in `out` if there is one.
    force: take over the folder from a run of another host.
    set: overrides of keys, such as {"numerics.cfl_sound": 0.2}.
    log: called with each line of progress and each warning, on the first rank.
    time_limit: wall-clock time after which the simulation stops, s; None: no limit.

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
        options = {"scene": scene.name, "out": "" if out is None else arguments.path("out", out)}
        for key, on in (("restart", restart), ("resume", resume), ("force", force)):
            if on:
                options[key] = "1"
        if time_limit is not None:
            options["time_limit"] = repr(arguments.number("time_limit", time_limit))
        for key, value in {**scene.overrides, **arguments.mapping("set", set or {})}.items():
            options["set " + key] = Scene.toml_value(value)
        if log is not None:
            arguments.function("log", log)
        handle = None if comm is None else arguments.communicator("comm", comm)
        self._core = core().Simulation(scene.text, options, log, handle)
        self.scene = scene
        # The compiled part has only weak references, so that a simulation ends with its last reference.
        self._calls: dict[str, list[Callable[..., Any]]] = {}
        self._loads: dict[int, Load] = {}
        self._failure: Optional[str] = None  # message of BlewUp, until restore()
        self._local: list[Rows] = []
        self._obstacles: Optional[Obstacles] = None
        self._signals = StopSignals(always=self._core.ranks > 1)
        if self._core.ranks > 1:
            end_all_ranks_on_exceptions(core().abort)

    def close(self) -> None:
        """Frees the simulation's memory and its folder. All later calls of methods raise RuntimeError.

        Raises RuntimeError within a block `with sim.local()` and within a function that a step calls.
        """
        if not isinstance(self._core, _Closed):
            self._core.refuse_close()
        if self._obstacles is not None:
            self._obstacles._release()
        self._core = _Closed()

    def __repr__(self) -> str:
        if isinstance(self._core, _Closed):
            return f"<Simulation {self.scene.name}, closed>"
        return (
            f"<Simulation {self.scene.name}: t = {self.time:.6g} of {self.end:.6g} s, step {self.steps}, "
            f"{self.ranks} rank{'' if self.ranks == 1 else 's'}>"
        )

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
        """Takes one step. Returns False without a step at the end of the scene or after a stop request.

        Exceptions of functions of the program are raised on all ranks at the end of the step. Ranks without
        one of their own raise RuntimeError("rank 1: KeyError: ...").
        """
        with self._signals, self._stepping():
            return self._core.step()

    @contextlib.contextmanager
    def _stepping(self) -> Iterator[None]:
        """Stores the failure of a simulation, which has no valid state until restore()."""
        if self._failure is not None:
            raise BlewUp(self._failure)
        try:
            yield
        except BlewUp as failure:
            self._failure = str(failure)
            raise

    def run(self, until: Optional[float] = None, steps: Optional[int] = None, progress: bool = False) -> None:
        """Steps until a time (s), for a number of steps, or to the end of the scene.

        progress: a bar in a terminal or a notebook, on the first rank.

        Ctrl-C, SIGTERM, SIGUSR1 and SIGUSR2 end the run after the current step on all ranks. With a folder
        they write a checkpoint. They raise KeyboardInterrupt, and the simulation can go on. Exceptions of
        functions are raised as by step(). `until` may lie beyond the end of the scene. Raises ValueError for
        a time that has passed. Raises BlewUp if the retries of a step are used up. All later calls then raise
        it until restore().
        """
        if until is not None and not arguments.number("until", until) >= self.time:
            raise ValueError(
                f"until: expected a time of at least {self.time:.9g} s, which is now, got {until}"
            )
        if steps is not None:
            steps = arguments.count("steps", steps)
        show = None
        if progress and self.rank == 0:
            begin = self.time

            def show(time: float, end: float, step: int) -> None:
                share = 1.0 if end <= begin else min(1.0, (time - begin) / (end - begin))
                bar = "#" * round(30 * share)
                sys.stderr.write(f"\r[{bar:<30}] {100 * share:5.1f} %  t {time:.6g} s  step {step} ")
                sys.stderr.flush()

        try:
            with self._signals, self._stepping():
                self._core.run(until, steps, show)
        finally:
            if show:
                sys.stderr.write("\n")

    def finish(self) -> int:
        """Writes the last checkpoint and the summary of a run with a folder. No step may follow.

        Returns the exit code that `thaw run` would have: 0 at the end, 75 after a stop request.
        """
        with self._signals:
            return self._core.finish()

    @property
    def stopped(self) -> bool:
        """True after a stop request: a stop file, a time limit, request_stop(). resume() clears it."""
        return self._core.stopped

    @property
    def stop_reason(self) -> str:
        """Cause of the stop."""
        return self._core.stop_reason

    def request_stop(self) -> None:
        """Requests that all ranks stop after the next step. It suffices to call it on one rank."""
        self._core.request_stop()

    def resume(self) -> None:
        """Clears the stop request of a stopped simulation."""
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

    def _require(self, table: str) -> None:
        """Raises thaw.FieldError for a table that the simulation does not have."""
        if table not in self.tables:
            raise unknownName(table, self.tables, "the simulation", "table")

    def fields(self, table: str = "particles") -> dict[str, tuple[str, str, int]]:
        """Fields of a table: name -> (unit, meaning, number of components). Raises thaw.FieldError."""
        self._require(table)
        return {name: (unit, about, n) for name, unit, about, n in self._core.fields(table)}

    @property
    def particles(self) -> Rows:
        """The particles of this rank, in a block `with sim.local()`: sim.particles["temperature"]."""
        if not self._local:
            raise RuntimeError("sim.particles: use it in a block `with sim.local()`, or sim.gather()")
        return self._local[-1]

    @contextlib.contextmanager
    def local(self, table: str = "particles") -> Iterator[Rows]:
        """The rows of this rank, as arrays without a copy. See Rows.

        All ranks enter the block. If velocities or temperatures of particles were changed, forces are
        computed anew at its end. The ledger records the change as work, impulse and heat from outside.
        Raises ValueError on all ranks for values that are not finite and for temperatures below 0 K, and
        reverts the changes. Raises RuntimeError within a block of the particles. In a block no step, frame
        or checkpoint is possible.
        """
        changes = table == "particles"
        self._require(table)
        if changes and self._local:
            raise RuntimeError("sim.local(): a block of the particles is open; use its rows, sim.particles")
        self._core.begin_block(table, changes)
        rows = Rows(self._core, table, changes)
        if changes:
            self._local.append(rows)
        try:
            yield rows
        finally:
            if changes:
                self._local.pop()
            rows._close()
            self._core.end_block(changes)

    def gather(self, field: str, by: str = "id", table: str = "particles") -> np.ndarray:
        """A copy of a field of all ranks on every rank, sorted by id. For small cases.

        Raises thaw.FieldError for an unknown table or field.
        """
        if by != "id":
            raise ValueError(f"by: expected 'id', by which rows are sorted, got {by!r}")
        known = self.fields(table)
        if field not in known:
            raise unknownName(field, known, f"table '{table}'")
        return self._core.gather(table, field)

    @property
    def ledger(self) -> dict[str, float]:
        """Energies (J), mass (kg), momentum (kg m/s), heat (J) and their residuals over all ranks, now.

        All ranks must read it, even if only one of them prints it.
        Names are those of history; vectors have the keys momentum_x, momentum_y, momentum_z.
        outside_work and wall_work are both the work of walls and of the program. entered_... and left_... are
        sums over particles that entered through openings and left through open sides.
        """
        return self._core.ledger()

    @property
    def history(self) -> Log:
        """The ledger over time: columns by name, as in `thaw.open(out).ledger`, such as history["kinetic"].

        There is a row for the start, each frame, each output.ledger_every, and the end. After a restart,
        rows begin at the first of these times.
        """
        names, rows = self._core.history()
        return Log.ofColumns("the history of the simulation", names, list(rows.T))

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

        field: field of particles for their colours; default: "temperature" with heat, else the speed.
        size: width and height in pixels.
        limits: lowest and highest value of the colours.
        eye, at: points that give the direction of the view, m.

        `thaw render` draws better pictures of frames.
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
                raise unknownName(field, known, "table 'particles'")
            return np.full(n, np.nan)
        values = np.asarray(self.gather(name, table=table), float)
        return values if values.ndim == 1 else np.sqrt((values.reshape(n, -1) ** 2).sum(axis=1))

    @property
    def obstacles(self) -> Obstacles:
        """Obstacles by name. The program may move them and read their loads. See DrivenObstacle."""
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

    def restore(self) -> None:
        """Goes back to the newest checkpoint in the folder. Functions that were added stay."""
        self._core.restore()
        self._failure = None

    # -- functions of the program ----------------------------------------------------------------------------
    # The compiled part has only weak references, so that a simulation ends with its last reference.
    def _add(self, kind: str, call: Callable[..., Any]) -> None:
        calls = self._calls.setdefault(kind, [])
        calls.append(arguments.function("call", call))
        if len(calls) > 1:
            return
        me = weakref.ref(self)
        getattr(self._core, kind)(lambda: _callAll(me()._calls[kind], me()))

    def on_step(self, call: Callable[["Simulation"], Any]) -> None:
        """Calls call(sim) after each step.

        run() and step() raise its exceptions on all ranks at the end of the step. Other functions of the step
        are still called.
        """
        self._add("on_step", call)

    def on_frame(self, call: Callable[["Simulation"], Any]) -> None:
        """Calls call(sim) after each frame."""
        self._add("on_frame", call)

    def on_phase(self, phase: str, call: Callable[[Rows, float], Any]) -> None:
        """Calls call(p, t) after a phase of each step, with the particles p of this rank.

        phase: "predict" (half kick, drift), "redistribute" (emission, migration, sort), "density", "forces",
        "integrate" (second half kick), "phase_change" (heat, melting) or "end_of_step" (next dt known).

        t is the time of the last complete step, s; after "end_of_step", the time of this step. Arrays are
        read-only, except for fields of extensions. Raises ValueError for an unknown phase.
        """

        arguments.function("call", call)
        kind = f"phase {phase}"
        if kind not in self._calls:
            me = weakref.ref(self)

            def after(source: Any, time: float) -> None:
                rows = Rows(source, "particles", False)
                try:
                    _callAll(me()._calls[kind], rows, time)
                finally:
                    rows._close()

            self._core.on_phase(str(phase), after)
        self._calls.setdefault(kind, []).append(call)

    def on_end(self, call: Callable[["Simulation"], Any]) -> None:
        """Calls call(sim) in finish(), before the last checkpoint."""
        self._add("on_end", call)

    def add_force(self, force: Callable[[Rows, float], Any]) -> None:
        """Adds a force: force(p, t) returns newtons of shape (n, 3) for the n particles p of this rank.

        It is called at once, except after a restart, and then once a step at the positions at time t (s). If
        the first call raises an exception, the force is not added. Its work and impulse are in the ledger.
        For the same bits on any number of ranks, a particle's force must follow from its own fields and t
        alone.
        The automatic sound speed of liquids does not include it: set material.NAME.sound_speed, ten times
        the largest speed of the flow.
        """

        arguments.function("force", force)

        def load(p: Rows, time: float, forces: np.ndarray, flow: Optional[np.ndarray]) -> None:
            forces += checkedLoad(force(p, time), forces.shape, _nameOf(force))

        self._add_load(load)

    def add_heat(self, heat: Callable[[Rows, float], Any]) -> None:
        """Adds a source of heat: heat(p, t) returns watts of shape (n,). Requires a scene with heat."""
        arguments.function("heat", heat)
        if "temperature" not in self.fields():
            raise ValueError("the scene has no heat: nothing in it can change its temperature")

        def load(p: Rows, time: float, forces: np.ndarray, flow: Optional[np.ndarray]) -> None:
            flow += checkedLoad(heat(p, time), flow.shape, _nameOf(heat))

        self._add_load(load)

    def _add_load(self, load: Load) -> None:
        number = len(self._loads)
        self._loads[number] = load
        me = weakref.ref(self)

        def call(*given: Any) -> None:
            callLoad(me()._loads[number], *given)

        try:
            self._core.add_load(call)
        except BaseException:
            self._loads[number] = _nothing  # a force that fails at once is not added
            raise


def _nameOf(call: Callable[..., Any]) -> str:
    return getattr(call, "__name__", type(call).__name__)


def _callAll(calls: Sequence[Callable[..., Any]], *given: Any) -> None:
    """Calls all functions, since they may be collective. Raises the first exception."""
    first: Optional[BaseException] = None
    for call in list(calls):
        try:
            call(*given)
        except BaseException as error:
            first = first or error
    if first is not None:
        raise first


def _nothing(*given: Any) -> None:
    pass
