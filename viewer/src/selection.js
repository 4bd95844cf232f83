// SPDX-License-Identifier: Apache-2.0
// The picked point: a ring around it, and its fields. It is followed by its id from frame to frame.
import { Vector3 } from 'three';
import { getJson } from './data/api.js';
import { byId } from './dom.js';
import { PointPanel } from './panels/point_panel.js';

const CLICK = 4; // pixels: a longer way of the pointer turns the camera

export class Selection {
  constructor(app) {
    this.app = app;
    this.point = null; // {type, id, position}
    this.panel = new PointPanel(byId('point-panel'), () => this.clear());
    this.marker = byId('marker');
    const { canvas } = app.stage;
    canvas.addEventListener('pointerdown', (event) => {
      this.down = [event.clientX, event.clientY];
    });
    canvas.addEventListener('pointerup', (event) => this.up(event));
    document.addEventListener('keydown', (event) => {
      if (event.key === 'Escape') this.clear();
    });
  }

  up(event) {
    if (!this.down || event.button !== 0) return;
    const way = Math.hypot(event.clientX - this.down[0], event.clientY - this.down[1]);
    if (way > CLICK) return;
    const { left, top } = this.app.stage.canvas.getBoundingClientRect();
    const found = this.app.stage.pick(event.clientX - left, event.clientY - top);
    if (found) this.load(found.type, { index: found.index });
    else this.clear();
  }

  clear() {
    this.point = null;
    this.panel.hide();
    this.place();
  }

  async load(type, which) {
    const { app } = this;
    const query = { ...app.queryOf(app.settings.frame, type), field: undefined, part: undefined };
    const details = await getJson('point', { ...query, ...which });
    this.point = { type, id: details.id, position: new Vector3(...details.position) };
    this.panel.show(details);
    this.place();
  }

  /// Reads the fields of the point in a new frame.
  async update() {
    const { point } = this;
    if (!point || point.id === undefined) return;
    try {
      await this.load(point.type, { id: point.id });
    } catch (problem) {
      // it is not there yet, or has left
      if (this.point !== point) return;
      this.point = { ...point, position: null };
      this.panel.showProblem(problem.message);
      this.place();
    }
  }

  /// Moves the ring to the point.
  place() {
    const at = this.point?.position && this.app.stage.onPage(this.point.position);
    this.marker.hidden = !at;
    if (at) this.marker.style.transform = `translate(${at.x}px, ${at.y}px)`;
  }
}
