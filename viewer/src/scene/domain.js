// SPDX-License-Identifier: Apache-2.0
// Edges of the domain, and the outline of the cut plane.
import * as THREE from 'three';

const AXES = ['x', 'y', 'z'];

export class DomainBox {
  constructor() {
    this.material = new THREE.LineBasicMaterial({
      color: 0x8a96a3,
      transparent: true,
      opacity: 0.55,
      depthWrite: false,
    });
    this.object = new THREE.LineSegments(new THREE.BufferGeometry(), this.material);
    this.cutMaterial = new THREE.LineBasicMaterial({ color: 0xd9822b });
    this.cut = new THREE.LineLoop(new THREE.BufferGeometry(), this.cutMaterial);
    this.cut.visible = false;
  }

  /// box: THREE.Box3.
  set(box) {
    const size = box.getSize(new THREE.Vector3()),
      centre = box.getCenter(new THREE.Vector3());
    const edges = new THREE.EdgesGeometry(new THREE.BoxGeometry(size.x, size.y, size.z));
    edges.translate(centre.x, centre.y, centre.z);
    this.object.geometry.dispose();
    this.object.geometry = edges;
  }

  /// Sets the plane of a cut ({axis, share, flip}) within the box. Returns it as (normal, distance).
  showCut(cut, box) {
    const axis = AXES.indexOf(cut.axis);
    this.cut.visible = axis >= 0;
    if (axis < 0) return new THREE.Vector4(0, 0, 0, 1);
    const min = box.min.toArray(),
      max = box.max.toArray();
    const at = min[axis] + cut.share * (max[axis] - min[axis]);
    const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
    const corners = [
      [min[u], min[v]],
      [max[u], min[v]],
      [max[u], max[v]],
      [min[u], max[v]],
    ].map(([a, b]) => {
      const corner = [0, 0, 0];
      corner[axis] = at;
      corner[u] = a;
      corner[v] = b;
      return new THREE.Vector3(...corner);
    });
    this.cut.geometry.dispose();
    this.cut.geometry = new THREE.BufferGeometry().setFromPoints(corners);
    const sign = cut.flip ? -1 : 1,
      plane = [0, 0, 0, sign * at];
    plane[axis] = sign;
    return new THREE.Vector4(...plane);
  }
}
