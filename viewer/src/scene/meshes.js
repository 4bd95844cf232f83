// SPDX-License-Identifier: Apache-2.0
// Triangles between points, seen from both sides: sheets, oriented bodies, and the lines of curves.
import * as THREE from 'three';
import { setPoints } from './points_geometry.js';
import {
  colourFragment,
  colourInputs,
  colourOutputs,
  colourUniforms,
  fragmentCommon,
  pickOutput,
  vertexCommon,
} from './shading.js';

const vertex = /* glsl */ `
${vertexCommon}
in vec3 position, normal;
${colourInputs}
${colourOutputs}
out vec3 place, where, direction;
flat out int number;
void main() {
  number = gl_VertexID;
  passColour();
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
      vertexShader: vertex,
      fragmentShader,
      side: THREE.DoubleSide,
    });
  }

  show(packet) {
    for (const [object, name] of [
      [this.mesh, 'triangles'],
      [this.lines, 'lines'],
    ]) {
      const geometry = new THREE.BufferGeometry();
      this.uniforms.source.value = setPoints(geometry, packet, false);
      const corners = packet.arrays[name];
      geometry.setIndex(new THREE.BufferAttribute(corners ? corners.data : new Uint32Array(0), 1));
      object.geometry.dispose();
      object.geometry = geometry;
    }
  }
}
