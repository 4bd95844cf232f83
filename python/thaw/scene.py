# SPDX-License-Identifier: Apache-2.0
"""Scenes: from a file, from a dict, or with keywords."""

from __future__ import annotations

import json
import math
from typing import Any, Mapping, Optional, Union

__all__ = ["Scene"]


class Scene:
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


def _key(name: Any) -> str:
    text = str(name)
    bare = text and all(c.isascii() and (c.isalnum() or c in "_-") for c in text)
    return text if bare else json.dumps(text, ensure_ascii=False)
