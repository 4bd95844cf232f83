# SPDX-License-Identifier: Apache-2.0
"""Settings of Blender objects, materials and scenes for thaw."""
import bpy
from bpy.props import EnumProperty, FloatProperty, PointerProperty, StringProperty

ROLES = (
    ('BODY', 'Body', 'A closed mesh of solid or liquid material'),
    ('OBSTACLE', 'Obstacle', 'A closed mesh that particles cannot enter'),
    ('EMITTER', 'Emitter', 'A plane or disc that emits along its local z axis'),
    ('DOMAIN', 'Domain', 'Its bounding box is the simulated box'),
    ('NONE', 'None', 'Not written'),
)
HEAT_CAPACITY = '2 kJ/(kg K)'  # written for a material that melts if its field is empty
# Property, key of the scene, default, meaning.
QUANTITIES = (
    ('density', 'density', '1000 kg/m^3', 'Density at rest'),
    ('young', 'young', '', "Young's modulus; empty: a liquid"),
    ('viscosity', 'viscosity', '', 'Viscosity of the liquid, such as 2 Pa s'),
    ('sound_speed', 'sound_speed', '', 'About ten times the fastest flow, such as 20 m/s; empty: automatic'),
    ('surface_tension', 'surface_tension', '', 'Surface tension, such as 0.03 N/m'),
    ('melts', 'melts', '', 'Melting temperature, or solidus and liquidus: 40 degC, 60 degC; empty: none'),
    ('heat_capacity', 'heat_capacity', '', f'Heat capacity; empty: {HEAT_CAPACITY} if the material melts'),
    ('latent_heat', 'latent_heat', '', 'Latent heat of melting, such as 30 kJ/kg'),
    ('conductivity', 'conductivity', '', 'Heat conductivity, such as 0.25 W/(m K)'),
)


class ThawObject(bpy.types.PropertyGroup):
    role: EnumProperty(name='Role', items=ROLES, default='BODY')
    temperature: StringProperty(name='Temperature', description='Such as 20 degC; empty: default')
    speed: FloatProperty(name='Speed', description='Of an emitter, m/s', default=1, min=1e-6)


class ThawScene(bpy.types.PropertyGroup):
    spacing: StringProperty(name='Spacing', description='Particle spacing', default='1 cm')
    end: StringProperty(name='End', description='Simulated time', default='2 s')
    every: StringProperty(name='Frame every', description='Simulated time between frames', default='40 ms')


ThawMaterial = type(
    'ThawMaterial',
    (bpy.types.PropertyGroup,),
    {
        '__annotations__': {
            name: StringProperty(name=name.replace('_', ' ').capitalize(), description=about, default=default)
            for name, _, default, about in QUANTITIES
        }
    },
)


class ObjectPanel(bpy.types.Panel):
    bl_idname, bl_label = 'THAW_PT_object', 'thaw'
    bl_space_type, bl_region_type, bl_context = 'PROPERTIES', 'WINDOW', 'object'

    def draw(self, context):
        settings = context.object.thaw
        for name in ('role', 'temperature') + (('speed',) if settings.role == 'EMITTER' else ()):
            self.layout.prop(settings, name)


class MaterialPanel(bpy.types.Panel):
    bl_idname, bl_label = 'THAW_PT_material', 'thaw'
    bl_space_type, bl_region_type, bl_context = 'PROPERTIES', 'WINDOW', 'material'

    @classmethod
    def poll(cls, context):
        return context.material is not None

    def draw(self, context):
        settings = context.material.thaw
        for name, *_ in QUANTITIES:
            self.layout.prop(settings, name)
        if settings.melts.strip() and not settings.young.strip():
            self.layout.label(text='Melts needs Young', icon='ERROR')
        if settings.melts.strip() and not settings.heat_capacity.strip():
            self.layout.label(text=f'Heat capacity: {HEAT_CAPACITY}', icon='INFO')
        if settings.latent_heat.strip() and not settings.melts.strip():
            self.layout.label(text='Latent heat needs Melts', icon='ERROR')


class ScenePanel(bpy.types.Panel):
    bl_idname, bl_label = 'THAW_PT_scene', 'thaw'
    bl_space_type, bl_region_type, bl_context = 'PROPERTIES', 'WINDOW', 'scene'

    def draw(self, context):
        for name in ('spacing', 'end', 'every'):
            self.layout.prop(context.scene.thaw, name)


CLASSES = (ThawObject, ThawScene, ThawMaterial, ObjectPanel, MaterialPanel, ScenePanel)


def register():
    for one in CLASSES:
        bpy.utils.register_class(one)
    bpy.types.Object.thaw = PointerProperty(type=ThawObject)
    bpy.types.Scene.thaw = PointerProperty(type=ThawScene)
    bpy.types.Material.thaw = PointerProperty(type=ThawMaterial)


def unregister():
    del bpy.types.Object.thaw, bpy.types.Scene.thaw, bpy.types.Material.thaw
    for one in reversed(CLASSES):
        bpy.utils.unregister_class(one)
