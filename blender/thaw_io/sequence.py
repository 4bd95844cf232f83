# SPDX-License-Identifier: Apache-2.0
"""Objects whose mesh follows the current frame: surfaces, sheets, oriented bodies and particles."""
import json
import os

import bpy
import numpy as np
from bpy.app.handlers import persistent

from . import run_files

FILES, PARTICLES, START, SPACING = 'thaw_files', 'thaw_particles', 'thaw_start', 'thaw_spacing'
SHOWN, RATE = 'thaw_shown', 'thaw_rate'  # describe the present mesh
SCRIPT = 'enable_thaw_io.py'  # the name that Blender prints if it skips the script
SCRIPT_TEXT = '''# Meshes of thaw runs follow the frame only while the add-on is enabled.
import addon_utils

if not addon_utils.check('{module}')[1]:
    if addon_utils.enable('{module}', handle_error=lambda error: None) is None:
        print('thaw: WARNING: this file shows a run of thaw, and all its frames will look the same:')
        print('thaw: WARNING: install and enable the add-on thaw_io')
'''


def linear(colours):
    """Converts sRGB from 0 to 255 to the linear values from 0 to 1 of Blender."""
    c = colours.astype(np.float32) / 255
    return np.where(c <= 0.04045, c / 12.92, ((c + 0.055) / 1.055) ** 2.4)


def addAttribute(mesh, name, values):
    kinds = {1: ('FLOAT', 'value'), 3: ('FLOAT_VECTOR', 'vector'), 4: ('FLOAT_COLOR', 'color')}
    values = np.asarray(values, np.float32)
    kind, member = kinds[1 if values.ndim == 1 else values.shape[1]]
    attribute = mesh.attributes.new(name, kind, 'POINT')
    attribute.data.foreach_set(member, values.ravel())


def fill(mesh, vertices, triangles, fields, rate):
    """Replaces the geometry of a mesh.

    rate: factor of velocities: simulated seconds per frame times frames per second.
    """
    mesh.clear_geometry()
    mesh.vertices.add(len(vertices))
    mesh.vertices.foreach_set('co', np.asarray(vertices, np.float32).ravel())
    if len(triangles):
        mesh.loops.add(3 * len(triangles))
        mesh.loops.foreach_set('vertex_index', np.asarray(triangles, np.int32).ravel())
        mesh.polygons.add(len(triangles))
        mesh.polygons.foreach_set('loop_start', np.arange(0, 3 * len(triangles), 3, dtype=np.int32))
        if bpy.app.version < (3, 6):
            mesh.polygons.foreach_set('loop_total', np.full(len(triangles), 3, np.int32))
        mesh.polygons.foreach_set('use_smooth', np.ones(len(triangles), bool))
    mesh.update(calc_edges=True)
    for name, values in fields.items():
        if name == 'velocity':
            # Cycles uses this attribute, in m per second of animation, for meshes of changing topology.
            addAttribute(mesh, 'velocity', values * rate)
        elif name in ('colour', 'color'):
            c = linear(values)
            addAttribute(mesh, 'Col', np.column_stack([c, np.ones(len(c))]))
        elif (
            name not in ('normal', 'id', 'uv')
            and values.dtype.kind == 'f'
            and (values.ndim == 1 or values.shape[1] == 3)
        ):
            addAttribute(mesh, name, values)
    if len(triangles) and 'uv' in fields:
        layer = mesh.uv_layers.get('UVMap') or mesh.uv_layers.new(name='UVMap')
        layer.data.foreach_set('uv', fields['uv'][triangles].astype(np.float32).ravel())
    if len(triangles) and 'normal' in fields and hasattr(mesh, 'normals_split_custom_set_from_vertices'):
        if bpy.app.version < (4, 1):
            mesh.use_auto_smooth = True
        mesh.normals_split_custom_set_from_vertices(np.asarray(fields['normal'], np.float32))


def show(thing, scene):
    """Gives an object the geometry of the scene's frame. Reads no file if it already has it."""
    files = json.loads(thing[FILES])
    number = min(max(scene.frame_current - thing[START], 0), len(files) - 1)
    rate = thing[SPACING] * scene.render.fps / scene.render.fps_base
    if thing.get(SHOWN) == number and thing.get(RATE) == rate:
        return
    path = bpy.path.abspath(files[number])
    if path.endswith('.ply'):
        others = json.loads(thing[PARTICLES])
        particles = bpy.path.abspath(others[number]) if number < len(others) else None
        vertices, triangles, fields = run_files.meshFields(path, particles)
    else:
        (vertices, fields), triangles = run_files.fieldsOf(path), []
    fill(thing.data, vertices, triangles, fields, rate)
    thing[SHOWN], thing[RATE] = number, rate


@persistent
def onFrame(scene, graph=None):
    for thing in scene.objects:
        if FILES in thing.keys() and thing.type == 'MESH':
            try:
                show(thing, scene)
            except (
                OSError,
                ValueError,
                KeyError,
                run_files.hdf.FormatError,
                run_files.ply.PlyError,
            ) as error:
                print(f'thaw: {thing.name}: {error}')


def addScript():
    """Stores a script in the .blend file, which enables the add-on where scripts may run."""
    script = bpy.data.texts.get(SCRIPT) or bpy.data.texts.new(SCRIPT)
    script.from_string(SCRIPT_TEXT.format(module=__package__))
    script.use_module = True


def add(name, files, particles, spacing, start):
    """Adds an object that shows one of the files at each frame from `start` on.

    spacing: simulated seconds between files.
    """
    thing = bpy.data.objects.new(name, bpy.data.meshes.new(name))
    thing[FILES], thing[PARTICLES] = json.dumps(files), json.dumps(particles)
    thing[START], thing[SPACING] = start, spacing
    bpy.context.collection.objects.link(thing)
    show(thing, bpy.context.scene)
    addScript()
    return thing


def relative(files):
    """Returns paths relative to the saved .blend file, so that both can be moved."""
    base = os.path.dirname(bpy.data.filepath)
    return [bpy.path.relpath(f) for f in files] if base else files


def register():
    bpy.app.handlers.frame_change_pre.append(onFrame)


def unregister():
    bpy.app.handlers.frame_change_pre.remove(onFrame)
