# SPDX-License-Identifier: Apache-2.0
"""Imports the run of film.toml into Blender and saves film.blend, ready to render.

    blender --background --python film.py      # beside out/film and the add-on, thaw_io.zip
"""
import os

import bpy

bpy.ops.preferences.addon_install(filepath=os.path.abspath("thaw_io.zip"))
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.preferences.addon_enable(module="thaw_io")
bpy.ops.import_scene.thaw(directory=os.path.abspath("out/film"))  # surface, obstacles, camera, sun
scene, surface = bpy.context.scene, bpy.context.object


def material(name, colour, roughness):
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    shader = made.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (*colour, 1)
    shader.inputs["Roughness"].default_value = roughness
    return made


# materials, linear colours
objects = bpy.data.objects
for thing, name, colour, roughness in (
    (surface, "chocolate", (0.10, 0.03, 0.01), 0.25),
    (objects["table"], "wood", (0.42, 0.27, 0.15), 0.5),
    (objects["bowl"], "china", (0.45, 0.5, 0.55), 0.2),
):
    thing.data.materials.clear()
    thing.data.materials.append(material(name, colour, roughness))
bpy.ops.mesh.primitive_plane_add(size=6, location=(0, 0, -0.281))
bpy.context.object.data.materials.append(material("floor", (0.35, 0.36, 0.38), 0.8))

# light: the sun casts shadows, the sky brightens them
sun = next(o for o in scene.objects if o.type == "LIGHT")
sun.data.energy, sun.rotation_euler = 3.2, (0.75, 0.1, 0.9)
scene.world = bpy.data.worlds.new("sky")
scene.world.color = (0.16, 0.19, 0.24)

# pictures with motion blur
scene.render.engine = "CYCLES"
scene.cycles.samples, scene.cycles.use_denoising = 16, False
scene.render.use_motion_blur = True
scene.view_settings.view_transform = "Standard"
scene.render.resolution_x, scene.render.resolution_y = 480, 360
scene.render.resolution_percentage = 100
scene.render.filepath = "//film/"
bpy.ops.wm.save_as_mainfile(filepath=os.path.abspath("film.blend"))
