# SPDX-License-Identifier: Apache-2.0
"""Writes objects as a thaw scene: a TOML file, and a PLY file for each mesh."""
import json
import os
import re

import bmesh
import bpy
import numpy as np

from . import ply
from .properties import HEAT_CAPACITY, QUANTITIES


class ExportError(Exception):
    """The objects do not form a scene. The message says what to change."""


def text(value):
    """Returns a value as TOML."""
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, dict):
        return '{ ' + ', '.join(f'{key} = {text(v)}' for key, v in value.items()) + ' }'
    if isinstance(value, (list, tuple)):
        return '[' + ', '.join(text(v) for v in value) + ']'
    return f'{value:.6g}'


def table(head, values):
    return f'\n{head}\n' + ''.join(f'{key} = {text(value)}\n' for key, value in values.items())


def key(name):
    """Returns a name that is valid as a TOML key and in a file name."""
    return re.sub(r'[^A-Za-z0-9_-]+', '_', name) or 'unnamed'


def worldMesh(thing, graph):
    """Returns vertices and triangles of an object with its modifiers, and the number of its open edges."""
    evaluated = thing.evaluated_get(graph)
    mesh, work = evaluated.to_mesh(), bmesh.new()
    work.from_mesh(mesh)
    evaluated.to_mesh_clear()
    work.transform(thing.matrix_world)
    if thing.matrix_world.determinant() < 0:
        bmesh.ops.reverse_faces(work, faces=work.faces)
    bmesh.ops.triangulate(work, faces=work.faces)
    work.verts.index_update()
    vertices = np.array([v.co for v in work.verts], np.float32).reshape(-1, 3)
    triangles = np.array([[v.index for v in f.verts] for f in work.faces], np.int32).reshape(-1, 3)
    opened = sum(1 for edge in work.edges if len(edge.link_faces) != 2)
    work.free()
    return vertices, triangles, opened


class SceneWriter:
    def __init__(self, context, path):
        self.context, self.folder = context, os.path.dirname(os.path.abspath(path))
        self.path, self.graph = path, context.evaluated_depsgraph_get()
        self.materials, self.tables, self.notes, self.domain = {}, [], [], None
        self.points = []

    def write(self, objects):
        """Writes the scene. Returns warnings for the user."""
        writers = {
            'BODY': self.body,
            'OBSTACLE': self.obstacle,
            'EMITTER': self.emitter,
            'DOMAIN': self.setDomain,
        }
        for thing in objects:
            if thing.type == 'MESH' and thing.thaw.role != 'NONE':
                writers[thing.thaw.role](thing)
        if not any('[[body]]' in t or '[[emitter]]' in t for t in self.tables):
            raise ExportError('select at least one mesh whose role is Body or Emitter')
        settings = self.context.scene.thaw
        out = '# Written by the Blender add-on of thaw. `thaw check` describes the run.\n'
        out += f'spacing = {text(settings.spacing)}\nend = {text(settings.end)}\n'
        out += table('[domain]', self.box())
        for name, material in self.materials.items():
            out += table(f'[material.{name}]', self.quantities(material))
        out += ''.join(self.tables)
        if any('[[body]]' in t for t in self.tables):
            out += '\n[surface]\n'
        out += table('[output]', {'every': settings.every, **self.camera()})
        with open(self.path, 'w', encoding='utf-8') as file:
            file.write(out)
        return self.notes

    def mesh(self, thing):
        vertices, triangles, opened = worldMesh(thing, self.graph)
        if len(triangles) == 0:
            raise ExportError(f'{thing.name}: its mesh has no faces')
        if opened:
            self.notes.append(f'{thing.name}: its mesh is not closed ({opened} open edges)')
        self.points.append(vertices)
        name = f'{key(os.path.splitext(os.path.basename(self.path))[0])}_{key(thing.name)}.ply'
        ply.write(os.path.join(self.folder, name), vertices, triangles)
        return name

    def materialOf(self, thing):
        material = thing.active_material
        if material is None:
            raise ExportError(
                f'{thing.name}: needs a material; its panel "thaw" sets density, viscosity, ...'
            )
        self.materials[key(material.name)] = material
        return key(material.name)

    def quantities(self, material):
        values = {}
        colour = material.diffuse_color[:3]
        for name, to, *_ in QUANTITIES:
            given = getattr(material.thaw, name).strip()
            if given:
                parts = [part.strip() for part in given.split(',')]
                values[to] = parts if len(parts) > 1 else given
        self.completeHeat(material.name, values)
        srgb = [c * 12.92 if c <= 0.0031308 else 1.055 * c ** (1 / 2.4) - 0.055 for c in colour]
        values['colour'] = '#' + ''.join(f'{round(255 * min(1, max(0, c))):02x}' for c in srgb)
        return values

    def completeHeat(self, name, values):
        """Makes the values of a material valid: melting needs a heat capacity, latent heat needs melting."""
        if 'melts' in values and 'young' not in values:
            raise ExportError(f"material {name} melts, so it starts as a solid: set its Young's modulus")
        if 'melts' in values and 'heat_capacity' not in values:
            values['heat_capacity'] = HEAT_CAPACITY
            self.notes.append(
                f'material {name} melts, but its heat capacity is empty: {HEAT_CAPACITY} is written'
            )
        if 'latent_heat' in values and 'melts' not in values:
            del values['latent_heat']
            self.notes.append(f'material {name} has a latent heat, but does not melt: it is not written')

    def body(self, thing):
        values = {'name': thing.name, 'mesh': self.mesh(thing), 'material': self.materialOf(thing)}
        self.tables.append(table('[[body]]', {**values, **self.temperature(thing)}))

    def obstacle(self, thing):
        if thing.animation_data and thing.animation_data.action:
            self.notes.append(f'{thing.name}: its animation is not written')
        values = {'name': thing.name, 'mesh': self.mesh(thing)}
        self.tables.append(table('[[obstacle]]', {**values, **self.temperature(thing)}))

    def emitter(self, thing):
        corners = np.array([thing.matrix_world @ v.co for v in thing.data.vertices])
        if len(corners) < 3:
            raise ExportError(f'{thing.name}: expected a plane or a disc as emitter')
        self.points.append(corners)
        centre, along = corners.mean(axis=0), thing.matrix_world.to_3x3().col[2].normalized()
        radius = float(np.linalg.norm(corners - centre, axis=1).max())
        if len(corners) == 4:
            opening = {'rectangle': {'width': thing.dimensions.x, 'depth': thing.dimensions.y}}
        else:
            opening = {'disc': {'radius': radius}}
        values = {'name': thing.name, 'material': self.materialOf(thing), **opening, 'centre': list(centre)}
        values.update({'direction': list(along), 'speed': thing.thaw.speed})
        self.tables.append(table('[[emitter]]', {**values, **self.temperature(thing)}))

    def setDomain(self, thing):
        corners = np.array([thing.matrix_world @ v.co for v in thing.data.vertices])
        self.domain = corners.min(axis=0), corners.max(axis=0)

    def temperature(self, thing):
        given = thing.thaw.temperature.strip()
        return {'temperature': given} if given else {}

    def box(self):
        if self.domain is None:
            points = np.concatenate(self.points)
            low, high = points.min(axis=0), points.max(axis=0)
            margin = 0.5 * (high - low).max()
            self.domain = low - margin, high + margin
        low, high = self.domain
        return {'min': list(low), 'max': list(high)}

    def camera(self):
        thing = self.context.scene.camera
        if thing is None or thing.type != 'CAMERA':
            return {}
        eye = np.array(thing.matrix_world.translation)
        ahead = -np.array(thing.matrix_world.to_3x3().col[2].normalized())
        middle = (self.domain[0] + self.domain[1]) / 2
        at = eye + ahead * max(0.1, float((middle - eye) @ ahead))
        size = self.context.scene.render
        lens, wide = thing.data, size.resolution_x >= size.resolution_y
        vertical = lens.angle
        if lens.sensor_fit == 'HORIZONTAL' or (lens.sensor_fit == 'AUTO' and wide):
            vertical = 2 * np.arctan(np.tan(lens.angle / 2) * size.resolution_y / size.resolution_x)
        return {'camera': {'from': list(eye), 'at': list(at), 'field_of_view': float(vertical)}}
