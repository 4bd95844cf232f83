# SPDX-License-Identifier: Apache-2.0
"""Obstacles of a scene as Blender objects."""
import math

import bmesh
import bpy
from mathutils import Euler, Matrix, Vector

from . import looks, stage
from .units import colour, listOf, si, vector

GREY = '#bcc1c8'  # solid obstacles without a colour
PLANE = 4.0  # m, edge of a plane's square, over the extent of the domain


def shapeMesh(name, shape, extent):
    """Returns the mesh of a shape around its own origin, or None if it is not supported."""
    mesh, work = bpy.data.meshes.new(name), bmesh.new()
    if 'box' in shape:
        size = vector(shape['box'].get('size', [1, 1, 1]))
        bmesh.ops.create_cube(work, size=1, matrix=Matrix.Diagonal((*size, 1)))
    elif 'sphere' in shape:
        bmesh.ops.create_uvsphere(
            work, u_segments=48, v_segments=24, radius=si(shape['sphere'].get('radius', 0.5))
        )
    elif 'cylinder' in shape:
        radius, height = (si(shape['cylinder'].get(k, d)) for k, d in (('radius', 0.5), ('height', 1)))
        bmesh.ops.create_cone(work, cap_ends=True, segments=64, radius1=radius, radius2=radius, depth=height)
    elif 'plane' in shape:
        bmesh.ops.create_grid(work, x_segments=1, y_segments=1, size=PLANE * extent / 2)
    elif 'torus' in shape:
        spinRing(work, *(si(shape['torus'].get(k, d)) for k, d in (('radius', 0.5), ('tube', 0.1))))
    elif 'glass' in shape:
        spinGlass(work, *(si(shape['glass'].get(k, d)) for k, d in GLASS))
    else:
        work.free()
        return None
    work.to_mesh(mesh)
    work.free()
    smoothFaces(mesh)
    return mesh


def smoothFaces(mesh):
    """Shades curved faces smooth, and keeps edges sharper than 30 degrees."""
    for face in mesh.polygons:
        face.use_smooth = True
    if hasattr(mesh, 'set_sharp_from_angle'):  # Blender 4.1 and later
        mesh.set_sharp_from_angle(angle=math.radians(30))
    else:
        mesh.use_auto_smooth, mesh.auto_smooth_angle = True, math.radians(30)


GLASS = (('radius', 0.5), ('height', 1), ('thickness', 0.01))


def spin(work, profile, closed):
    """Rotates a profile of (distance from the z axis, z) about the z axis."""
    vertices = [work.verts.new((r, 0, z)) for r, z in profile]
    edges = [work.edges.new(pair) for pair in zip(vertices, vertices[1:] + (vertices[:1] if closed else []))]
    edges = edges if closed else edges[: len(vertices) - 1]
    bmesh.ops.spin(
        work,
        geom=vertices + edges,
        axis=(0, 0, 1),
        cent=(0, 0, 0),
        steps=64,
        angle=2 * math.pi,
        use_merge=True,
    )
    bmesh.ops.remove_doubles(work, verts=work.verts, dist=1e-7)
    bmesh.ops.recalc_face_normals(work, faces=work.faces)


def spinRing(work, radius, tube):
    turns = [2 * math.pi * k / 24 for k in range(24)]
    spin(work, [(radius + tube * math.cos(a), tube * math.sin(a)) for a in turns], True)


def spinGlass(work, radius, height, thickness):
    inner = radius - thickness
    spin(
        work,
        [(0, 0), (radius, 0), (radius, height), (inner, height), (inner, thickness), (0, thickness)],
        False,
    )


def placeOf(shape, mesh):
    """Returns the matrix of `place`: scaled, rotated about x, y and z, then moved."""
    place = shape.get('place', {})
    turns = [si(place.get('rotate_' + axis, 0)) for axis in 'xyz']
    turn = Euler(turns, 'XYZ').to_matrix().to_4x4()
    points = [turn @ v.co for v in mesh.vertices] or [Vector()]
    low, high = (Vector([f(p[a] for p in points) for a in range(3)]) for f in (min, max))
    scale = si(place.get('scale', 1))
    if 'height' in place:
        scale = si(place['height']) / (high.z - low.z)
    to = Vector(vector(place.get('move', [0, 0, 0])))
    if 'bottom' in place:
        middle = (low + high) / 2
        to = Vector(vector(place['bottom'])) - scale * Vector((middle.x, middle.y, low.z))
    if 'plane' in shape:
        plane = shape['plane']
        normal = Vector(vector(plane.get('normal', [0, 0, 1])))
        turn = turn @ normal.to_track_quat('Z', 'Y').to_matrix().to_4x4()
        to = to + Vector(vector(plane.get('point', [0, 0, 0])))
    return Matrix.Translation(to) @ turn @ Matrix.Scale(scale, 4)


def addKeyframes(thing, motion, frameOf):
    """Keyframes of a motion: rotations about the origin, then displacements."""
    rest = thing.matrix_world.copy()
    thing.rotation_mode = 'QUATERNION'
    for key in motion:
        turn = Euler(vector(key.get('rotate', [0, 0, 0])), 'XYZ').to_matrix().to_4x4()
        thing.matrix_world = Matrix.Translation(vector(key.get('move', [0, 0, 0]))) @ turn @ rest
        for path in ('location', 'rotation_quaternion'):
            thing.keyframe_insert(path, frame=frameOf(si(key.get('time', 0))))
    curves = thing.animation_data.action.fcurves if thing.animation_data else []
    for curve in curves:
        for point in curve.keyframe_points:
            point.interpolation = 'LINEAR'


class Meshes:
    """Meshes of obstacles that are no simple shapes, in the positions of a time (s). They are read once."""

    def __init__(self, read, time):
        self.read, self.time, self.parts = read, time, None

    def atRest(self, name, motion):
        """Returns the mesh of an obstacle before its motion, or None."""
        self.parts = self.read() if self.parts is None else self.parts
        if name not in self.parts:
            return None
        vertices, triangles = self.parts[name]
        back = poseAt(motion, self.time).inverted()
        mesh = bpy.data.meshes.new(name)
        mesh.from_pydata([back @ Vector(v) for v in vertices.tolist()], [], triangles.tolist())
        mesh.update()
        smoothFaces(mesh)
        return mesh


def poseAt(motion, time):
    """Returns the matrix of a motion at a time: linear between the keys."""
    keys = sorted((si(k.get('time', 0)), k) for k in motion) if motion else []
    if not keys:
        return Matrix.Identity(4)
    times = [t for t, _ in keys]
    after = next((k for k, t in enumerate(times) if t > time), len(times))
    pair = [keys[max(0, after - 1)][1], keys[min(after, len(keys) - 1)][1]]
    first, last = times[max(0, after - 1)], times[min(after, len(keys) - 1)]
    share = (time - first) / (last - first) if last > first else 0
    move = [Vector(vector(k.get('move', [0, 0, 0]))) for k in pair]
    turn = [Vector(vector(k.get('rotate', [0, 0, 0]))) for k in pair]
    turned = Euler(turn[0].lerp(turn[1], share), 'XYZ').to_matrix().to_4x4()
    return Matrix.Translation(move[0].lerp(move[1], share)) @ turned


def addObstacles(scene, frameOf, meshes):
    """Adds the obstacles of a scene. Returns the names of those without a mesh."""
    domain = scene.get('domain', {})
    low, high = vector(domain.get('min', [-1, -1, -1])), vector(domain.get('max', [1, 1, 1]))
    extent, left = max(b - a for a, b in zip(low, high)), []
    given = [o for key in ('obstacle', 'wall') for o in listOf(scene.get(key, []))]
    for k, shape in enumerate(given):
        name = shape.get('name', f'obstacle {k}')
        mesh, place = shapeMesh(name, shape, extent), None
        if mesh is None:
            motion = listOf(shape.get('motion', []))
            mesh, place = meshes.atRest(shape.get('name', f'obstacle_{k}'), motion), Matrix.Identity(4)
        if mesh is None:
            left.append(name)
            continue
        thing = bpy.data.objects.new(name, mesh)
        mesh.materials.append(materialOf(name, shape, scene))
        bpy.context.collection.objects.link(thing)
        thing.matrix_world = placeOf(shape, mesh) if place is None else place
        if shape.get('motion'):
            addKeyframes(thing, listOf(shape['motion']), frameOf)
        if shape.get('until', 'never') != 'never':
            hideFrom(thing, frameOf(si(shape['until'])))
    return left


def materialOf(name, shape, scene):
    """Returns the material of an obstacle. A plane is a floor in pictures, and never glass."""
    isPlane = 'plane' in shape
    own = colour(shape['colour']) if 'colour' in shape else None
    if shape.get('look', 'glass') == 'glass' and not isPlane:
        return looks.glass(name, own or (1, 1, 1))
    return looks.solid(name, own or (stage.floorColour(scene) if isPlane else colour(GREY)))


def hideFrom(thing, frame):
    """Hides an object from the first whole frame that is not before `frame`."""
    first = math.ceil(frame - 1e-6)
    for hidden, at in ((False, first - 1), (True, first)):
        thing.hide_render = thing.hide_viewport = hidden
        for path in ('hide_render', 'hide_viewport'):
            thing.keyframe_insert(path, frame=at)
