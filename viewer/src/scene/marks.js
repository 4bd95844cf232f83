// SPDX-License-Identifier: Apache-2.0
// Lines for the parts of a scene without particles: emitters, clamps, camera.
import * as THREE from 'three';

const COLOURS = { emitters: 0x2f78be, clamps: 0xbe463c, camera: 0xd9822b };

export class Marks {
  constructor() {
    this.group = new THREE.Group();
    this.kinds = new Map(); // THREE.LineSegments by kind
  }

  /// packet: of api/marks.
  set({ header, arrays }) {
    this.group.clear();
    this.kinds.clear();
    for (const [kind, color] of Object.entries(COLOURS)) {
      const ends = (header.marks ?? [])
        .filter((mark) => mark.kind === kind)
        .flatMap(({ first, lines }) => [...arrays.position.data.subarray(6 * first, 6 * (first + lines))]);
      if (ends.length === 0) continue;
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute('position', new THREE.Float32BufferAttribute(ends, 3));
      const lines = new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({ color }));
      this.kinds.set(kind, lines);
      this.group.add(lines);
    }
  }

  show(layers) {
    for (const [kind, lines] of this.kinds) lines.visible = layers[kind];
  }
}
