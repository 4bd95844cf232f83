# SPDX-License-Identifier: Apache-2.0
"""Imports exported files in Blender: blender --background --python read_blender.py -- PLY OBJ VDB

PLY and OBJ have the same ball of 5 cm. VDB may be absent.
"""
import sys

import bpy

ply, obj, *volumes = sys.argv[sys.argv.index("--") + 1 :]


def fresh():
    bpy.ops.wm.read_factory_settings(use_empty=True)


def ball(things):
    """Returns the number of vertices of all meshes, and checks their size and place."""
    places = [thing.matrix_world @ v.co for thing in things for v in thing.data.vertices]
    low = [min(p[a] for p in places) for a in range(3)]
    high = [max(p[a] for p in places) for a in range(3)]
    assert all(0.09 < high[a] - low[a] < 0.13 for a in range(3)), (low, high)
    assert -0.01 < low[2] < 0.02, "z is not up"
    for thing in things:
        assert not thing.data.validate(), "the mesh is invalid"
    return len(places), sum(len(thing.data.polygons) for thing in things)


def imported(operator, **arguments):
    fresh()
    assert operator(**arguments) == {"FINISHED"}
    return [o for o in bpy.context.scene.objects if o.type == "MESH"]


bpy.ops.preferences.addon_enable(module="io_mesh_ply")
fresh()
plain = ball(imported(bpy.ops.import_mesh.ply, filepath=ply))
# thaw writes scene coordinates: z is up
other = ball(imported(bpy.ops.wm.obj_import, filepath=obj, forward_axis="Y", up_axis="Z"))
assert plain == other, (plain, other)
for path in volumes:
    fresh()
    assert bpy.ops.object.volume_import(filepath=path) == {"FINISHED"}
    grids = bpy.context.object.data.grids
    assert grids.load() and not grids.error_message, grids.error_message
    found = {g.name: g.data_type for g in grids}
    assert found == {
        "surface": "FLOAT",
        "density": "FLOAT",
        "temperature": "FLOAT",
        "liquid": "FLOAT",
        "velocity": "VECTOR_FLOAT",
        "points": "POINTS",
    }, found
print("Blender reads all files")
