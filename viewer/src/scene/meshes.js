// SPDX-License-Identifier: Apache-2.0
// Triangles between points, seen from both sides: surfaces, sheets, oriented bodies, and lines of curves.
import * as THREE from 'three';
import { coarseTriangles } from './coarse.js';
import {
  attributesOf,
  colourFragment,
  colourUniforms,
  fragmentCommon,
  pickOutput,
  sourceOf,
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

export class Meshes {
  constructor() {
    this.uniforms = colourUniforms();
    this.material = this.materialOf(draw);
    this.quickMaterial = this.materialOf(draw, { QUICK: '' });
    this.pickMaterial = this.materialOf(pick);
    this.lineMaterial = this.materialOf(drawLine);
    this.mesh = new THREE.Mesh(new THREE.BufferGeometry(), this.material);
    this.lines = new THREE.LineSegments(new THREE.BufferGeometry(), this.lineMaterial);
    this.mesh.frustumCulled = this.lines.frustumCulled = false;
  }

  materialOf(fragmentShader, defines = {}) {
    const { uniforms } = this;
    return new THREE.RawShaderMaterial({
      glslVersion: THREE.GLSL3,
      uniforms,
      vertexShader,
      fragmentShader,
      defines,
      side: THREE.DoubleSide,
    });
  }

  /// arrays: of a packet.
  show(arrays) {
    const attributes = attributesOf(arrays);
    this.uniforms.source.value = sourceOf(arrays);
    this.mesh.shape = [arrays.position, arrays.triangles];
    this.mesh.coarse = null;
    for (const [object, name] of [
      [this.mesh, 'triangles'],
      [this.lines, 'lines'],
    ]) {
      const geometry = new THREE.BufferGeometry(),
        corners = arrays[name]?.data ?? new Uint32Array(0);
      object.empty = corners.length === 0;
      for (const [key, attribute] of Object.entries(attributes)) geometry.setAttribute(key, attribute);
      object.corners = new THREE.BufferAttribute(corners, 1);
      geometry.setIndex(object.corners);
      object.geometry.dispose();
      object.geometry = geometry;
    }
  }

  setVisible(visible) {
    for (const object of [this.mesh, this.lines]) object.visible = visible && !object.empty;
  }

  prepare({ quick, coarse }) {
    this.mesh.material = quick ? this.quickMaterial : this.material;
    const { corners, geometry } = this.mesh;
    if (this.mesh.empty) return;
    if (coarse) this.mesh.coarse ??= new THREE.BufferAttribute(coarseTriangles(...this.mesh.shape), 1);
    geometry.setIndex(coarse ? this.mesh.coarse : corners);
  }
}
