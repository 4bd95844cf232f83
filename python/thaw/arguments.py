# SPDX-License-Identifier: Apache-2.0
"""Checks of arguments. Each returns the value, or raises TypeError, which states what was expected."""

from __future__ import annotations

import numbers
import os
from typing import Any, Callable, Mapping


def _refuse(name: str, expected: str, value: Any) -> TypeError:
    return TypeError(f"{name}: expected {expected}, got {value!r}")


def number(name: str, value: Any) -> float:
    """A real number."""
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise _refuse(name, "a number", value)
    return float(value)


def count(name: str, value: Any) -> int:
    """A whole number of at least 0. Raises ValueError for a negative one."""
    if isinstance(value, bool) or not isinstance(value, numbers.Integral):
        raise _refuse(name, "a whole number", value)
    if value < 0:
        raise ValueError(f"{name}: expected a number of at least 0, got {value}")
    return int(value)


def function(name: str, value: Any) -> Callable[..., Any]:
    """A function, or another object that can be called."""
    if not callable(value):
        raise _refuse(name, "a function", value)
    return value


def path(name: str, value: Any) -> str:
    """The text of a path."""
    if not isinstance(value, (str, os.PathLike)):
        raise _refuse(name, "a path", value)
    return os.fspath(value)


def scene(value: Any) -> str:
    """The path of a scene file."""
    if not isinstance(value, (str, os.PathLike)):
        raise _refuse("scene", "a path, a dict or a Scene", value)
    if "\n" in os.fspath(value):
        raise TypeError(
            "scene: expected a path, a dict or a Scene, got a text of several lines: save it as a file"
        )
    return os.fspath(value)


def mapping(name: str, value: Any) -> Mapping[str, Any]:
    """A dict or another mapping."""
    if not isinstance(value, Mapping):
        raise _refuse(name, "a dict", value)
    return value


def communicator(name: str, value: Any) -> int:
    """The handle of a communicator of mpi4py."""
    if not hasattr(value, "py2f"):
        raise _refuse(name, "a communicator of mpi4py", value)
    return value.py2f()
