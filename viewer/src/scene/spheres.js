// SPDX-License-Identifier: Apache-2.0
// Particles as spheres: a square each, on which rays are cut with the sphere. Depth is that of the sphere.
// Quick pictures draw discs that are shaded as spheres, with the depth of their centres.
import * as THREE from 'three';
import { exposedPoints } from './coarse.js';
import { readPoint, showPoints, textureUniforms } from './point_textures.js';
import {
  attributesOf,
  colourChoice,
  colourFragment,
  colourUniforms,
  fragmentCommon,
  isCut,
  pickOutput,
  sourceOf,
  vertexCommon,
} from './shading.js';

const SWELL = 1.15; // factor of radii without the points behind, which fill gaps

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

// One vertex a point.
const quickVertex = /* glsl */ `
${fragmentCommon}
uniform mat4 modelMatrix, viewMatrix, projectionMatrix;
uniform float size, swell, pixels;   // pixels: height of the picture
in vec3 position;
in vec4 colour;
in float value;
vec3 ownColour;
float ownValue;
${colourChoice}
flat out vec3 linear, middle;
void main() {
  middle = (viewMatrix * modelMatrix * vec4(position, 1.0)).xyz;
  if (dot(cut.xyz, position) > cut.w || middle.z > -size) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    gl_PointSize = 1.0;
    return;
  }
  ownColour = colour.rgb;
  ownValue = value;
  linear = linearOf(albedo());
  gl_Position = projectionMatrix * vec4(middle, 1.0);
  gl_PointSize = swell * size * pixels * projectionMatrix[1][1] / -middle.z;
}`;
const quickFragment = /* glsl */ `
${fragmentCommon}
flat in vec3 linear, middle;
out vec4 result;
void main() {
  vec2 at = 2.0 * gl_PointCoord - 1.0;
  float rest = 1.0 - dot(at, at);
  if (rest < 0.0) discard;
  result = vec4(lit(linear, vec3(at.x, -at.y, sqrt(rest)), middle), 1.0);
}`;

export class Spheres {
  constructor() {
    this.uniforms = {
      ...colourUniforms(),
      ...textureUniforms(),
      size: { value: 0.01 },
      pixels: { value: 1 },
      swell: { value: 1 },
    };
    this.material = this.materialOf(vertexShader, draw);
    this.pickMaterial = this.materialOf(vertexShader, pick);
    this.mesh = new THREE.Mesh(new THREE.BufferGeometry(), this.material);
    this.points = new THREE.Points(
      new THREE.BufferGeometry(),
      this.materialOf(quickVertex, quickFragment, { QUICK: '' }),
    );
    this.mesh.frustumCulled = this.points.frustumCulled = false;
    this.packet = null;
    this.current = new Set(); // the objects that show the packet
    this.exposed = null; // its points that are not hidden by others
  }

  materialOf(vertex, fragmentShader, defines = {}) {
    const { uniforms } = this;
    return new THREE.RawShaderMaterial({
      glslVersion: THREE.GLSL3,
      uniforms,
      vertexShader: vertex,
      fragmentShader,
      defines,
    });
  }

  /// radius: m.
  show(packet, radius) {
    this.packet = packet;
    this.current.clear();
    this.exposed = null;
    this.uniforms.size.value = radius;
  }

  /// Chooses what is drawn, and passes the packet to it. height: of the picture, pixels.
  prepare({ quick, coarse }, height) {
    const { mesh, points, packet, uniforms } = this,
      drawn = quick ? points : mesh;
    mesh.visible = !quick;
    points.visible = quick;
    uniforms.pixels.value = height;
    if (!packet) return;
    if (!this.current.has(drawn)) {
      this.current.add(drawn);
      drawn.geometry.dispose();
      drawn.geometry = quick ? this.geometryOf(packet.arrays) : showPoints(uniforms, packet);
    }
    if (quick) this.thin(coarse && !isCut());
  }

  /// Draws the exposed points alone, or all.
  thin(coarse) {
    const { points, packet, uniforms } = this;
    if (coarse) this.exposed ??= exposedPoints(packet.arrays.position, uniforms.size.value);
    const index = coarse ? this.exposed.index : null;
    uniforms.swell.value = coarse ? SWELL / Math.sqrt(this.exposed.share) : 1;
    if ((points.geometry.index?.array ?? null) === index) return;
    points.geometry.setIndex(index && new THREE.BufferAttribute(index, 1));
  }

  geometryOf(arrays) {
    const attributes = attributesOf(arrays);
    const geometry = new THREE.BufferGeometry();
    for (const name of ['position', 'colour', 'value']) geometry.setAttribute(name, attributes[name]);
    this.uniforms.source.value = sourceOf(arrays);
    return geometry;
  }
}
