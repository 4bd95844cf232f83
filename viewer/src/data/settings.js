// SPDX-License-Identifier: Apache-2.0
// What the page shows. Parts of the page change it and listen to it.

const STORED = 'thaw-view';

export class Settings {
  constructor() {
    this.listeners = new Set();
    this.layers = {
      particles: true,
      surface: true,
      sheet: true,
      oriented: true,
      obstacles: true,
      domain: true,
      emitters: true,
      clamps: true,
      camera: false,
    };
    this.look = 'mesh'; // surfaces and oriented particles as mesh or discs
    this.field = { name: '', part: -1 }; // '': own colours
    this.map = 'ember';
    this.range = { min: null, max: null }; // null: over the frames that were shown
    this.cut = { axis: '', share: 0.5, flip: false };
    this.most = 100000;
    this.frame = -1; // index in the list of frames
    this.follow = true;
    this.playing = false;
    this.rate = 12; // frames a second
    this.theme = this.stored().theme ?? 'auto'; // auto, light, dark
  }

  stored() {
    try {
      return JSON.parse(localStorage.getItem(STORED)) ?? {};
    } catch {
      return {}; // no storage, as in a private window
    }
  }

  /// listener(changed): names of the changed members.
  listen(listener) {
    this.listeners.add(listener);
  }

  change(values) {
    const changed = new Set();
    for (const [name, value] of Object.entries(values)) {
      if (JSON.stringify(this[name]) === JSON.stringify(value)) continue;
      this[name] = value;
      changed.add(name);
    }
    if (changed.has('theme')) {
      try {
        localStorage.setItem(STORED, JSON.stringify({ theme: this.theme }));
      } catch {
        // the choice lasts as long as the page
      }
    }
    if (changed.size > 0) for (const listener of this.listeners) listener(changed);
  }
}
