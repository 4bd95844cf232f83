// SPDX-License-Identifier: Apache-2.0
// Points of a packet as textures, from which a vertex shader reads those of its square: six vertices a point,
// without copies. Instances of such small meshes are slow on many graphics processors.
import * as THREE from 'three';
import { LABELS, OWN, PLAIN, VALUES } from './shading.js';

const WIDTH = 2048;

function textureOf(data, rows, type) {
  const texture = new THREE.DataTexture(data, WIDTH, rows, THREE.RGBAFormat, type);
  texture.needsUpdate = true;
  return texture;
}

const empty = textureOf(new Uint8Array(4 * WIDTH), 1, THREE.UnsignedByteType);

/// Uniforms of the textures.
export function textureUniforms() {
  return { points: { value: empty }, shapes: { value: empty }, ownColours: { value: empty } };
}

/// Reads a point in a vertex shader: readPoint() sets centre, normal, radius and the outputs of the colours.
export const readPoint = /* glsl */ `
uniform highp sampler2D points, shapes, ownColours;
uniform int source;
out vec3 ownColour;
out float ownValue;
flat out int number;
vec2 squareCorner() {
  int k = gl_VertexID % 6;
  return vec2(k == 1 || k == 2 || k == 4 ? 1.0 : -1.0, k == 2 || k == 4 || k == 5 ? 1.0 : -1.0);
}
vec3 readPoint(out vec3 normal, out float radius) {
  number = gl_VertexID / 6;
  ivec2 at = ivec2(number % ${WIDTH}, number / ${WIDTH});
  vec4 point = texelFetch(points, at, 0), shape = texelFetch(shapes, at, 0);
  ownColour = source == ${OWN} ? texelFetch(ownColours, at, 0).rgb : vec3(0.0);
  ownValue = point.w;
  normal = shape.xyz;
  radius = shape.w;
  return point.xyz;
}
`;

/// Returns values of a packet's points in fours, with room for whole rows of a texture.
function fours(packet, fill) {
  const count = packet.arrays.position.rows,
    rows = Math.max(1, Math.ceil(count / WIDTH));
  const data = new Float32Array(4 * WIDTH * rows);
  for (let k = 0; k < count; k++) fill(k, data, 4 * k);
  return textureOf(data, rows, THREE.FloatType);
}

function sourceOf({ value, label, colour }) {
  if (value) return VALUES;
  if (label) return LABELS;
  return colour ? OWN : PLAIN;
}

/// Replaces the textures of uniforms by those of a packet, and returns a geometry for its squares.
export function showPoints(uniforms, packet) {
  const { position, normal, radius, colour, value, label } = packet.arrays;
  for (const name of ['points', 'shapes', 'ownColours']) {
    if (uniforms[name].value !== empty) uniforms[name].value.dispose();
    uniforms[name].value = empty;
  }
  uniforms.points.value = fours(packet, (k, to, at) => {
    for (let c = 0; c < 3; c++) to[at + c] = position.data[3 * k + c];
    if (value) to[at + 3] = value.data[k];
    else if (label) to[at + 3] = label.data[k] % 4096; // as many colours as there are
  });
  if (normal)
    uniforms.shapes.value = fours(packet, (k, to, at) => {
      for (let c = 0; c < 3; c++) to[at + c] = normal.data[4 * k + c] / 32767;
      to[at + 3] = radius.data[k];
    });
  if (colour) {
    const rows = Math.ceil(position.rows / WIDTH) || 1,
      data = new Uint8Array(4 * WIDTH * rows);
    data.set(colour.data);
    uniforms.ownColours.value = textureOf(data, rows, THREE.UnsignedByteType);
  }
  uniforms.source.value = sourceOf(packet.arrays);
  const geometry = new THREE.BufferGeometry();
  geometry.setDrawRange(0, 6 * position.rows);
  return geometry;
}
