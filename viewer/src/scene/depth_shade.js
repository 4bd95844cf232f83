// SPDX-License-Identifier: Apache-2.0
// Darkens pixels that lie behind their neighbours, which shows the depth of crowds of points (eye-dome
// lighting, B09), and copies the picture to the canvas.
import * as THREE from 'three';

const vertexShader = /* glsl */ `
out vec2 at;
void main() {
  at = 0.5 * position.xy + 0.5;
  gl_Position = vec4(position.xy, 0.0, 1.0);
}`;

const fragmentShader = /* glsl */ `
precision highp float;
uniform sampler2D picture, depths;
uniform vec2 pixel;   // size of one, of the whole 1
uniform vec2 range;   // near and far plane
uniform float strength;
in vec2 at;
out vec4 result;
float logDistance(vec2 where) {
  float z = 2.0 * texture(depths, where).r - 1.0;
  return log2(2.0 * range.x * range.y / (range.y + range.x - z * (range.y - range.x)));
}
void main() {
  vec4 colour = texture(picture, at);
  if (texture(depths, at).r >= 1.0) {
    result = colour;
    return;
  }
  float here = logDistance(at), behind = 0.0;
  for (int ring = 1; ring <= 2; ring++)
    for (int k = 0; k < 8; k++) {
      float turn = 0.785398 * (float(k) + 0.5 * float(ring));
      vec2 other = at + float(ring) * 1.4 * pixel * vec2(cos(turn), sin(turn));
      behind += clamp(here - logDistance(other), 0.0, 0.04);
    }
  result = vec4(colour.rgb * max(0.35, exp(-strength * behind / 16.0)), 1.0);
}`;

export class DepthShade {
  constructor() {
    this.target = new THREE.WebGLRenderTarget(1, 1, { samples: 4, colorSpace: THREE.NoColorSpace });
    this.target.depthTexture = new THREE.DepthTexture(1, 1, THREE.UnsignedIntType);
    this.uniforms = {
      picture: { value: this.target.texture },
      depths: { value: this.target.depthTexture },
      pixel: { value: new THREE.Vector2() },
      range: { value: new THREE.Vector2() },
      strength: { value: 25 },
    };
    const material = new THREE.RawShaderMaterial({
      glslVersion: THREE.GLSL3,
      uniforms: this.uniforms,
      vertexShader: `in vec3 position;${vertexShader}`,
      fragmentShader,
      depthTest: false,
      depthWrite: false,
    });
    const triangle = new THREE.BufferGeometry();
    triangle.setAttribute(
      'position',
      new THREE.BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3),
    );
    this.mesh = new THREE.Mesh(triangle, material);
    this.mesh.frustumCulled = false;
    this.scene = new THREE.Scene().add(this.mesh);
  }

  resize(width, height) {
    this.target.setSize(width, height);
    this.uniforms.pixel.value.set(1 / width, 1 / height);
  }

  /// scale: pixels of the picture per pixel of the page.
  draw(renderer, camera, scale) {
    this.uniforms.range.value.set(camera.near, camera.far);
    this.uniforms.pixel.value.set(scale / this.target.width, scale / this.target.height);
    renderer.setRenderTarget(null);
    renderer.render(this.scene, camera);
  }
}
