// SPDX-License-Identifier: Apache-2.0
// Meshes of surfaces. The server needs time for each. One is requested at a time, the newest query first.
import { getPacket } from './api.js';
import { FrameStore } from './frame_store.js';
import { Problem } from './problem.js';

const MOST_WAITING = 4; // older queries are dropped

export class MeshStore extends FrameStore {
  constructor() {
    super();
    this.waiting = [];
    this.busy = false;
  }

  /// Resolves with null in a page without meshes.
  request(query) {
    return new Promise((resolve, reject) => {
      this.waiting.push({ query, resolve, reject });
      while (this.waiting.length > MOST_WAITING) this.waiting.shift().reject(new Problem('no longer wanted'));
      this.next();
    });
  }

  async next() {
    if (this.busy || this.waiting.length === 0) return;
    const { query, resolve, reject } = this.waiting.pop();
    this.busy = true;
    await getPacket('mesh', query).then(resolve, reject);
    this.busy = false;
    this.next();
  }
}
