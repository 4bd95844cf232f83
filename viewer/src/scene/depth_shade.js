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
#ifdef QUICK
  for (int k = 0; k < 4; k++) {
    vec2 other = at + 2.0 * pixel * vec2(k == 0 ? 1 : k == 1 ? -1 : 0, k == 2 ? 1 : k == 3 ? -1 : 0);
    behind += 4.0 * clamp(here - logDistance(other), 0.0, 0.04);
  }
#else
  for (int ring = 1; ring <= 2; ring++)
    for (int k = 0; k < 8; k++) {
      float turn = 0.785398 * (float(k) + 0.5 * float(ring));
      vec2 other = at + float(ring) * 1.4 * pixel * vec2(cos(turn), sin(turn));
      behind += clamp(here - logDistance(other), 0.0, 0.04);
    }
#endif
  result = vec4(colour.rgb * max(0.35, exp(-strength * behind / 16.0)), 1.0);
}`;

/// Returns a target with a texture of depths. samples: of a pixel, for smooth edges.
function targetOf(samples) {
  const target = new THREE.WebGLRenderTarget(1, 1, { samples, colorSpace: THREE.NoColorSpace });
  target.depthTexture = new THREE.DepthTexture(1, 1, THREE.UnsignedIntType);
  return target;
}

export class DepthShade {
  constructor() {
    this.smooth = targetOf(4);
    this.rough = targetOf(0);
    this.uniforms = {
      picture: { value: null },
      depths: { value: null },
      pixel: { value: new THREE.Vector2() },
      range: { value: new THREE.Vector2() },
      strength: { value: 25 },
    };
    this.material = this.materialOf({});
    this.quickMaterial = this.materialOf({ QUICK: '' });
    const triangle = new THREE.BufferGeometry();
    triangle.setAttribute(
      'position',
      new THREE.BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3),
    );
    this.mesh = new THREE.Mesh(triangle, this.material);
    this.mesh.frustumCulled = false;
    this.scene = new THREE.Scene().add(this.mesh);
    this.prepare(false, 1, 1);
  }

  materialOf(defines) {
    return new THREE.RawShaderMaterial({
      glslVersion: THREE.GLSL3,
      uniforms: this.uniforms,
      vertexShader: `in vec3 position;${vertexShader}`,
      fragmentShader,
      defines,
      depthTest: false,
      depthWrite: false,
    });
  }

  /// Chooses the target of a picture. width, height: pixels.
  prepare(quick, width, height) {
    const target = (this.target = quick ? this.rough : this.smooth);
    target.setSize(width, height);
    this.uniforms.picture.value = target.texture;
    this.uniforms.depths.value = target.depthTexture;
    this.mesh.material = quick ? this.quickMaterial : this.material;
  }

  /// scale: pixels of the picture per pixel of the page.
  draw(renderer, camera, scale) {
    this.uniforms.range.value.set(camera.near, camera.far);
    this.uniforms.pixel.value.set(scale / this.target.width, scale / this.target.height);
    renderer.setRenderTarget(null);
    renderer.render(this.scene, camera);
  }
}
