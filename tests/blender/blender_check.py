# SPDX-License-Identifier: Apache-2.0
"""Checks the add-on inside of Blender: blender --background --python blender_check.py -- ZIP RUN FOLDER

RUN has a surface that falls and melts, and a plate. Writes pictures and a scene into FOLDER.
"""
import math
import os
import sys

import bpy
import numpy as np
from bpy_extras.object_utils import world_to_camera_view as seenAt
from mathutils import Vector

ZIP, RUN, FOLDER = sys.argv[sys.argv.index('--') + 1 :]


def fresh():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.preferences.addon_enable(module='thaw_io')


def values(mesh, name, size):
    data = mesh.attributes[name].data
    out = np.zeros(len(data) * size, np.float32)
    data.foreach_get({1: 'value', 3: 'vector', 4: 'color'}[size], out)
    return out.reshape(-1, size)


def render(name, blur):
    """Returns the rows of a small picture from below."""
    scene = bpy.context.scene
    scene.render.engine = 'CYCLES'
    scene.cycles.samples, scene.cycles.use_denoising, scene.cycles.seed = 8, False, 1
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = 160, 120, 100
    scene.render.use_motion_blur, scene.render.motion_blur_shutter = blur, 1.0
    scene.render.filepath = os.path.join(FOLDER, name)
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(scene.render.filepath)
    pixels = np.array(image.pixels[:]).reshape(120, 160, 4)[..., :3]
    return pixels


def checkSurface():
    fresh()
    assert bpy.ops.import_scene.thaw(directory=RUN) == {'FINISHED'}
    scene, thing = bpy.context.scene, bpy.context.view_layer.objects.active
    frames = scene.frame_end - scene.frame_start + 1
    assert frames >= 3 and len(thing.data.polygons) > 500, (frames, len(thing.data.polygons))
    assert {'Col', 'velocity', 'temperature', 'liquid'} <= set(thing.data.attributes.keys())
    assert not thing.data.validate(), 'the mesh is invalid'
    plate, camera = bpy.data.objects['plate'], scene.camera
    assert abs(plate.matrix_world.translation.z) < 1e-6 and plate.dimensions.z < 1e-6
    assert camera and abs(camera.data.angle - math.radians(32)) < 1e-3
    ahead = -camera.matrix_world.to_3x3().col[2]
    to = np.array([0, 0, 0.13]) - np.array(camera.matrix_world.translation)
    assert np.dot(ahead, to / np.linalg.norm(to)) > 0.9999

    def height():
        out = np.zeros(3 * len(thing.data.vertices), np.float32)
        thing.data.vertices.foreach_get('co', out)
        return out.reshape(-1, 3)[:, 2]

    first = height()
    scene.frame_set(3)
    assert height().min() < first.min() - 0.001, 'the surface does not fall'
    # Frames of the run are 50 ms apart, and the film plays in real time.
    assert (scene.render.fps, scene.render.fps_base) == (20, 1), (scene.render.fps, scene.render.fps_base)
    speed = values(thing.data, 'velocity', 3)
    assert (speed[:, 2].mean() < 0) and 0.1 < abs(speed[:, 2].mean()) < 5
    # Faster playback lengthens the blur: the upper half of the picture, where the bust falls, has soft edges.
    sharp, soft = render('sharp.png', False), render('blurred.png', True)
    assert sharp.std() > 0.015, sharp.std()
    edge = lambda p: np.abs(np.diff(p[60:].mean(axis=2), axis=0)).max()  # noqa: E731
    assert np.abs(sharp - soft).max() > 0.1 and edge(soft) < edge(sharp), (edge(soft), edge(sharp))
    # Velocities follow the frames per second.
    scene.render.fps = 40
    scene.frame_set(3)
    assert np.allclose(values(thing.data, 'velocity', 3), 2 * speed), 'not the frames per second'
    scene.render.fps = 20
    scene.frame_set(3)
    # The handler works after saving and loading.
    bpy.ops.wm.save_as_mainfile(filepath=os.path.join(FOLDER, 'film.blend'))
    bpy.ops.wm.open_mainfile(filepath=os.path.join(FOLDER, 'film.blend'))
    thing = bpy.context.view_layer.objects.active
    before = len(thing.data.vertices)
    bpy.context.scene.frame_set(1)
    assert len(thing.data.vertices) != before, 'the handler is lost with the file'


def checkPlayback():
    fresh()
    from thaw_io import importer

    film = bpy.context.scene

    def played(times):
        film.render.fps, film.render.fps_base = 24, 1
        notes = importer.setPlayback(film, *importer.spacingOf(times))
        return film.render.fps, film.render.fps_base, len(notes)

    assert played([0, 0.04, 0.08, 0.12]) == (25, 1, 0)
    assert played([0, 0.04, 0.08, 0.1]) == (25, 1, 0), 'the last frame at the end of the run'
    fps, base, notes = played([0, 0.08, 0.16])
    assert abs(fps / base - 12.5) < 1e-4 and notes == 0, (fps, base)
    for times in ([0, 0.04, 0.1, 0.12], [0, 1e-3, 2e-3], [0, 1, 2], [0]):
        assert played(times) == (24, 1, 1), times


def checkParticles():
    fresh()
    assert bpy.ops.import_scene.thaw(directory=RUN, what='particles', field='temperature') == {'FINISHED'}
    thing = bpy.context.view_layer.objects.active
    points = thing.evaluated_get(bpy.context.evaluated_depsgraph_get())
    assert len(thing.modifiers) == 1 and len(thing.data.vertices) > 100 and points
    assert render('particles.png', False).std() > 0.015


def checkMeshObstacles():
    """An obstacle that is a mesh has its place of the first frame, here in the middle of its motion."""
    fresh()
    from thaw_io import obstacles

    def turned(points, angle):
        c, s = math.cos(angle), math.sin(angle)
        return points @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])

    motion = [{'time': 0}, {'time': '1 s', 'move': ['1 m', 0, 0], 'rotate': [0, 0, 1]}]
    scene = {'obstacle': [{'name': 'rock', 'mesh': 'rock.obj', 'motion': motion}, {'mesh': 'lost.obj'}]}
    rest = np.array([[0.1, 0, 0], [0, 0.1, 0], [0, 0, 0.1], [0, 0, 0]])
    triangles = np.array([[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]])
    seen = turned(rest, 0.5) + (0.5, 0, 0)
    meshes = obstacles.Meshes(lambda: {'rock': (seen, triangles)}, 0.5)
    assert obstacles.addObstacles(scene, lambda time: 1 + 10 * time, meshes) == ['obstacle 1']
    rock = bpy.data.objects['rock']
    for frame, angle, move in ((1, 0, 0), (11, 1, 1)):
        bpy.context.scene.frame_set(frame)
        places = np.array([rock.matrix_world @ v.co for v in rock.data.vertices])
        assert np.abs(places - turned(rest, angle) - (move, 0, 0)).max() < 1e-5, (frame, places)


def shaderOf(name):
    [material] = bpy.data.objects[name].data.materials
    return next(node for node in material.node_tree.nodes if node.type == 'BSDF_PRINCIPLED').inputs


def isFacing(thing, to):
    return np.dot(thing.matrix_world.to_3x3().col[2], to / np.linalg.norm(to)) > 0.9999


def checkObstacleLooks():
    """Obstacles have look and colour of the scene, and disappear at `until`."""
    fresh()
    from thaw_io import obstacles

    box = {'box': {'size': ['1 m', '1 m', '1 m']}}
    given = [
        {'name': 'wood', 'look': 'solid', 'colour': '#ff0000', 'until': '0.25 s', **box},
        {'name': 'cup', 'colour': '#00ff00', 'motion': [{'time': 0}, {'time': 1, 'move': [1, 0, 0]}], **box},
        {'name': 'floor', 'plane': {}, 'until': 'never'},
    ]
    scene = {'obstacle': given, 'output': {'background': '#0000ff'}}
    assert not obstacles.addObstacles(scene, lambda time: 1 + 10 * time, None)
    colours = {
        name: tuple(shaderOf(name)['Base Color'].default_value)[:3] for name in ('wood', 'cup', 'floor')
    }
    assert colours == {'wood': (1, 0, 0), 'cup': (0, 1, 0), 'floor': (0, 0, 1)}, colours
    clear = {name: shaderOf(name)['Transmission'].default_value for name in ('wood', 'cup', 'floor')}
    assert clear == {'wood': 0, 'cup': 1, 'floor': 0}, clear
    # 0.25 s lies between the frames 3 and 4.
    for frame, hidden in ((1, False), (3, False), (4, True), (9, True), (2, False)):
        bpy.context.scene.frame_set(frame)
        wood, cup = bpy.data.objects['wood'], bpy.data.objects['cup']
        assert (wood.hide_render, wood.hide_viewport) == (hidden, hidden), frame
        assert not cup.hide_render, frame


def checkLights():
    """Lights, world and a fitted camera follow the scene; without lights there is the sun of pictures."""
    fresh()
    from thaw_io import importer

    lights = [
        {'direction': [1, -1, 1], 'strength': 0.5, 'colour': '#ff0000', 'size': '30 deg'},
        {'direction': [0, 0, 1]},
    ]
    output = {'light': lights, 'ambient': 0.25, 'background': '#0000ff', 'background_top': '#ff0000'}
    points = np.random.default_rng(1).uniform((-0.1, 2.9, 0), (0.1, 3.1, 0.4), (500, 3))
    bpy.context.scene.render.resolution_x, bpy.context.scene.render.resolution_y = 160, 120
    assert importer.addSetting({'output': output}, lambda time: 1, None, points) == []
    first, second = bpy.data.objects['thaw light 1'], bpy.data.objects['thaw light 2']
    assert isFacing(first, (1, -1, 1)) and isFacing(second, (0, 0, 1))
    assert np.allclose(first.data.color, (1, 0, 0)) and abs(first.data.angle - math.radians(30)) < 1e-5
    assert abs(first.data.energy / second.data.energy - 0.5) < 1e-5
    bpy.context.view_layer.update()
    film = bpy.context.scene
    seen = np.array([seenAt(film, film.camera, Vector(p)) for p in points])
    assert seen[:, :2].min() > 0 and seen[:, :2].max() < 1 and np.ptp(seen[:, :2], axis=0).max() > 0.6
    pixels = render('empty.png', False)
    assert pixels[..., 2].min() > 0.3 and pixels[..., 1].max() < 0.1, 'the background'
    fresh()
    assert importer.addSetting({'output': {'sun': [0, 1, 1]}}, lambda time: 1, None, points) == []
    [sun] = [thing for thing in bpy.context.scene.objects if thing.type == 'LIGHT']
    assert isFacing(sun, (0, 1, 1))


def checkRefusals():
    fresh()
    for arguments in ({'directory': FOLDER}, {'directory': RUN, 'what': 'sheet'}):
        try:
            bpy.ops.import_scene.thaw(**arguments)
        except RuntimeError as error:
            assert 'no f' in str(error), error  # "no frames/*.hdf", "no frames of sheet"
        else:
            raise AssertionError(f'{arguments} is accepted')


def add(operator, name, material, role, **arguments):
    operator(**arguments)
    thing = bpy.context.object
    thing.name, thing.thaw.role = name, role
    if material:
        thing.data.materials.append(material)
    return thing


def checkExport():
    fresh()
    wax = bpy.data.materials.new('my wax')
    wax.thaw.density, wax.thaw.young, wax.thaw.viscosity = '900 kg/m^3', '100 kPa', '2 Pa s'
    wax.thaw.melts, wax.thaw.heat_capacity, wax.thaw.latent_heat = (
        '40 degC, 60 degC',
        '2 kJ/(kg K)',
        '30 kJ/kg',
    )
    wax.thaw.conductivity, wax.thaw.sound_speed, wax.diffuse_color = '300 W/(m K)', '20 m/s', (1, 0, 0, 1)
    mesh = bpy.ops.mesh
    cube = add(
        mesh.primitive_cube_add, 'cube', wax, 'BODY', size=0.1, location=(0, 0, 0.2), rotation=(0.3, 0, 0)
    )
    cube.scale.x = -2  # mirrored: its faces are reversed
    cube.thaw.temperature = '20 degC'
    table = add(mesh.primitive_cube_add, 'table', None, 'OBSTACLE', size=0.4, location=(0, 0, -0.2))
    table.thaw.temperature = '200 degC'
    add(
        mesh.primitive_plane_add,
        'jug',
        wax,
        'EMITTER',
        size=0.06,
        location=(0.2, 0, 0.3),
        rotation=(math.pi, 0, 0),
    )
    add(mesh.primitive_cube_add, 'room', None, 'DOMAIN', size=1.2, location=(0, 0, 0.3))
    add(mesh.primitive_cube_add, 'helper', None, 'NONE')
    camera = bpy.data.objects.new('camera', bpy.data.cameras.new('camera'))
    camera.location, camera.rotation_euler = (0, -1, 0.3), (math.pi / 2, 0, 0)
    bpy.context.collection.objects.link(camera)
    bpy.context.scene.camera, bpy.context.scene.thaw.spacing = camera, '2 cm'
    bpy.ops.object.select_all(action='SELECT')
    bpy.context.view_layer.update()
    assert bpy.ops.export_scene.thaw(filepath=os.path.join(FOLDER, 'made.toml')) == {'FINISHED'}
    assert not os.path.exists(os.path.join(FOLDER, 'made_helper.ply'))
    # A material that melts is complete without a heat capacity. One that does not melt has no latent heat.
    wax.thaw.heat_capacity = ''
    assert bpy.ops.export_scene.thaw(filepath=os.path.join(FOLDER, 'melts.toml')) == {'FINISHED'}
    wax.thaw.young = ''
    try:
        bpy.ops.export_scene.thaw(filepath=os.path.join(FOLDER, 'liquid.toml'))
    except RuntimeError as error:
        assert "set its Young's modulus" in str(error), error
    else:
        raise AssertionError('a liquid that melts is accepted')
    wax.thaw.young, wax.thaw.melts = '100 kPa', ''
    assert bpy.ops.export_scene.thaw(filepath=os.path.join(FOLDER, 'solid.toml')) == {'FINISHED'}


os.makedirs(FOLDER, exist_ok=True)
bpy.ops.preferences.addon_install(filepath=ZIP)
try:
    checkSurface()
    checkPlayback()
    checkParticles()
    checkMeshObstacles()
    checkObstacleLooks()
    checkLights()
    checkRefusals()
    checkExport()
except BaseException:
    import traceback

    traceback.print_exc()
    sys.exit(1)
print('add-on: all passed')
