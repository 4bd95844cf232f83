# SPDX-License-Identifier: Apache-2.0
"""Forces, sources of heat and fields that scenes name as [extension.NAME]."""

from __future__ import annotations

from typing import Any, Callable, Mapping, Optional

import numpy as np

from ._load import core, schemaText
from .rows import Rows

__all__ = ["register_extension"]

Load = Callable[[Rows, float, np.ndarray, Optional[np.ndarray]], None]


def callLoad(load: Load, source: Any, time: float, forces: np.ndarray, flow: Optional[np.ndarray]) -> None:
    """Calls a load with rows that end with the call."""
    rows = Rows(source, "particles", False)
    try:
        load(rows, time, forces, flow)
    finally:
        rows._close()


def checkedLoad(values: Any, wanted: tuple[int, ...], name: str) -> np.ndarray:
    """Returns what a function of the program returned, as an array that can be added to one of this shape.

    Raises ValueError for another shape and for values that are not finite, with the first such row.
    """
    try:
        load = np.asarray([] if values is None else values, dtype=float)
    except (TypeError, ValueError):
        load = np.asarray([])
    if load.size == 0 and np.prod(wanted) > 0:
        raise ValueError(
            f"{name} returned {type(values).__name__}: expected an array of numbers of shape {wanted}"
        )
    if load.ndim > len(wanted) or any(a not in (1, b) for a, b in zip(load.shape[::-1], wanted[::-1])):
        raise ValueError(f"{name} returned an array of shape {load.shape}: expected {wanted}")
    if not np.isfinite(load).all():
        row = int(np.argwhere(~np.isfinite(np.broadcast_to(load, wanted)))[0][0])
        raise ValueError(f"{name} returned a value that is not finite, for the particle of row {row}")
    return load


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

    keys: name -> default, or (default, unit), or (default, unit, least, most, meaning); the unit in SI.
    force: force(p, t, values) returns newtons of shape (n, 3) for the n particles p of this rank, at the
    time t (s).
    heat: heat(p, t, values) returns watts of shape (n,).
    step_limit: step_limit(values) returns the longest stable step, s.
    fields: name -> unit, or (unit, meaning, components, start value). They are arrays of doubles that move
    with their particles. Checkpoints contain them, and so do frames that list them in output.fields.
    update: update(p, t, dt, values) sets them at the end of each step of dt seconds: p.name[...] = values.
    about: one line about the extension, for the key table.

    Scenes that name an unregistered extension are refused, also at a restart. An extension with `heat` turns
    heat on in scenes that name it.
    """

    def note(key: str, given: Any) -> tuple[str, str, float, float, float, str]:
        given = given if isinstance(given, (tuple, list)) else (given,)
        default, unit, least, most, meaning = (*given, *("", -np.inf, np.inf, "")[len(given) - 1 :])
        return key, unit, float(default), float(least), float(most), meaning

    def load(values: Mapping[str, float]) -> Callable[..., None]:
        def add(p: Rows, time: float, forces: np.ndarray, flow: Optional[np.ndarray]) -> None:
            if force is not None:
                forces += checkedLoad(force(p, time, values), forces.shape, f"force of extension '{name}'")
            if heat is not None:
                flow += checkedLoad(heat(p, time, values), flow.shape, f"heat of extension '{name}'")

        return lambda *given: callLoad(add, *given)

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
                rows._close()

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
    schemaText.cache_clear()
