# SPDX-License-Identifier: Apache-2.0
"""Scenes: from a file, from a dict, or with keywords."""

from __future__ import annotations

import copy
import inspect
import json
import math
import os
import tempfile
from typing import Any, Iterator, Mapping, Optional, Union

from . import arguments
from ._load import core, schemaText
from .build import builderKeys

__all__ = ["Scene", "SceneReport"]


class _Completed(type):
    """Adds the keys of scene files to the signature of Scene, for the completion of keywords."""

    @property
    def __signature__(cls) -> inspect.Signature:
        kind = inspect.Parameter.KEYWORD_ONLY
        first = inspect.Parameter("scene", inspect.Parameter.POSITIONAL_OR_KEYWORD, default=None)
        try:
            names = list(json.loads(schemaText())["properties"])
        except ImportError:
            names = []
        keys = [inspect.Parameter(name, kind, default=None) for name in ["name", *names]]
        return inspect.Signature([first, *keys])


class SceneReport(Mapping):
    """The result of `Scene.check()`: the output of `thaw check --json`, as a mapping in SI units.

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

        Scene("melt.toml")                        # a file; keywords override its keys
        Scene(spacing="1 cm", end=2, body=[...])  # keys of a scene file
        Scene({"spacing": 0.01, ...})             # the same as a dict
        Scene(scene, end=3)                       # a copy of a Scene, with other keys

    Values are texts with units, or numbers in SI units. Raises TypeError for other kinds of scenes.
    """

    def __init__(
        self,
        scene: Union[str, os.PathLike[str], Mapping[str, Any], "Scene", None] = None,
        name: str = "scene",
        **keys: Any,
    ):
        self.overrides: dict[str, Any] = {}
        if isinstance(scene, Scene):
            name = scene.name if scene.keys is None or name == "scene" else name
            self.overrides = copy.deepcopy(scene.overrides)
            scene = scene.name if scene.keys is None else copy.deepcopy(scene.keys)
        if scene is None or isinstance(scene, Mapping):
            self.name = name or "scene"
            self.keys: Optional[dict[str, Any]] = builderKeys({**(scene or {}), **keys})
        else:
            self.name = arguments.scene(scene)
            self.keys = None
            self.overrides.update({key.replace("__", "."): value for key, value in keys.items()})

    @classmethod
    def of(cls, scene: Union[str, "Scene", Mapping[str, Any]]) -> "Scene":
        """The scene itself, or a scene made from a file or a dict of keys."""
        if scene is None:
            raise TypeError("scene: expected a path, a dict or a Scene, got None")
        return scene if isinstance(scene, Scene) else cls(scene)

    def __getitem__(self, key: str) -> Any:
        table: Any = self._editable()
        if self.keys is None:
            return table[key]
        for part in key.split("."):
            table = table[_place(table, part, key)]
        return table

    def __setitem__(self, key: str, value: Any) -> None:
        if self.keys is None:
            self.overrides[key] = value
            return
        table: Any = self.keys
        *tables, last = key.split(".")
        for part in tables:
            if isinstance(table, dict):
                table = table.setdefault(part, {})
            else:
                table = table[_place(table, part, key)]
        if isinstance(table, list):
            table[_place(table, last, key)] = value
        elif isinstance(table, dict):
            table[last] = value
        else:
            raise KeyError(f"'{key}': '{'.'.join(tables)}' is not a table of the scene, but {table!r}")

    def _editable(self) -> dict[str, Any]:
        return self.overrides if self.keys is None else self.keys

    @property
    def text(self) -> str:
        """The scene as TOML; empty for a file."""
        return "" if self.keys is None else self.to_toml() or "\n"

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

        ranks: number of ranks for the estimates of memory and time; 0: one.

        Keys of registered extensions are accepted. Not collective: each rank checks by itself. Raises the
        exceptions of extension functions.
        """
        overrides = [f"{key}={self.toml_value(value)}" for key, value in self.overrides.items()]
        if self.keys is None:
            return _report(self.name, overrides, ranks)
        # Paths of meshes are relative to the file, which is therefore in the current folder.
        folder = os.getcwd() if os.access(os.getcwd(), os.W_OK) else None
        with tempfile.NamedTemporaryFile(
            "w", suffix=".toml", prefix=f".{_plain(self.name)}_", dir=folder
        ) as file:
            file.write(self.to_toml())
            file.flush()
            return _report(file.name, overrides, ranks, self.name)

    @staticmethod
    def schema() -> dict[str, Any]:
        """The JSON schema (draft 4) of scenes: keys, types, ranges, units, defaults and meanings."""
        return json.loads(schemaText())

    def _ipython_key_completions_(self) -> list[str]:
        return list(self._editable())

    @staticmethod
    def toml_value(value: Any) -> str:
        """A value in TOML. Treats numpy arrays and numbers as lists and numbers."""
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


def _report(path: str, overrides: list[str], ranks: int, name: Optional[str] = None) -> SceneReport:
    text = core().check(path, overrides, int(ranks))
    if name is not None:
        text = text.replace(json.dumps(path)[1:-1], json.dumps(name)[1:-1])
    return SceneReport(json.loads(text))


def _place(table: Any, part: str, key: str) -> Any:
    """Returns the key of a table, or the index of a list entry, that `part` names."""
    if isinstance(table, Mapping):
        if part in table:
            return part
        raise KeyError(f"'{key}': there is no '{part}'; there are: {', '.join(map(str, table)) or 'none'}")
    if isinstance(table, list):
        names = [one.get("name") if isinstance(one, Mapping) else None for one in table]
        if part in names:
            return names.index(part)
        if part.isdigit() and int(part) < len(table):
            return int(part)
        known = ", ".join(str(n) if n else str(k) for k, n in enumerate(names))
        raise KeyError(f"'{key}': the list has no entry '{part}'; expected a name or number of: {known}")
    raise KeyError(f"'{key}': no key '{part}' in {table!r}, which is not a table of the scene")


def _key(name: Any) -> str:
    text = str(name)
    bare = text and all(c.isascii() and (c.isalnum() or c in "_-") for c in text)
    return text if bare else json.dumps(text, ensure_ascii=False)
