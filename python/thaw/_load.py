# SPDX-License-Identifier: Apache-2.0
"""Finds the compiled part of the package."""

from __future__ import annotations

import functools
import importlib
from types import ModuleType


def core() -> ModuleType:
    """The module thaw._core. Raises ImportError with instructions to build it."""
    try:
        import mpi4py.MPI  # noqa: F401  starts MPI, so that its communicators can be used
    except ImportError:
        pass
    try:
        return importlib.import_module("thaw._core")
    except ModuleNotFoundError as error:
        if error.name != "thaw._core":
            raise
        raise ImportError(
            "simulations need the compiled part of the package: install python3-dev and pybind11-dev, build "
            "thaw, and import it from <build>/python or from the installation. Or run pip install . in the "
            "source folder of thaw"
        ) from None


@functools.lru_cache(maxsize=1)
def schemaText() -> str:
    """The JSON schema of scenes, with the keys of registered extensions. Registering one clears the cache."""
    return core().schema()
