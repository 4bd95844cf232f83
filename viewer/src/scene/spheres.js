// SPDX-License-Identifier: Apache-2.0
// Particles as spheres: a square each, on which rays are cut with the sphere. Depth is that of the sphere.
import * as THREE from 'three';
import { readPoint, showPoints, textureUniforms } from './point_textures.js';
import { colourFragment, colourUniforms, fragmentCommon, pickOutput, vertexCommon } from './shading.js';

const vertexShader = /* glsl */ `
${vertexCommon}
${readPoint}
uniform float size;
out vec3 corner, middle;
void main() {
  vec3 normal;
  float radius;
  vec3 centre = readPoint(normal, radius);
  vec2 side = squareCorner();
  middle = (viewMatrix * modelMatrix * vec4(centre, 1.0)).xyz;
  if (dot(cut.xyz, centre) > cut.w || middle.z > -size) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  // A square in front of the sphere, across the ray to its centre, covers it from any side.
  vec3 ahead = normalize(middle), right = normalize(cross(ahead, vec3(0.0, 1.0, 0.0)));
  vec3 over = cross(right, ahead);
  float far = length(middle), near = far - size;
  float wide = size * near / sqrt(max(far * far - size * size, 1e-12));
  corner = middle - size * ahead + wide * (side.x * right + side.y * over);
  gl_Position = projectionMatrix * vec4(corner, 1.0);
}`;

const fragmentStart = /* glsl */ `
${fragmentCommon}
uniform mat4 projectionMatrix;
uniform float size;
in vec3 corner, middle;
flat in int number;
${colourFragment}
${pickOutput}
out vec4 result;
void main() {
  vec3 ray = normalize(corner);
  float along = dot(ray, middle), gap = dot(middle, middle) - along * along, rest = size * size - gap;
  if (rest < 0.0) discard;
  vec3 hit = ray * (along - sqrt(rest));
  vec4 clip = projectionMatrix * vec4(hit, 1.0);
  gl_FragDepth = 0.5 * clip.z / clip.w + 0.5;`;
const draw = `${fragmentStart}
  result = vec4(shaded(albedo(), (hit - middle) / size, hit), 1.0);
}`;
const pick = `${fragmentStart}
  result = indexColour(number);
}`;

export class Spheres {
  constructor() {
    this.uniforms = { ...colourUniforms(), ...textureUniforms(), size: { value: 0.01 } };
    this.material = this.materialOf(draw);
    this.pickMaterial = this.materialOf(pick);
    this.mesh = new THREE.Mesh(new THREE.BufferGeometry(), this.material);
    this.mesh.frustumCulled = false;
  }

  materialOf(fragmentShader) {
    const { uniforms } = this;
    return new THREE.RawShaderMaterial({
      glslVersion: THREE.GLSL3,
      uniforms,
      vertexShader,
      fragmentShader,
    });
  }

  /// radius: m.
  show(packet, radius) {
    this.mesh.geometry.dispose();
    this.mesh.geometry = showPoints(this.uniforms, packet);
    this.uniforms.size.value = radius;
  }
}
