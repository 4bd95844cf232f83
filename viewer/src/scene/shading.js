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

/// Returns whether the cut plane hides a side.
export const isCut = () => shared.cut.value.x ** 2 + shared.cut.value.y ** 2 + shared.cut.value.z ** 2 > 0;

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

#ifdef QUICK
// Within 1 % of the range, without powers.
vec3 linearOf(vec3 c) { return c * (c * (c * 0.305306011 + 0.682171111) + 0.012522878); }
vec3 srgbOf(vec3 c) {
  vec3 a = sqrt(max(c, 0.0)), b = sqrt(a), d = sqrt(b);
  return 0.662002687 * a + 0.684122060 * b - 0.323583601 * d - 0.0225411470 * c;
}
#else
vec3 linearOf(vec3 c) { return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c)); }
vec3 srgbOf(vec3 c) {
  return mix(12.92 * c, 1.055 * pow(max(c, 0.0), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}
#endif
vec3 valueColour(float v) {
  if (isnan(v) || isinf(v)) return vec3(0.5);
  float t = range.y > range.x ? clamp((v - range.x) / (range.y - range.x), 0.0, 1.0) : 0.0;
  return texture(palette, vec2((t * 255.0 + 0.5) / 256.0, 0.5)).rgb;
}
vec3 labelColour(float k) {
  float hue = fract(k * 0.61803398875), light = 0.58 + 0.14 * fract(k * 0.7548776662);
  return light + 0.26 * cos(6.28318530718 * (hue + vec3(0.0, 1.0, 2.0) / 3.0));
}
/// linear: colour in linear light; normal: towards the camera, in its frame; position: in its frame. Returns
/// sRGB.
vec3 lit(vec3 linear, vec3 normal, vec3 position) {
  vec3 key = lights > 0 ? toLight[0] : normalize(vec3(-0.35, 0.55, 0.76)), eye = normalize(-position);
  float sky = 0.5 + 0.5 * dot(normal, up);
  vec3 light = bright * mix(vec3(0.26, 0.25, 0.24), vec3(0.50, 0.53, 0.57), sky);
  if (lights == 0) light += 0.66 * max(0.0, (dot(normal, key) + 0.25) / 1.25);
  for (int k = 0; k < lights; k++)
    light += vec3(0.88, 0.86, 0.82) * lightColour[k] * max(0.0, dot(normal, toLight[k]));
  float gleam = max(0.0, dot(normal, normalize(key + eye)));
  gleam *= gleam, gleam *= gleam, gleam *= gleam, gleam *= gleam; // to the power of 16
  vec3 shine = vec3(0.10 * gleam * gleam * gleam);
  if (lights > 0) shine *= lightColour[0] * step(0.0, dot(normal, key));
  return srgbOf(linear * light + shine);
}
/// albedo: sRGB.
vec3 shaded(vec3 albedo, vec3 normal, vec3 position) { return lit(linearOf(albedo), normal, position); }
`;

/// albedo(): colour by one of the four sources, from ownColour and ownValue (the value, or the label modulo
/// 4096).
export const colourChoice = /* glsl */ `
uniform int source;
vec3 albedo() {
  if (source == ${VALUES}) return valueColour(ownValue);
  if (source == ${LABELS}) return labelColour(floor(ownValue + 0.5));
  return source == ${OWN} ? ownColour : plain;
}
`;

export const colourFragment = /* glsl */ `
in vec3 ownColour;
in float ownValue;
${colourChoice}
`;

/// Returns the uniforms of a material with colours.
export function colourUniforms() {
  return { ...shared, source: { value: PLAIN }, plain: { value: new THREE.Color(0.62, 0.67, 0.73) } };
}

export function sourceOf({ value, label, colour }) {
  if (value) return VALUES;
  if (label) return LABELS;
  return colour ? OWN : PLAIN;
}

/// Returns vertex attributes of a packet's arrays, without copies where their types allow it.
export function attributesOf({ position, normal, colour, value, label }) {
  const of = (data, components, normalised) => new THREE.BufferAttribute(data, components, normalised);
  const labels = label && Float32Array.from(label.data, (k) => k % 4096);
  const attributes = {
    position: of(position.data, 3, false),
    colour: of(colour?.data ?? new Uint8Array(4 * position.rows), 4, true),
    value: of(value?.data ?? labels ?? new Float32Array(position.rows), 1, false),
  };
  if (normal) attributes.normal = of(normal.data, normal.components, true);
  return attributes;
}

/// Writes the index of a point instead of its colour: 24 bits of the index plus 1.
export const pickOutput = /* glsl */ `
vec4 indexColour(int index) {
  int k = index + 1;
  return vec4(float(k & 255), float((k >> 8) & 255), float((k >> 16) & 255), 255.0) / 255.0;
}
`;
