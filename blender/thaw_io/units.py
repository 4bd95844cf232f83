# SPDX-License-Identifier: Apache-2.0
"""Quantities of scenes in SI units: lengths, angles and times, as numbers or texts with a unit."""
import math
import re

UNITS = {'m': 1, 'km': 1e3, 'dm': 0.1, 'cm': 0.01, 'mm': 1e-3, 'um': 1e-6, 'in': 0.0254}
UNITS.update({'s': 1, 'ms': 1e-3, 'us': 1e-6, 'min': 60, 'h': 3600, 'rad': 1, 'deg': math.pi / 180, '': 1})


def si(value):
    """Returns a quantity as a number. Raises ValueError for units that the add-on does not support."""
    if isinstance(value, (int, float)):
        return float(value)
    match = re.fullmatch(r'\s*([-+]?[0-9.]+(?:[eE][-+]?[0-9]+)?)\s*(\w*)\s*', str(value))
    if not match or match[2] not in UNITS:
        raise ValueError(f'expected a number with a unit such as "15 cm", got {value!r}')
    return float(match[1]) * UNITS[match[2]]


def vector(value):
    return [si(x) for x in value]


def colour(text):
    """Returns red, green, blue of "#rrggbb", 0 to 1, linear."""
    parts = [int(text[k : k + 2], 16) / 255 for k in (1, 3, 5)]
    return [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts]


def listOf(value):
    """Returns a list of tables; one table may stand alone."""
    return [value] if isinstance(value, dict) else value
