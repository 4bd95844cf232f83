// SPDX-License-Identifier: Apache-2.0
// Triangles between points, seen from both sides: surfaces, sheets, oriented bodies, and lines of curves.
import * as THREE from 'three';
import {
  colourFragment,
  colourUniforms,
  fragmentCommon,
  LABELS,
  OWN,
  pickOutput,
  PLAIN,
  VALUES,
  vertexCommon,
} from './shading.js';

const vertexShader = /* glsl */ `
${vertexCommon}
in vec3 position, normal;
in vec4 colour;
in float value;
out vec3 ownColour;
out float ownValue;
out vec3 place, where, direction;
flat out int number;
void main() {
  number = gl_VertexID;
  ownColour = colour.rgb;
  ownValue = value;
  where = position;
  place = (viewMatrix * modelMatrix * vec4(position, 1.0)).xyz;
  direction = mat3(viewMatrix) * normal;
  gl_Position = projectionMatrix * vec4(place, 1.0);
}`;

const fragmentStart = /* glsl */ `
${fragmentCommon}
in vec3 place, where, direction;
flat in int number;
${colourFragment}
${pickOutput}
out vec4 result;
void main() {
  if (dot(cut.xyz, where) > cut.w) discard;`;
const draw = `${fragmentStart}
  vec3 n = normalize(direction);
  if (dot(n, place) > 0.0) n = -n;
  result = vec4(shaded(albedo(), n, place), 1.0);
}`;
const drawLine = `${fragmentStart}
  result = vec4(albedo(), 1.0);
}`;
const pick = `${fragmentStart}
  result = indexColour(number);
}`;

/// Returns a geometry of the points of a packet, and the source of their colours.
function geometryOf({ position, normal, colour, value, label }) {
  const geometry = new THREE.BufferGeometry();
  const set = (name, data, components, normalised) =>
    geometry.setAttribute(name, new THREE.BufferAttribute(data, components, normalised));
  set('position', position.data, 3, false);
  set('normal', normal.data, normal.components, true);
  set('colour', colour?.data ?? new Uint8Array(4 * position.rows), 4, true);
  const labels = label && Float32Array.from(label.data, (k) => k % 4096);
  set('value', value?.data ?? labels ?? new Float32Array(position.rows), 1, false);
  const source = value ? VALUES : label ? LABELS : colour ? OWN : PLAIN;
  return { geometry, source };
}

export class Meshes {
  constructor() {
    this.uniforms = colourUniforms();
    this.material = this.materialOf(draw);
    this.pickMaterial = this.materialOf(pick);
    this.lineMaterial = this.materialOf(drawLine);
    this.mesh = new THREE.Mesh(new THREE.BufferGeometry(), this.material);
    this.lines = new THREE.LineSegments(new THREE.BufferGeometry(), this.lineMaterial);
    this.mesh.frustumCulled = this.lines.frustumCulled = false;
  }

  materialOf(fragmentShader) {
    const { uniforms } = this;
    return new THREE.RawShaderMaterial({
      glslVersion: THREE.GLSL3,
      uniforms,
      vertexShader,
      fragmentShader,
      side: THREE.DoubleSide,
    });
  }

  /// arrays: of a packet.
  show(arrays) {
    for (const [object, name] of [
      [this.mesh, 'triangles'],
      [this.lines, 'lines'],
    ]) {
      const { geometry, source } = geometryOf(arrays);
      const corners = arrays[name];
      geometry.setIndex(new THREE.BufferAttribute(corners ? corners.data : new Uint32Array(0), 1));
      this.uniforms.source.value = source;
      object.geometry.dispose();
      object.geometry = geometry;
    }
  }
}
