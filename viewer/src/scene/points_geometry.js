// SPDX-License-Identifier: Apache-2.0
// Attributes of a packet's points, for instances (spheres, discs) or vertices (meshes).
import * as THREE from 'three';
import { LABELS, OWN, PLAIN, VALUES } from './shading.js';

/// Returns the attribute of an array of a packet, or one of zeros.
function attributeOf(array, rows, fallback, Attribute, normalised = false) {
  if (array) return new Attribute(array.data, array.components, normalised);
  return new Attribute(new fallback.type(rows * fallback.components), fallback.components, normalised);
}

/// Sets position, colours and, where the packet has them, normals and radii. Returns the source of colours.
export function setPoints(geometry, packet, instanced) {
  const Attribute = instanced ? THREE.InstancedBufferAttribute : THREE.BufferAttribute;
  const { position, normal, radius, colour, value, label } = packet.arrays;
  const rows = position.rows;
  geometry.setAttribute(instanced ? 'centre' : 'position', new Attribute(position.data, 3));
  if (normal) geometry.setAttribute('normal', new Attribute(normal.data, normal.components, true));
  if (radius) geometry.setAttribute('radius', new Attribute(radius.data, 1));
  geometry.setAttribute(
    'colour',
    attributeOf(colour, rows, { type: Uint8Array, components: 4 }, Attribute, true),
  );
  geometry.setAttribute('value', attributeOf(value, rows, { type: Float32Array, components: 1 }, Attribute));
  geometry.setAttribute('label', attributeOf(label, rows, { type: Uint32Array, components: 1 }, Attribute));
  if (value) return VALUES;
  if (label) return LABELS;
  return colour ? OWN : PLAIN;
}

/// Returns a geometry of one square for each instance.
export function squares() {
  const geometry = new THREE.InstancedBufferGeometry();
  geometry.setAttribute(
    'position',
    new THREE.BufferAttribute(new Float32Array([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]), 3),
  );
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  geometry.instanceCount = 0;
  return geometry;
}
