# SPDX-License-Identifier: Apache-2.0
"""Blender add-on of thaw: imports runs, and writes objects as scenes."""
bl_info = {
    'name': 'thaw',
    'author': 'the authors of thaw',
    'version': (0, 2, 0),
    'blender': (3, 4, 0),
    'location': 'File > Import, File > Export',
    'description': 'Imports runs of the particle simulator thaw, and writes scenes for it',
    'category': 'Import-Export',
}

import bpy  # noqa: E402
from bpy.props import BoolProperty, EnumProperty, StringProperty  # noqa: E402
from bpy_extras.io_utils import ExportHelper  # noqa: E402

from . import exporter, importer, properties, sequence  # noqa: E402

KINDS = tuple((k, k.capitalize(), '') for k in ('automatic', 'surface', 'sheet', 'oriented', 'particles'))


class Preferences(bpy.types.AddonPreferences):
    bl_idname = __package__
    program: StringProperty(name='thaw program', subtype='FILE_PATH', description='Empty: the one on PATH')

    def draw(self, context):
        self.layout.prop(self, 'program')


def programOf(context):
    known = context.preferences.addons.get(__package__)
    return known.preferences.program if known else ''


class ImportRun(bpy.types.Operator):
    """Import a thaw run: its surface, sheets or particles over time, obstacles, camera and lights"""

    bl_idname, bl_label, bl_options = 'import_scene.thaw', 'Import thaw run', {'REGISTER', 'UNDO'}
    directory: StringProperty(subtype='DIR_PATH')
    what: EnumProperty(name='What', items=KINDS)
    field: StringProperty(
        name='Colour by', description='A field such as temperature; empty: colours of the scene'
    )
    setting: BoolProperty(name='Obstacles, camera, lights', default=True)

    def invoke(self, context, event):
        context.window_manager.fileselect_add(self)
        return {'RUNNING_MODAL'}

    def execute(self, context):
        try:
            thing, notes = importer.importRun(
                self.directory,
                what=self.what,
                field=self.field.strip(),
                program=programOf(context),
                setting=self.setting,
                start=context.scene.frame_start,
            )
        except importer.ERRORS as error:
            self.report({'ERROR'}, str(error))
            return {'CANCELLED'}
        for note in notes:
            self.report({'WARNING'}, note)
        context.view_layer.objects.active = thing
        return {'FINISHED'}


class ExportScene(bpy.types.Operator, ExportHelper):
    """Write the selected objects as a thaw scene, with a PLY file for each mesh"""

    bl_idname, bl_label = 'export_scene.thaw', 'Export thaw scene'
    filename_ext = '.toml'

    def execute(self, context):
        try:
            notes = exporter.SceneWriter(context, self.filepath).write(context.selected_objects)
        except (exporter.ExportError, OSError) as error:
            self.report({'ERROR'}, str(error))
            return {'CANCELLED'}
        for note in notes:
            self.report({'WARNING'}, note)
        return {'FINISHED'}


def importEntry(menu, context):
    menu.layout.operator(ImportRun.bl_idname, text='thaw run (folder)')


def exportEntry(menu, context):
    menu.layout.operator(ExportScene.bl_idname, text='thaw scene (.toml)')


CLASSES = (Preferences, ImportRun, ExportScene)


def register():
    for one in CLASSES:
        bpy.utils.register_class(one)
    properties.register()
    sequence.register()
    bpy.types.TOPBAR_MT_file_import.append(importEntry)
    bpy.types.TOPBAR_MT_file_export.append(exportEntry)


def unregister():
    bpy.types.TOPBAR_MT_file_import.remove(importEntry)
    bpy.types.TOPBAR_MT_file_export.remove(exportEntry)
    sequence.unregister()
    properties.unregister()
    for one in reversed(CLASSES):
        bpy.utils.unregister_class(one)
