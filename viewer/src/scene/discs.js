// SPDX-License-Identifier: Apache-2.0
// Surfels and other points with normals as discs. Splats (splats.js) blends them into a smooth surface.
import * as THREE from 'three';
import { readPoint, showPoints, textureUniforms } from './point_textures.js';
import { colourFragment, colourUniforms, fragmentCommon, pickOutput, vertexCommon } from './shading.js';

/// moved: discs are moved away from the camera by a share of their radii.
const vertex = (moved) => /* glsl */ `
${vertexCommon}
${readPoint}
uniform float size, behind;
out vec2 corner;
out vec3 place, where, direction;
void main() {
  vec3 normal;
  float radius;
  vec3 centre = readPoint(normal, radius);
  vec3 n = normalize(normal), a = abs(n.z) < 0.8 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
  vec3 u = normalize(cross(a, n)), v = cross(n, u);
  corner = squareCorner();
  where = centre + size * radius * (corner.x * u + corner.y * v);
  place = (viewMatrix * modelMatrix * vec4(where, 1.0)).xyz;
  ${moved ? 'place += behind * radius * normalize(place);' : ''}
  direction = mat3(viewMatrix) * n;
  gl_Position = projectionMatrix * vec4(place, 1.0);
}`;

const fragmentStart = /* glsl */ `
${fragmentCommon}
in vec2 corner;
in vec3 place, where, direction;
flat in int number;
${colourFragment}
${pickOutput}`;
const inside = 'if (dot(corner, corner) > 1.0 || dot(cut.xyz, where) > cut.w) discard;';

const blend = /* glsl */ `${fragmentStart}
layout(location = 0) out vec4 colours;
layout(location = 1) out vec4 normals;
void main() {
  ${inside}
  float weight = 1.0 - dot(corner, corner);
  weight *= weight;
  vec3 n = normalize(direction);
  if (dot(n, place) > 0.0) n = -n;
  colours = weight * vec4(linearOf(albedo()), 1.0);
  normals = weight * vec4(n, 1.0);
}`;
/// Without blending, for quick pictures.
const plain = /* glsl */ `${fragmentStart}
out vec4 result;
void main() {
  ${inside}
  vec3 n = normalize(direction);
  if (dot(n, place) > 0.0) n = -n;
  result = vec4(shaded(albedo(), n, place), 1.0);
}`;
const depth = /* glsl */ `${fragmentStart}
void main() {
  ${inside}
}`;
const pick = /* glsl */ `${fragmentStart}
out vec4 result;
void main() {
  ${inside}
  result = indexColour(number);
}`;

export class Discs {
  constructor() {
    this.uniforms = { ...colourUniforms(), ...textureUniforms(), size: { value: 1 }, behind: { value: 1 } };
    // In front of neighbours by less than `behind`, a disc is blended with them.
    this.depthMaterial = this.materialOf(vertex(true), depth, { colorWrite: false });
    this.blendMaterial = this.materialOf(vertex(false), blend, {
      depthWrite: false,
      transparent: true,
      blending: THREE.CustomBlending,
      blendEquation: THREE.AddEquation,
      blendSrc: THREE.OneFactor,
      blendDst: THREE.OneFactor,
    });
    this.quickMaterial = this.materialOf(vertex(false), plain, { defines: { QUICK: '' } });
    this.pickMaterial = this.materialOf(vertex(false), pick, {});
    this.mesh = new THREE.Mesh(new THREE.BufferGeometry(), this.blendMaterial);
    this.mesh.frustumCulled = false;
    this.mesh.visible = false;
  }

  materialOf(vertexShader, fragmentShader, more) {
    const { uniforms } = this;
    return new THREE.RawShaderMaterial({
      glslVersion: THREE.GLSL3,
      uniforms,
      vertexShader,
      fragmentShader,
      side: THREE.DoubleSide,
      ...more,
    });
  }

  /// size: factor of the radii.
  show(packet, size) {
    this.mesh.geometry.dispose();
    this.mesh.geometry = showPoints(this.uniforms, packet);
    this.uniforms.size.value = size;
  }
}
