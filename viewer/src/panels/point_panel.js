// SPDX-License-Identifier: Apache-2.0
// The picked point: its id and all fields.
import { make } from '../dom.js';
import { numberText } from '../text.js';

export class PointPanel {
  constructor(parent, onClose) {
    this.parent = parent;
    this.onClose = onClose;
  }

  hide() {
    this.parent.hidden = true;
  }

  /// details: of api/point.
  show(details) {
    const row = (name, values, unit) =>
      make(
        'tr',
        {},
        make('th', { textContent: name }),
        make('td', { textContent: values.map((v) => numberText(v)).join(', ') }),
        make('td', { textContent: unit === '1' ? '' : unit }),
      );
    this.parent.replaceChildren(
      make(
        'header',
        {},
        make('strong', { textContent: `${details.type}, id ${details.id ?? 'none'}` }),
        make('button', { id: 'unpick', textContent: '×', title: 'closes', onclick: this.onClose }),
      ),
      make(
        'table',
        {},
        row('position', details.position, 'm'),
        ...details.fields.map((f) => row(f.name, f.values, f.unit)),
      ),
    );
    this.parent.hidden = false;
  }

  showProblem(text) {
    this.parent.querySelector('table')?.replaceChildren(make('tr', {}, make('td', { textContent: text })));
  }
}
