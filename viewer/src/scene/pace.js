// SPDX-License-Identifier: Apache-2.0
// Quality of pictures in motion, chosen by their cost.

/// Qualities, the best first. quick: shaders without depths of spheres, blending and smooth edges. coarse:
/// fewer points and triangles. share: of the pixels of the page, a side.
export const QUALITIES = [
  { quick: false, coarse: false, share: 1 },
  { quick: true, coarse: false, share: 1 },
  { quick: true, coarse: true, share: 0.75 },
  { quick: true, coarse: true, share: 0.5 },
];
export const FULL = QUALITIES[0];

const SLOW = 26, // ms of a picture: 30 pictures a second leave some time for the page itself
  QUICK = 11, // ms: below it, a better quality is tried
  MANY = 15, // pictures before one is tried
  FIRST_WAIT = 4000, // ms before a quality that was too slow is tried again; twice as long each time
  LONGEST_WAIT = 64000;

export class Pace {
  constructor() {
    this.level = 0;
    this.refused = QUALITIES.map(() => ({ until: -Infinity, wait: FIRST_WAIT }));
    this.restart();
  }

  get quality() {
    return QUALITIES[this.level];
  }

  /// Forgets the costs of the present quality.
  restart() {
    this.mean = 0;
    this.count = 0;
  }

  /// Records the cost of a picture in motion (ms), and adapts the quality. now: ms.
  add(cost, now) {
    this.count++;
    this.mean = this.count === 1 ? cost : 0.7 * this.mean + 0.3 * cost;
    const slow = this.count > 2 ? this.mean > SLOW : this.mean > 3 * SLOW;
    if (slow) this.lower(now);
    else if (this.count >= MANY && this.mean < QUICK) this.raise(now);
  }

  lower(now) {
    if (this.level + 1 === QUALITIES.length) return;
    const refused = this.refused[this.level];
    refused.until = now + refused.wait;
    refused.wait = Math.min(LONGEST_WAIT, 2 * refused.wait);
    this.level++;
    this.restart();
  }

  raise(now) {
    if (this.level === 0 || now < this.refused[this.level - 1].until) return;
    this.level--;
    this.restart();
  }
}
