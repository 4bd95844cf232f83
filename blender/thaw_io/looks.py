# SPDX-License-Identifier: Apache-2.0
"""Materials that show colours or fields, and spheres for particles."""
import bpy

# Ember, the map of `thaw render`: position, red, green, blue.
EMBER = ((0, 0.07, 0.04, 0.32), (0.25, 0.34, 0.03, 0.48), (0.5, 0.89, 0.08, 0.15), (0.75, 1, 0.34, 0.05))
EMBER += ((1, 0.95, 0.79, 0.1),)


def surface(name, attributes, field='', low=0.0, high=1.0):
    """Returns a material that shows the colours of the scene, or a field between two values."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    shader = next(node for node in nodes if node.type == 'BSDF_PRINCIPLED')
    shader.inputs['Roughness'].default_value = 0.35
    source = nodes.new('ShaderNodeAttribute')
    if field and field in attributes:
        source.attribute_name = field
        scale, ramp = nodes.new('ShaderNodeMapRange'), nodes.new('ShaderNodeValToRGB')
        scale.inputs['From Min'].default_value, scale.inputs['From Max'].default_value = low, high
        for k, (place, *rgb) in enumerate(EMBER):
            ends = ramp.color_ramp.elements
            end = ends[0] if k == 0 else ends[-1] if k == len(EMBER) - 1 else ends.new(place)
            end.position, end.color = place, (*rgb, 1)
        links.new(source.outputs['Fac'], scale.inputs['Value'])
        links.new(scale.outputs['Result'], ramp.inputs['Fac'])
        links.new(ramp.outputs['Color'], shader.inputs['Base Color'])
    elif 'Col' in attributes:
        source.attribute_name = 'Col'
        links.new(source.outputs['Color'], shader.inputs['Base Color'])
    else:
        nodes.remove(source)
        shader.inputs['Base Color'].default_value = (0.35, 0.5, 0.7, 1)
    return material


def plain(name, rgb, roughness):
    """Returns a material of one linear colour, its shader and its node tree."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    shader = next(node for node in material.node_tree.nodes if node.type == 'BSDF_PRINCIPLED')
    shader.inputs['Base Color'].default_value = (*rgb, 1)
    shader.inputs['Roughness'].default_value = roughness
    material.diffuse_color = (*rgb, 1)
    return material, shader, material.node_tree


def solid(name, rgb):
    return plain(name, rgb, 0.6)[0]


def glass(name, rgb):
    """Returns glass of a linear colour. Shadow rays pass it, since Cycles has no sharp caustics."""
    # Light through a vessel passes four faces.
    one = [c**0.25 for c in rgb]
    material, shader, tree = plain(name, one, 0.0)
    parts = shader.inputs
    parts['Transmission' if 'Transmission' in parts else 'Transmission Weight'].default_value = 1
    parts['IOR'].default_value = 1.45
    out = next(node for node in tree.nodes if node.type == 'OUTPUT_MATERIAL')
    kinds = ('LightPath', 'BsdfTransparent', 'MixShader')
    path, clear, mix = (tree.nodes.new('ShaderNode' + kind) for kind in kinds)
    clear.inputs['Color'].default_value = (*(0.92 * c for c in one), 1)
    tree.links.new(path.outputs['Is Shadow Ray'], mix.inputs[0])
    tree.links.new(shader.outputs[0], mix.inputs[1])
    tree.links.new(clear.outputs[0], mix.inputs[2])
    tree.links.new(mix.outputs[0], out.inputs['Surface'])
    if hasattr(material, 'use_screen_refraction'):  # Eevee before Blender 4.2
        material.use_screen_refraction, material.shadow_method = True, 'HASHED'
    material.diffuse_color = (*rgb, 0.25)
    return material


def spheres(thing, radius, material):
    """Adds geometry nodes that draw vertices as spheres, which are exact in Cycles."""
    group = bpy.data.node_groups.new('thaw particles', 'GeometryNodeTree')
    if hasattr(group, 'interface'):
        group.interface.new_socket('Geometry', in_out='INPUT', socket_type='NodeSocketGeometry')
        group.interface.new_socket('Geometry', in_out='OUTPUT', socket_type='NodeSocketGeometry')
    else:
        group.inputs.new('NodeSocketGeometry', 'Geometry')
        group.outputs.new('NodeSocketGeometry', 'Geometry')
    kinds = ('NodeGroupInput', 'GeometryNodeMeshToPoints', 'GeometryNodeSetMaterial', 'NodeGroupOutput')
    first, points, paint, last = (group.nodes.new(kind) for kind in kinds)
    points.inputs['Radius'].default_value = radius
    paint.inputs['Material'].default_value = material
    for a, b in ((first, points), (points, paint), (paint, last)):
        group.links.new(a.outputs[0], b.inputs[0])
    thing.modifiers.new('thaw particles', 'NODES').node_group = group
