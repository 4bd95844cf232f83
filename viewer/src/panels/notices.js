// SPDX-License-Identifier: Apache-2.0
// Short messages at the lower edge of the picture, each under its name.
import { make } from '../dom.js';

export class Notices {
  constructor(parent) {
    this.parent = parent;
    this.texts = new Map();
  }

  /// Sets a message, or removes it if the text is empty.
  set(name, text, problem = false) {
    const value = JSON.stringify([text, problem]);
    if ((this.texts.get(name) ?? '') === value || (!text && !this.texts.has(name))) return;
    if (text) this.texts.set(name, value);
    else this.texts.delete(name);
    this.parent.replaceChildren(
      ...[...this.texts].map(([key, entry]) => {
        const [message, bad] = JSON.parse(entry);
        return make('p', { className: bad ? 'problem' : '', textContent: message, dataset: { notice: key } });
      }),
    );
  }
}
