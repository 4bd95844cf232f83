# SPDX-License-Identifier: Apache-2.0
"""Imports a run: surface, sheets, oriented bodies or particles over time, obstacles, camera, lights."""
import math
import os

import bpy

from . import hdf, looks, obstacles, ply, run_files, sequence, stage
from .units import si


def importRun(folder, *, what='automatic', field='', program='', setting=True, start=1):
    """Adds the objects of a run. Returns the imported object and a list of notes. Raises RunError.

    what: automatic, surface, sheet, oriented, particles. field: for the colours of the material; empty:
    colours of the scene. setting: also adds obstacles, camera, lights and world, and sets the frame range
    and the frames per second.
    """
    run = run_files.Run(folder)
    kind = run.first() if what == 'automatic' else what
    if kind not in run.frames:
        raise run_files.RunError(f'{folder}: has no frames of {kind}; it has {", ".join(sorted(run.frames))}')
    times, scene = run.times(), run.scene()
    film = bpy.context.scene
    spacing, equal = spacingOf(times)
    frames = run.frames[kind]
    # Frames at the same time have the same number.
    particles = {numberOf(f): f for f in run.frames.get('particles', [])}
    files = frames if kind == 'particles' else run.meshes(kind, program)
    others = [particles.get(numberOf(f), '') for f in frames]
    if kind != 'surface':
        others = frames  # vertices of sheets and oriented bodies have fields of their own
    others = others if all(others) else []
    name = os.path.basename(run.folder)
    thing = sequence.add(
        f'{name} {kind}', sequence.relative(files), sequence.relative(others), spacing, start
    )
    dress(thing, kind, scene, field)
    notes = []
    if setting:
        film.frame_start, film.frame_end = start, start + len(frames) - 1
        notes = setPlayback(film, spacing, equal)
        sequence.show(thing, film)
        notes += addSetting(
            scene,
            lambda time: start + (time - times[0]) / (spacing or 1),
            obstacles.Meshes(lambda: run.obstacleMeshes(program), times[0]),
            run_files.fieldsOf(frames[0])[0],
        )
    return thing, notes


def spacingOf(times):
    """Returns the typical time between frames, s, and whether all but the last have it."""
    gaps = sorted(b - a for a, b in zip(times, times[1:]))
    if not gaps:
        return 0.0, False
    spacing = gaps[len(gaps) // 2]
    inner = list(zip(times, times[1:]))[: max(1, len(times) - 2)]
    return spacing, all(abs(b - a - spacing) <= 0.01 * spacing for a, b in inner)


def setPlayback(film, spacing, equal):
    """Sets the frames per second to real time, from 5 to 240. Returns notes."""
    render = film.render
    known = f'{render.fps / render.fps_base:.4g} frames per second'
    if not equal:
        return [f'the times of the frames are not equally spaced: they play at {known}']
    rate = 1 / spacing
    if not 5 <= rate <= 240:
        return [f'the run has {rate:.4g} frames per second: they play at {known}, not in real time']
    whole = round(rate)
    if abs(rate - whole) < 1e-3 * rate:
        render.fps, render.fps_base = whole, 1
    else:
        render.fps = math.ceil(rate)
        render.fps_base = render.fps / rate
    return []


def numberOf(path):
    return os.path.splitext(path)[0].rsplit('_', 1)[1]


def dress(thing, kind, scene, field):
    attributes = thing.data.attributes
    if kind == 'particles' and not field:
        field = next((f for f in ('temperature', 'velocity') if f in attributes), '')
    low, high = limits(thing, field)
    material = looks.surface(thing.name, attributes, field, low, high)
    if kind == 'particles':
        looks.spheres(thing, 0.6 * si(scene.get('spacing', 0.01)), material)
    else:
        thing.data.materials.append(material)


def limits(thing, field):
    """Returns the lowest and highest value of a field in the first and the last frame."""
    if not field:
        return 0.0, 1.0
    import json

    import numpy as np

    values = []
    files = json.loads(thing[sequence.FILES])
    others = json.loads(thing[sequence.PARTICLES])
    for path in {files[0], files[-1]}:
        k = files.index(path)
        path = bpy.path.abspath(path)
        if path.endswith('.ply'):
            fields = run_files.meshFields(path, bpy.path.abspath(others[k]) if others else None)[2]
        else:
            fields = run_files.fieldsOf(path)[1]
        if field in fields and len(fields[field]):
            v = np.asarray(fields[field], float)
            # Materials convert a vector to the mean of its components.
            values += [v.min(), v.max()] if v.ndim == 1 else [v.mean(axis=1).min(), v.mean(axis=1).max()]
    return (float(min(values)), float(max(values))) if values else (0.0, 1.0)


def addSetting(scene, frameOf, meshes, points):
    """Adds obstacles, camera, lights and world. points: positions of the first frame. Returns notes."""
    notes = []
    if not scene:
        notes.append(
            'obstacles, camera and lights are not imported: they need Python 3.11, as in Blender 4.1'
        )
    try:
        left = obstacles.addObstacles(scene, frameOf, meshes)
        notes += [
            f'obstacle {name} is not imported: its mesh needs the program thaw (preferences of the add-on)'
            for name in left
        ]
    except ValueError as error:
        notes.append(str(error))
    try:
        stage.addLights(scene, stage.addCamera(scene, points))
        stage.addWorld(scene)
    except ValueError as error:
        notes.append(str(error))
    return notes


ERRORS = (run_files.RunError, hdf.FormatError, ply.PlyError, OSError)
