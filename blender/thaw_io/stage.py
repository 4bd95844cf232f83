# SPDX-License-Identifier: Apache-2.0
"""Lights, world and camera of a scene's pictures as Blender objects."""
import math

import bpy
import numpy as np
from mathutils import Matrix, Vector

from .units import colour, listOf, si, vector

# Colours of `thaw render`: a white surface in direct light and under an open sky, sky, and floor.
SUN_TINT, SKY_TINT = (0.88, 0.86, 0.82), (0.52, 0.54, 0.58)
SKY_LOW, SKY_TOP, FLOOR = '#cdd3da', '#e8ecf1', '#cececc'
SIZE = 0.14  # rad, angle that a light subtends


def floorColour(scene):
    """Returns the linear colour of planes without their own one."""
    return colour(scene.get('output', {}).get('background', FLOOR))


def addCamera(scene, points):
    """Adds the camera of the scene's pictures; without one, it is fitted to the points. Returns it."""
    given, film = scene.get('output', {}).get('camera'), bpy.context.scene
    camera = bpy.data.cameras.new('thaw camera')
    camera.sensor_fit = 'VERTICAL'
    if given:
        camera.angle = si(given.get('field_of_view', 0.6))
        eye, at = (Vector(vector(given.get(k, d))) for k, d in (('from', [1, -1, 1]), ('at', [0, 0, 0])))
    else:
        camera.angle = 0.5
        eye, at = fitted(points, film.render.resolution_x / film.render.resolution_y, camera.angle)
    thing = bpy.data.objects.new('thaw camera', camera)
    bpy.context.collection.objects.link(thing)
    thing.matrix_world = Matrix.Translation(eye) @ facing(eye - at)
    camera.clip_start = 0.01 * (at - eye).length
    film.camera = thing
    return thing


def facing(back):
    """Returns the rotation of cameras and lights, which look along -z, with y upward."""
    return back.to_track_quat('Z', 'Y').to_matrix().to_4x4()


def fitted(points, aspect, angle):
    """Returns position and target of a camera that sees all points but outliers, as `thaw export` does."""
    points = np.asarray(points, float)
    points = points[np.isfinite(points).all(axis=1)]
    if len(points) == 0:
        points = np.zeros((1, 3))
    cut = len(points) // 1000
    places = np.sort(points, axis=0)
    low, high = Vector(places[cut]), Vector(places[-1 - cut])
    at, half = (low + high) / 2, (high - low) / 2
    ahead = Vector((-0.45, 1, -0.38)).normalized()
    right = ahead.cross(Vector((0, 0, 1))).normalized()
    up = right.cross(ahead)
    tall = 0.92 * math.tan(0.5 * angle)
    away = 0.0
    for corner in range(8):
        c = Vector([half[a] * (1 if corner >> a & 1 else -1) for a in range(3)])
        z = c.dot(ahead)
        away = max(away, abs(c.dot(right)) / (tall * aspect) - z, abs(c.dot(up)) / tall - z)
    return at - (away or 1.0) * ahead, at


def sunDirection(output, camera):
    """Returns the direction to the sun: over the camera's left shoulder, if the scene has none."""
    if 'sun' in output:
        return Vector(vector(output['sun']))
    right, up, back = (camera.matrix_world.to_3x3().col[k].normalized() for k in range(3))
    level = Vector((-back.x, -back.y, 0))
    level = (level if level.length > 1e-3 else Vector((up.x, up.y, 0))).normalized()
    return -0.62 * right - 0.52 * level + Vector((0, 0, 0.95))


def addLights(scene, camera):
    """Adds the lights of the scene's pictures, or the sun that they have without lights."""
    output = scene.get('output', {})
    given = [
        (
            vector(o['direction']),
            colour(o.get('colour', '#ffffff')),
            o.get('strength', 1),
            o.get('size', SIZE),
        )
        for o in listOf(output.get('light', []))
    ]
    for k, (to, tint, strength, size) in enumerate(
        given or [(sunDirection(output, camera), (1, 1, 1), 1, SIZE)]
    ):
        name = f'thaw light {k + 1}' if given else 'thaw sun'
        light = bpy.data.lights.new(name, 'SUN')
        # White surfaces that reflect diffusely are as bright as in pictures: irradiance is pi times radiance.
        power = [float(strength) * c * t for c, t in zip(tint, SUN_TINT)]
        most = max(power)
        light.color = [p / most for p in power] if most > 0 else (1, 1, 1)
        light.energy, light.angle = math.pi * most, si(size)
        thing = bpy.data.objects.new(name, light)
        thing.matrix_world = facing(Vector(to))
        bpy.context.collection.objects.link(thing)


def addWorld(scene):
    """Makes the world: the camera sees the background of pictures, and `output.ambient` lights the scene."""
    output = scene.get('output', {})
    low = colour(output.get('background', SKY_LOW))
    top = colour(output.get('background_top', output.get('background', SKY_TOP)))
    world = bpy.data.worlds.new('thaw sky')
    world.color, world.use_nodes = low, True
    nodes, links = world.node_tree.nodes, world.node_tree.links
    nodes.clear()
    kinds = ('TexCoord', 'SeparateXYZ', 'MapRange', 'ValToRGB', 'Background', 'Background', 'LightPath')
    kinds += ('MixShader', 'OutputWorld')
    where, parts, height, ramp, seen, light, path, mix, out = (nodes.new('ShaderNode' + k) for k in kinds)
    height.interpolation_type = 'SMOOTHSTEP'
    height.inputs['From Min'].default_value, height.inputs['From Max'].default_value = -0.05, 0.55
    ends = ramp.color_ramp.elements
    ends[0].color, ends[1].color = (*low, 1), (*top, 1)
    light.inputs['Color'].default_value = (*SKY_TINT, 1)
    light.inputs['Strength'].default_value = float(output.get('ambient', 1))
    links.new(where.outputs['Generated'], parts.inputs[0])
    links.new(parts.outputs['Z'], height.inputs['Value'])
    links.new(height.outputs['Result'], ramp.inputs['Fac'])
    links.new(ramp.outputs['Color'], seen.inputs['Color'])
    links.new(path.outputs['Is Camera Ray'], mix.inputs[0])
    links.new(light.outputs[0], mix.inputs[1])
    links.new(seen.outputs[0], mix.inputs[2])
    links.new(mix.outputs[0], out.inputs['Surface'])
    bpy.context.scene.world = world
