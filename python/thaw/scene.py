# SPDX-License-Identifier: Apache-2.0
"""Scenes: from a file, from a dict, or with keywords."""

from __future__ import annotations

import functools
import inspect
import json
import math
import os
import subprocess
import tempfile
from typing import Any, Iterator, Mapping, Optional, Union

from ._load import core
from .errors import ProgramError
from .mesh import findProgram

__all__ = ["Scene", "SceneReport"]


@functools.lru_cache(maxsize=1)
def _schema() -> str:
    return core().schema()


class _Completed(type):
    """Adds the keys of scene files to the signature of Scene, for the completion of keywords."""

    @property
    def __signature__(cls) -> inspect.Signature:
        kind = inspect.Parameter.KEYWORD_ONLY
        first = inspect.Parameter("scene", inspect.Parameter.POSITIONAL_OR_KEYWORD, default=None)
        try:
            names = list(json.loads(_schema())["properties"])
        except ImportError:
            names = []
        keys = [inspect.Parameter(name, kind, default=None) for name in ["name", *names]]
        return inspect.Signature([first, *keys])


class SceneReport(Mapping):
    """The result of `Scene.check()`: what `thaw check --json` prints, as a mapping in SI units.

    True if the scene is usable. errors: list of dicts with file, line, column, message. warnings: texts.
    """

    def __init__(self, values: Mapping[str, Any]):
        self._values = values
        self.errors: list[dict[str, Any]] = values["errors"]
        self.warnings: list[str] = values.get("warnings", [])

    def __getitem__(self, key: str) -> Any:
        return self._values[key]

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    def __bool__(self) -> bool:
        return not self.errors

    @property
    def particles(self) -> int:
        """Number of particles of bodies at the start."""
        return sum(body["particles"] for body in self._values.get("particles", {}).get("bodies", []))

    @property
    def run_time(self) -> tuple[float, float]:
        """Shortest and longest expected wall-clock time of a run, s."""
        return tuple(self._values["estimate"]["run_time"])

    def __repr__(self) -> str:
        if self.errors:
            return "\n".join(_errorLine(error) for error in self.errors)
        step = self._values["time_step"]["start"]
        dt = "no step limit" if step is None else f"dt {step:.2g} s"
        least, most = self.run_time
        lines = [f"{self.particles} particles, {dt}, {least:.2g} to {most:.2g} s to run"]
        return "\n".join(lines + ["warning: " + line for line in self.warnings])


def _errorLine(error: Mapping[str, Any]) -> str:
    place = [str(error[key]) for key in ("file", "line", "column") if key in error]
    return ":".join(place) + ": " + error["message"]


class Scene(metaclass=_Completed):
    """A scene: a file, or the keys of one.

    Scene("melt.toml")                       a file; keywords override its keys
    Scene(spacing="1 cm", end=2, body=[...]) keys as in a scene file: texts with units, or numbers in SI
    Scene({"spacing": 0.01, ...})            the same as a dict
    """

    def __init__(self, scene: Union[str, Mapping[str, Any], None] = None, name: str = "scene", **keys: Any):
        self.overrides: dict[str, Any] = {}
        if scene is None or isinstance(scene, Mapping):
            self.name = name
            self.keys: Optional[dict[str, Any]] = {**(scene or {}), **keys}
        else:
            self.name = str(scene)
            self.keys = None
            self.overrides = {key.replace("__", "."): value for key, value in keys.items()}

    @classmethod
    def of(cls, scene: Union[str, "Scene", Mapping[str, Any]]) -> "Scene":
        """The scene itself, or one made of a file or a dict of keys."""
        return scene if isinstance(scene, Scene) else cls(scene)

    def __getitem__(self, key: str) -> Any:
        table: Any = self._editable()
        for part in key.split("."):
            table = table[part]
        return table

    def __setitem__(self, key: str, value: Any) -> None:
        if self.keys is None:
            self.overrides[key] = value
            return
        table: Any = self.keys
        *tables, last = key.split(".")
        for part in tables:
            table = table.setdefault(part, {})
        table[last] = value

    def _editable(self) -> dict[str, Any]:
        return self.overrides if self.keys is None else self.keys

    @property
    def text(self) -> str:
        """The scene as TOML; empty for a file."""
        return "" if self.keys is None else self.to_toml()

    def to_toml(self) -> str:
        """The keys as the text of a scene file."""
        if self.keys is None:
            with open(self.name, encoding="utf-8") as file:
                return file.read()
        return "".join(f"{_key(k)} = {self.toml_value(v)}\n" for k, v in self.keys.items())

    def save(self, path: str) -> None:
        """Writes the scene as a file for `thaw run`."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.to_toml())

    def check(self, ranks: int = 0) -> SceneReport:
        """Returns the report of `thaw check`, or the errors of the scene. Takes seconds.

        ranks: number of ranks for the estimates of memory and time. The program is the one that the
        variable THAW_PROGRAM names, or else the one on PATH. Raises ProgramError if there is none.
        """
        command = [findProgram("to check a scene"), "check", "--json"]
        command += ["--ranks", str(int(ranks))] if ranks else []
        for key, value in self.overrides.items():
            command += ["--set", f"{key}={self.toml_value(value)}"]
        if self.keys is None:
            return _report([*command, self.name])
        # Paths of meshes are relative to the file, which is therefore in the current folder.
        folder = os.getcwd() if os.access(os.getcwd(), os.W_OK) else None
        with tempfile.NamedTemporaryFile(
            "w", suffix=".toml", prefix=f".{_plain(self.name)}_", dir=folder
        ) as file:
            file.write(self.to_toml())
            file.flush()
            return _report([*command, file.name], {file.name: self.name})

    @staticmethod
    def schema() -> dict[str, Any]:
        """The JSON schema (draft 4) of scenes: keys, types, ranges, units, defaults and meanings."""
        return json.loads(_schema())

    def _ipython_key_completions_(self) -> list[str]:
        return list(self._editable())

    @staticmethod
    def toml_value(value: Any) -> str:
        """A value in TOML. numpy arrays and numbers are taken like lists and numbers."""
        if hasattr(value, "tolist"):
            value = value.tolist()
        if isinstance(value, bool):
            return "true" if value else "false"
        if isinstance(value, int):
            return str(value)
        if isinstance(value, float):
            if not math.isfinite(value):
                raise ValueError(f"a scene has finite numbers only, got {value}")
            return repr(value)
        if isinstance(value, str):
            return json.dumps(value, ensure_ascii=False)
        if isinstance(value, Mapping):
            return "{ " + ", ".join(f"{_key(k)} = {Scene.toml_value(v)}" for k, v in value.items()) + " }"
        if isinstance(value, (list, tuple)):
            return "[" + ", ".join(Scene.toml_value(v) for v in value) + "]"
        raise TypeError(f"a scene has numbers, texts, lists and tables, got {type(value).__name__}")


def _plain(name: str) -> str:
    return "".join(c if c.isalnum() else "_" for c in os.path.basename(name)) or "scene"


def _report(command: list[str], names: Mapping[str, str] = {}) -> SceneReport:
    done = subprocess.run(command, capture_output=True, text=True, errors="replace", env=_ownEnvironment())
    text = done.stdout
    for path, name in names.items():
        text = text.replace(json.dumps(path)[1:-1], json.dumps(name)[1:-1])
    begin = text.find("{")
    if begin < 0 or done.returncode not in (0, 2, 3):
        lines = (done.stderr or done.stdout).strip().splitlines() or ["no message"]
        raise ProgramError(f"{' '.join(command)} failed with exit code {done.returncode}: {lines[-1]}")
    return SceneReport(json.loads(text[begin:]))


def _ownEnvironment() -> dict[str, str]:
    """Returns the environment without launcher variables, which would make the program expect other ranks."""
    marks = ("OMPI_COMM_", "OMPI_UNIVERSE", "OMPI_MCA_orte", "OMPI_MCA_ess", "OMPI_APP", "PMIX_", "PMI_")
    return {key: value for key, value in os.environ.items() if not key.startswith(marks)}


def _key(name: Any) -> str:
    text = str(name)
    bare = text and all(c.isascii() and (c.isalnum() or c in "_-") for c in text)
    return text if bare else json.dumps(text, ensure_ascii=False)
