// SPDX-License-Identifier: Apache-2.0
// Points of a packet as textures, from which a vertex shader reads those of its square: six vertices a point,
// without copies. Instances of such small meshes are slow on many graphics processors.
import * as THREE from 'three';
import { OWN, sourceOf } from './shading.js';

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

/// Fills a texture with values of `count` points in fours. fill(data): writes them. The texture and its
/// memory are kept if the new one has the same size.
function renew(uniform, count, type, fill) {
  const rows = Math.max(1, Math.ceil(count / WIDTH)),
    before = uniform.value;
  if (before === empty || before.image.height !== rows) {
    if (before !== empty) before.dispose();
    const Numbers = type === THREE.FloatType ? Float32Array : Uint8Array;
    uniform.value = textureOf(new Numbers(4 * WIDTH * rows), rows, type);
  }
  fill(uniform.value.image.data);
  uniform.value.needsUpdate = true;
}

function clear(uniform) {
  if (uniform.value !== empty) uniform.value.dispose();
  uniform.value = empty;
}

/// Writes positions, and values or labels as their fourth component.
function writePoints(to, { position, value, label }) {
  const { data, rows } = position;
  for (let k = 0, from = 0, at = 0; k < rows; k++, from += 3, at += 4) {
    to[at] = data[from];
    to[at + 1] = data[from + 1];
    to[at + 2] = data[from + 2];
    if (value) to[at + 3] = value.data[k];
    else if (label) to[at + 3] = label.data[k] % 4096; // as many colours as there are
  }
}

/// Writes normals and radii.
function writeShapes(to, { normal, radius }) {
  for (let k = 0, at = 0; k < normal.rows; k++, at += 4) {
    for (let c = 0; c < 3; c++) to[at + c] = normal.data[at + c] / 32767;
    to[at + 3] = radius.data[k];
  }
}

/// Replaces the textures of uniforms by those of a packet, and returns a geometry for its squares.
export function showPoints(uniforms, packet) {
  const { arrays } = packet,
    { position, normal, colour } = arrays;
  renew(uniforms.points, position.rows, THREE.FloatType, (to) => writePoints(to, arrays));
  if (normal) renew(uniforms.shapes, position.rows, THREE.FloatType, (to) => writeShapes(to, arrays));
  else clear(uniforms.shapes);
  if (colour) renew(uniforms.ownColours, position.rows, THREE.UnsignedByteType, (to) => to.set(colour.data));
  else clear(uniforms.ownColours);
  uniforms.source.value = sourceOf(arrays);
  const geometry = new THREE.BufferGeometry();
  geometry.setDrawRange(0, 6 * position.rows);
  return geometry;
}
