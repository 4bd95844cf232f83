// SPDX-License-Identifier: Apache-2.0
// Uniforms and shader functions that all parts of the picture share.
import * as THREE from 'three';
import { paletteOf } from './colour_maps.js';

const palette = new THREE.DataTexture(paletteOf('ember'), 256, 1, THREE.RGBAFormat);
palette.minFilter = palette.magFilter = THREE.LinearFilter;
palette.needsUpdate = true;

/// Shared by reference: a change shows in all materials.
export const shared = {
  palette: { value: palette },
  range: { value: new THREE.Vector2(0, 1) },
  cut: { value: new THREE.Vector4(0, 0, 0, 1) }, // x is hidden where dot(cut.xyz, x) > cut.w
  up: { value: new THREE.Vector3(0, 1, 0) }, // upward direction, in the camera's frame
  bright: { value: 1 }, // factor of the ambient light: 1 in the light theme, less in the dark
  lights: { value: 0 }, // lights of the scene; 0: one behind the camera
  toLight: { value: Array.from({ length: 8 }, () => new THREE.Vector3(0, 0, 1)) }, // in the camera's frame
  lightColour: { value: Array.from({ length: 8 }, () => new THREE.Vector3(1, 1, 1)) }, // linear
};

export function setPalette(name) {
  palette.image.data.set(paletteOf(name));
  palette.needsUpdate = true;
}

/// Source of a material's colours: one for all points, one each, values with the palette, or labels.
export const PLAIN = 0,
  OWN = 1,
  VALUES = 2,
  LABELS = 3;

export const vertexCommon = /* glsl */ `
precision highp float;
precision highp int;
uniform mat4 modelMatrix, viewMatrix, projectionMatrix;
uniform vec4 cut;
`;

export const fragmentCommon = /* glsl */ `
precision highp float;
precision highp int;
uniform sampler2D palette;
uniform vec2 range;
uniform vec3 up, plain;
uniform vec4 cut;
uniform float bright;
uniform int lights;
uniform vec3 toLight[8], lightColour[8];

vec3 linearOf(vec3 c) { return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c)); }
vec3 srgbOf(vec3 c) {
  return mix(12.92 * c, 1.055 * pow(max(c, 0.0), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}
vec3 valueColour(float v) {
  if (isnan(v) || isinf(v)) return vec3(0.5);
  float t = range.y > range.x ? clamp((v - range.x) / (range.y - range.x), 0.0, 1.0) : 0.0;
  return texture(palette, vec2((t * 255.0 + 0.5) / 256.0, 0.5)).rgb;
}
vec3 labelColour(float k) {
  float hue = fract(k * 0.61803398875), light = 0.58 + 0.14 * fract(k * 0.7548776662);
  return light + 0.26 * cos(6.28318530718 * (hue + vec3(0.0, 1.0, 2.0) / 3.0));
}
/// albedo: sRGB; normal: towards the camera, in its frame; position: in its frame. Returns sRGB.
vec3 shaded(vec3 albedo, vec3 normal, vec3 position) {
  vec3 key = lights > 0 ? toLight[0] : normalize(vec3(-0.35, 0.55, 0.76)), eye = normalize(-position);
  float sky = 0.5 + 0.5 * dot(normal, up);
  vec3 light = bright * mix(vec3(0.26, 0.25, 0.24), vec3(0.50, 0.53, 0.57), sky);
  if (lights == 0) light += 0.66 * max(0.0, (dot(normal, key) + 0.25) / 1.25);
  for (int k = 0; k < lights; k++)
    light += vec3(0.88, 0.86, 0.82) * lightColour[k] * max(0.0, dot(normal, toLight[k]));
  vec3 shine = vec3(0.10 * pow(max(0.0, dot(normal, normalize(key + eye))), 48.0));
  if (lights > 0) shine *= lightColour[0] * step(0.0, dot(normal, key));
  return srgbOf(linearOf(albedo) * light + shine);
}
`;

/// Colour by one of the four sources. ownValue: the value, or the label modulo 4096.
export const colourFragment = /* glsl */ `
in vec3 ownColour;
in float ownValue;
uniform int source;
vec3 albedo() {
  if (source == ${VALUES}) return valueColour(ownValue);
  if (source == ${LABELS}) return labelColour(floor(ownValue + 0.5));
  return source == ${OWN} ? ownColour : plain;
}
`;

/// Returns the uniforms of a material with colours.
export function colourUniforms() {
  return { ...shared, source: { value: PLAIN }, plain: { value: new THREE.Color(0.62, 0.67, 0.73) } };
}

/// Writes the index of a point instead of its colour: 24 bits of the index plus 1.
export const pickOutput = /* glsl */ `
vec4 indexColour(int index) {
  int k = index + 1;
  return vec4(float(k & 255), float((k >> 8) & 255), float((k >> 16) & 255), 255.0) / 255.0;
}
`;
