// SPDX-License-Identifier: Apache-2.0
// The points of one type in the picture: particles, surface, sheet or oriented.
import * as THREE from 'three';
import { Discs } from './discs.js';
import { Meshes } from './meshes.js';
import { Spheres } from './spheres.js';

const SPHERE = 0.6; // radius over spacing: neighbours overlap
const DISC = 0.9; // radius of a disc over that of the surfel: larger ones stick out where the surface bends

/// Returns the arrays of a mesh with colours and field of the nearest surfels.
function withFields(mesh, surfels) {
  const { data: nearest, rows } = mesh.surfel,
    arrays = { ...mesh };
  for (const name of ['colour', 'value', 'label']) {
    const from = surfels[name];
    if (!from) continue;
    const width = from.components,
      data = new from.data.constructor(rows * width);
    for (let k = 0; k < rows; k++)
      for (let c = 0; c < width; c++) data[k * width + c] = from.data[nearest[k] * width + c];
    arrays[name] = { data, components: width, rows };
  }
  return arrays;
}

export class Layer {
  constructor(type) {
    this.type = type;
    this.group = new THREE.Group();
    this.group.visible = false;
    this.packet = null;
    this.meshed = false; // shown as triangles, not as discs
    if (type === 'particles') this.spheres = new Spheres();
    else this.discs = new Discs();
    if (type !== 'particles') this.meshes = new Meshes();
    for (const mesh of [this.spheres?.mesh, this.spheres?.points, this.meshes?.mesh, this.meshes?.lines])
      if (mesh) this.group.add(mesh);
  }

  /// spacing: m, of the particles. look: 'mesh' or 'discs'. mesh: of a surface, or null.
  show(packet, spacing, look, mesh) {
    this.packet = packet;
    this.mesh = mesh;
    this.look = look;
    const shown = 2 ** (packet?.header.level ?? 0); // one of so many points is drawn
    this.setVisible(Boolean(packet));
    if (!packet) return;
    const triangles = mesh ? withFields(mesh.arrays, packet.arrays) : packet.arrays;
    const meshed = Boolean(
      this.meshes && triangles.triangles && (look === 'mesh' || this.type === 'sheet'),
    );
    this.spheres?.show(packet, SPHERE * spacing * Math.cbrt(shown));
    // Discs of fewer points cover the same surface.
    if (!meshed) this.discs?.show(packet, DISC * Math.sqrt(shown));
    if (meshed) this.meshes.show(triangles);
    this.meshed = meshed;
    this.setVisible(true);
  }

  /// Discs are in a scene of their own (splats.js).
  setVisible(visible) {
    this.group.visible = visible;
    if (this.discs) this.discs.mesh.visible = visible && !this.meshed;
    this.meshes?.setVisible(visible && this.meshed);
  }

  /// Prepares the objects for the given quality. height: of the picture, pixels.
  prepare(quality, height) {
    if (!this.group.visible) return;
    this.spheres?.prepare(quality, height);
    this.meshes?.prepare(quality);
  }

  /// What picking draws.
  pickable() {
    if (!this.group.visible) return null;
    const drawn = [this.spheres, this.discs, this.meshes].find((d) => d?.mesh.visible);
    return drawn && { type: this.type, mesh: drawn.mesh, material: drawn.pickMaterial };
  }

  /// Index of a point of the packet by the index that picking gives.
  pointOf(index) {
    return this.meshed && this.mesh ? this.mesh.arrays.surfel.data[index] : index;
  }

  setPlain(colour) {
    for (const drawn of [this.spheres, this.discs, this.meshes]) drawn?.uniforms.plain.value.set(...colour);
  }

  /// Position of a point of the packet, by its index.
  position(index) {
    const { data } = this.packet.arrays.position;
    return new THREE.Vector3(data[3 * index], data[3 * index + 1], data[3 * index + 2]);
  }
}
