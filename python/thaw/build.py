# SPDX-License-Identifier: Apache-2.0
"""Builders of the tables of a scene: dicts whose keys are those of scene files, with completion and help."""

from __future__ import annotations

import difflib
import inspect
import json
from typing import Any, Mapping, Optional

from ._load import schemaText

__all__ = [
    "Body",
    "Domain",
    "Emitter",
    "HeatedRegion",
    "Lamp",
    "Laser",
    "Material",
    "Numerics",
    "Obstacle",
    "OrientedBody",
    "Output",
    "SheetBody",
    "SurfaceSettings",
    "Thermostat",
]


def _propertiesOf(table: str) -> dict[str, Any]:
    """The keys of a table in the schema of scenes, which the key table generates."""
    if not table:  # the base class
        return {}
    schema = json.loads(schemaText())
    found = schema["definitions"].get(table) or schema["properties"][table]
    keys = found.get("properties") or found["additionalProperties"]["properties"]
    return {name: _resolved(schema, form) for name, form in keys.items()}


def _resolved(schema: Any, form: Any) -> Any:
    while "$ref" in form:
        target = schema
        for part in form["$ref"][2:].split("/"):
            target = target[part]
        form = target
    return form


class _FromSchema(type):
    """Takes signature and docstring from the keys of the table."""

    table: str
    about: str
    named: bool

    @property
    def __signature__(cls) -> inspect.Signature:
        first = [inspect.Parameter("name", inspect.Parameter.POSITIONAL_OR_KEYWORD)] if cls.named else []
        try:
            names = [name for name in _propertiesOf(cls.table) if name.isidentifier()]
        except ImportError:  # without the compiled part
            names = []
        only = inspect.Parameter.KEYWORD_ONLY
        return inspect.Signature([*first, *(inspect.Parameter(n, only, default=None) for n in names)])

    @property
    def __doc__(cls) -> str:  # type: ignore[override]
        lines = [cls.about, ""]
        try:
            for name, form in _propertiesOf(cls.table).items():
                text = " ".join(form.get("description", "").split("\n\n"))
                default = f" Default: {form['default']}." if "default" in form else ""
                lines.append(f"{name}: {text}{default}")
        except ImportError:  # without the compiled part
            lines.append(f"Its keys are those of the table `{cls.table}` of scene files.")
        return "\n".join(lines)


class Table(dict, metaclass=_FromSchema):
    table = ""
    about = ""
    named = False

    def __init__(self, **keys: Any):
        known = _propertiesOf(self.table)
        for key in keys:
            if key not in known:
                near = difflib.get_close_matches(key, known, 1)
                hint = f"; did you mean '{near[0]}'?" if near else f"; it has {', '.join(sorted(known))}"
                raise TypeError(f"{type(self).__name__} has no key '{key}'{hint}")
        super().__init__({key: value for key, value in keys.items() if value is not None})

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{k}={v!r}' for k, v in self.items())})"


class Body(Table):
    table, about = "body", "A body of solid or liquid particles: an element of Scene(body=[...])."


class Emitter(Table):
    table, about = "emitter", "An opening that emits particles: an element of Scene(emitter=[...])."


class Obstacle(Table):
    table, about = (
        "obstacle",
        "A rigid object that particles cannot enter: an element of Scene(obstacle=[...]).",
    )


class OrientedBody(Table):
    table, about = "oriented", "A surface of oriented particles: an element of Scene(oriented=[...])."


class SheetBody(Table):
    table, about = "sheet", "A sheet of damped springs: an element of Scene(sheet=[...])."


class Thermostat(Table):
    table, about = "thermostat", "Brings particles to a temperature: an element of Scene(thermostat=[...])."


class Lamp(Table):
    table, about = "lamp", "Light that exposed particles absorb: an element of Scene(lamp=[...])."


class Laser(Table):
    table, about = "laser", "A beam with a Gaussian profile: an element of Scene(laser=[...])."


class HeatedRegion(Table):
    table, about = (
        "heated_region",
        "Power that the particles in a shape receive: an element of Scene(heated_region=[...]).",
    )


class Domain(Table):
    table, about = "domain", "The simulated box: Scene(domain=...)."


class Numerics(Table):
    table, about = "numerics", "The numerical method: Scene(numerics=...)."


class SurfaceSettings(Table):
    table, about = "surface", "Surfels on the continuum bodies: Scene(surface=...)."


class Output(Table):
    table, about = "output", "Frames, checkpoints and pictures: Scene(output=...)."


class Material(Table):
    table, about = "material", "A material with a name: Scene(material=[Material('wax', density=900)])."
    named = True

    def __init__(self, name: str, **keys: Any):
        super().__init__(**keys)
        self.name = name


def builderKeys(keys: Mapping[str, Any]) -> dict[str, Any]:
    """The keys of a scene, with materials by their names."""
    made = dict(keys)
    given: Optional[Any] = made.get("material")
    if isinstance(given, Material):
        given = [given]
    if isinstance(given, (list, tuple)):
        for one in given:
            if not isinstance(one, Material):
                raise TypeError(f"material: expected thaw.Material(...) or a dict of names, got {one!r}")
        made["material"] = {one.name: one for one in given}
    return made
