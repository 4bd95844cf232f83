// SPDX-License-Identifier: Apache-2.0
// The point below the pointer: all layers are drawn with indices for colours, on one pixel.
import * as THREE from 'three';

export class Picking {
  constructor(renderer) {
    this.renderer = renderer;
    this.target = new THREE.WebGLRenderTarget(1, 1, {
      minFilter: THREE.NearestFilter,
      magFilter: THREE.NearestFilter,
      colorSpace: THREE.NoColorSpace,
    });
    this.scene = new THREE.Scene();
  }

  /// Returns {type, index} of the nearest point at x, y (pixels from the upper left), or null. layers: {type,
  /// mesh, material} of the visible ones.
  pick(camera, { x, y, width, height }, layers) {
    const { renderer, target, scene } = this;
    camera.setViewOffset(width, height, x, y, 1, 1);
    renderer.setRenderTarget(target);
    renderer.setClearColor(0x000000, 0);
    renderer.clear();
    let found = null;
    const pixel = new Uint8Array(4);
    // Later layers are nearer where they leave a different pixel: depth is kept between them.
    for (const { type, mesh, material } of layers) {
      const before = pixel.slice();
      const { parent, material: drawn } = mesh;
      mesh.material = material;
      scene.add(mesh);
      renderer.render(scene, camera);
      parent.add(mesh);
      mesh.material = drawn;
      renderer.readRenderTargetPixels(target, 0, 0, 1, 1, pixel);
      const index = pixel[0] + 256 * pixel[1] + 65536 * pixel[2] - 1;
      if (pixel[3] > 0 && pixel.some((v, k) => v !== before[k])) found = { type, index };
    }
    renderer.setRenderTarget(null);
    camera.clearViewOffset();
    return found;
  }
}
