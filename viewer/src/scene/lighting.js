// SPDX-License-Identifier: Apache-2.0
// Lights and background of the scene, as in pictures of `thaw render`, without shadows.
import * as THREE from 'three';
import { shared } from './shading.js';

/// Draws a gradient from the horizon upwards behind all that the picture shows.
class Gradient {
  constructor() {
    this.material = new THREE.RawShaderMaterial({
      glslVersion: THREE.GLSL3,
      depthTest: false,
      depthWrite: false,
      uniforms: {
        ...shared,
        low: { value: new THREE.Vector3() },
        top: { value: new THREE.Vector3() },
        slope: { value: new THREE.Vector2(1, 1) }, // tangents of half the angles of view
      },
      vertexShader: /* glsl */ `
precision highp float;
in vec3 position;
out vec2 at;
void main() {
  at = position.xy;
  gl_Position = vec4(position.xy, 0.0, 1.0);
}`,
      fragmentShader: /* glsl */ `
precision highp float;
uniform vec3 up, low, top;
uniform vec2 slope;
in vec2 at;
out vec4 colour;
void main() {
  float height = dot(normalize(vec3(at * slope, -1.0)), up);
  vec3 linear = mix(low, top, smoothstep(-0.05, 0.55, height));
  vec3 bright = 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055;
  colour = vec4(mix(12.92 * linear, bright, step(0.0031308, linear)), 1.0);
}`,
    });
    this.mesh = new THREE.Mesh(new THREE.PlaneGeometry(2, 2), this.material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = -3; // before the splats
    this.mesh.visible = false;
  }
}

const linearOf = (byte) => {
  const c = byte / 255;
  return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
};

export class Lighting {
  constructor() {
    this.gradient = new Gradient();
    this.object = this.gradient.mesh;
    this.directions = []; // to the lights, in the frame of the scene
    this.ambient = 1;
  }

  /// lighting: of the scene, as in io/view/run/scene_view.cpp.
  set({ lights, ambient, background, background_top: top }) {
    const shown = lights.slice(0, shared.toLight.value.length);
    this.directions = shown.map((light) => new THREE.Vector3(...light.to_light));
    shown.forEach((light, k) => shared.lightColour.value[k].set(...light.colour));
    shared.lights.value = shown.length;
    this.ambient = ambient;
    this.object.visible = background !== null;
    if (background === null) return;
    this.gradient.material.uniforms.low.value.set(...background.map(linearOf));
    this.gradient.material.uniforms.top.value.set(...top.map(linearOf));
  }

  /// Turns directions into the camera's frame.
  follow(camera) {
    this.directions.forEach((direction, k) =>
      shared.toLight.value[k].copy(direction).transformDirection(camera.matrixWorldInverse),
    );
    const tall = Math.tan((camera.fov * Math.PI) / 360);
    this.gradient.material.uniforms.slope.value.set(tall * camera.aspect, tall);
  }
}
