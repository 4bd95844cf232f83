// SPDX-License-Identifier: Apache-2.0
// Packets of frames, loaded on demand and kept up to a number of bytes.
import { getPacket } from './api.js';

const MOST_BYTES = 400e6;

export class FrameStore {
  constructor() {
    this.packets = new Map(); // by key, the least recently used first
    this.loading = new Map();
    this.bytes = 0;
  }

  /// Forgets all packets: the run has been repeated from an earlier frame.
  clear() {
    this.packets.clear();
    this.loading.clear();
    this.bytes = 0;
  }

  /// query: {number, type, field, part, most}. Rejects with a Problem.
  load(query) {
    const key = JSON.stringify(query);
    const known = this.packets.get(key);
    if (known) {
      this.packets.delete(key);
      this.packets.set(key, known);
      return Promise.resolve(known);
    }
    if (!this.loading.has(key)) this.loading.set(key, this.fetch(query, key));
    return this.loading.get(key);
  }

  request(query) {
    return getPacket('frame', query);
  }

  async fetch(query, key) {
    try {
      const packet = await this.request(query);
      if (packet && this.loading.has(key)) this.keep(key, packet);
      return packet;
    } finally {
      this.loading.delete(key);
    }
  }

  keep(key, packet) {
    this.packets.set(key, packet);
    this.bytes += packet.bytes;
    for (const [oldest, { bytes }] of this.packets) {
      if (this.bytes <= MOST_BYTES || oldest === key) break;
      this.packets.delete(oldest);
      this.bytes -= bytes;
    }
  }
}
