// SPDX-License-Identifier: Apache-2.0
// Blends overlapping discs into one surface (BHZK05). Their depths come first, then the weighted sums of
// colours and normals of all discs near the front. Last, each sum is shaded as one pixel.
import * as THREE from 'three';
import { fragmentCommon, shared } from './shading.js';

const vertexShader = /* glsl */ `
in vec3 position;
out vec2 at;
void main() {
  at = 0.5 * position.xy + 0.5;
  gl_Position = vec4(position.xy, 0.0, 1.0);
}`;

const fragmentShader = /* glsl */ `
${fragmentCommon}
uniform sampler2D colours, normals, depths;
uniform mat4 inverseProjection;
in vec2 at;
out vec4 result;
void main() {
  vec4 colour = texture(colours, at), normal = texture(normals, at);
  float depth = texture(depths, at).r;
  if (colour.a < 1e-4) {
    // A gap of one pixel between steep discs takes the mean of its neighbours.
    vec2 pixel = 1.0 / vec2(textureSize(colours, 0));
    int covered = 0;
    depth = 1.0;
    for (int k = 0; k < 4; k++) {
      vec2 beside = at + pixel * vec2(k == 0 ? 1 : k == 1 ? -1 : 0, k == 2 ? 1 : k == 3 ? -1 : 0);
      vec4 other = texture(colours, beside);
      if (other.a < 1e-4) continue;
      covered++;
      colour += other;
      normal += texture(normals, beside);
      depth = min(depth, texture(depths, beside).r);
    }
    if (covered < 3) discard;
  }
  gl_FragDepth = depth;
  vec4 place = inverseProjection * vec4(2.0 * vec3(at, depth) - 1.0, 1.0);
  result = vec4(shaded(srgbOf(colour.rgb / colour.a), normalize(normal.xyz), place.xyz / place.w), 1.0);
}`;

export class Splats {
  constructor() {
    this.scene = new THREE.Scene();
    this.target = new THREE.WebGLRenderTarget(1, 1, {
      count: 2,
      type: THREE.HalfFloatType,
      minFilter: THREE.NearestFilter,
      magFilter: THREE.NearestFilter,
    });
    this.target.depthTexture = new THREE.DepthTexture(1, 1, THREE.UnsignedIntType);
    const [colours, normals] = this.target.textures;
    this.uniforms = {
      ...shared,
      colours: { value: colours },
      normals: { value: normals },
      depths: { value: this.target.depthTexture },
      inverseProjection: { value: new THREE.Matrix4() },
    };
    const triangle = new THREE.BufferGeometry();
    triangle.setAttribute(
      'position',
      new THREE.BufferAttribute(new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]), 3),
    );
    /// For the scene of the picture.
    this.mesh = new THREE.Mesh(
      triangle,
      new THREE.RawShaderMaterial({
        glslVersion: THREE.GLSL3,
        uniforms: this.uniforms,
        vertexShader,
        fragmentShader,
      }),
    );
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = -2;
    this.discs = [];
  }

  add(discs) {
    this.discs.push(discs);
    this.scene.add(discs.mesh);
  }

  resize(width, height) {
    this.target.setSize(width, height);
  }

  /// scene: of the picture, to which quick pictures add the discs without blending.
  prepare(quick, scene) {
    this.quick = quick;
    for (const discs of this.discs) {
      if (quick) discs.mesh.material = discs.quickMaterial;
      (quick ? scene : this.scene).add(discs.mesh);
    }
  }

  draw(renderer, camera) {
    if (this.quick) {
      this.mesh.visible = false;
      return;
    }
    const shown = this.discs.filter((d) => d.mesh.visible);
    this.mesh.visible = shown.length > 0;
    if (!this.mesh.visible) return;
    this.uniforms.inverseProjection.value.copy(camera.projectionMatrixInverse);
    renderer.setRenderTarget(this.target);
    renderer.setClearColor(0x000000, 0);
    renderer.clear();
    for (const name of ['depthMaterial', 'blendMaterial']) {
      for (const discs of shown) discs.mesh.material = discs[name];
      renderer.render(this.scene, camera);
    }
  }
}
