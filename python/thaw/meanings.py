# SPDX-License-Identifier: Apache-2.0
"""Meaning of the fields of frames, by kind of points (docs/reference/files.md).

The meanings of fields of extensions are in the file.
"""
from __future__ import annotations

from typing import Dict

COMMON: Dict[str, str] = {
    'position': 'position x, y, z',
    'id': 'number that never changes',
    'velocity': 'velocity x, y, z',
    'temperature': 'temperature',
    'color': 'red, green, blue',
}

MEANINGS: Dict[str, Dict[str, str]] = {
    'particles': {
        'liquid': 'liquid fraction, 0 solid to 1 liquid',
        'density': 'density; of a solid, from its deformation',
        'pressure': 'pressure of liquid',
        'volume': 'volume at rest',
        'viscosity': 'viscosity at the current shear rate and temperature',
        'absorbed': 'power absorbed from lamps, lasers and heated regions',
        'stress': 'Cauchy stress of solids, tension positive: xx, yy, zz, xy, yz, xz',
        'strain': 'Green strain from the first reference: xx, yy, zz, xy, yz, xz, shear not doubled',
        'plastic_strain': 'plastic strain: xx, yy, zz, xy, yz, xz, shear not doubled',
        'material': 'number of the material in the scene',
        'body': 'number of the body or emitter in the scene',
        'rank': 'rank that owned the particle',
        'neighbours': 'number of neighbours; of a solid particle, its bonds',
    },
    'surface': {
        'normal': 'outward unit normal',
        'radius': 'radius of the disc',
        'component': 'label of its component: 1 + the smallest id of its particles',
        'detail': "share of the mesh's detail that is left",
        'liquid': 'liquid fraction of the particles around',
        'temperature': 'temperature of the particles around',
    },
    'sheets': {
        'displacement': 'displacement from the position at rest',
        'plastic': 'move of the rest position by plasticity',
        'sheet_body': 'number of the sheet in the scene',
        'part': 'connected piece of its mesh',
    },
    'oriented': {
        'normal': 'unit normal',
        'orientation': 'quaternion w, x, y, z',
        'radius': 'target spacing',
        'oriented_body': 'number of the body it was made in',
        'group': 'number of the body it belongs to after welds',
        'cut_sides': 'two bits a cut: its side',
        'flags': '1 in a crease, 2 fixed position, 4 fixed orientation, 16 born in contact',
    },
}


# names that [output] fields of a scene may list
OUTPUT_FIELDS = ('velocity', 'temperature', *MEANINGS['particles'])


def meaningOf(kind: str, name: str) -> str:
    """One line about a field, or an empty text for an unknown one."""
    return MEANINGS.get(kind, {}).get(name, COMMON.get(name, ''))
