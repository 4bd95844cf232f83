// SPDX-License-Identifier: Apache-2.0
// Choices of the picture: layers, colours, cut plane, camera.
import { pageData } from '../data/api.js';
import { make, setOptions } from '../dom.js';
import { mapNames } from '../scene/colour_maps.js';
import { numberText } from '../text.js';

const LAYER_NAMES = {
  particles: 'particles',
  surface: 'surface',
  sheet: 'sheets',
  oriented: 'oriented bodies',
  obstacles: 'obstacles',
  domain: 'domain',
  emitters: 'emitters',
  clamps: 'clamps',
  camera: 'camera',
};
const TENSOR = ['xx', 'yy', 'zz', 'xy', 'yz', 'xz'];
const POINTS = [20000, 50000, 100000, 200000, 500000, 1000000, 5000000];

function partsOf(components) {
  if (components === 1) return [];
  const names =
    components === 6 ? TENSOR : components === 3 ? ['x', 'y', 'z'] : [...Array(components).keys()];
  return [['-1', components === 6 ? 'norm' : 'length'], ...names.map((name, k) => [String(k), String(name)])];
}

/// A labelled row of a panel.
const row = (text, ...inputs) =>
  make('label', { className: 'row' }, make('span', { textContent: text }), ...inputs);

export class ViewPanel {
  /// actions: {sceneCamera, fit, copyCamera}.
  constructor(parent, settings, actions) {
    this.parent = parent;
    this.settings = settings;
    this.layers = make('div', { className: 'layers' });
    this.field = make('select', {
      id: 'field',
      title: 'source of the colours',
      onchange: () => this.chooseField(),
    });
    this.part = make('select', { id: 'part', title: 'component', onchange: () => this.chooseField() });
    this.partRow = row('component', this.part);
    this.map = make('select', {
      id: 'map',
      title: 'colour map',
      onchange: () => settings.change({ map: this.map.value }),
    });
    setOptions(
      this.map,
      mapNames.map((name) => [name, name]),
      settings.map,
    );
    this.min = this.rangeInput('range-min', 'lowest colour');
    this.max = this.rangeInput('range-max', 'highest colour');
    this.axis = make('select', {
      id: 'cut',
      title: 'normal of the cut plane',
      onchange: () => this.chooseCut(),
    });
    setOptions(
      this.axis,
      [
        ['', 'none'],
        ['x', 'x'],
        ['y', 'y'],
        ['z', 'z'],
      ],
      settings.cut.axis,
    );
    this.share = make('input', {
      id: 'cut-share',
      type: 'range',
      min: 0,
      max: 1,
      step: 0.002,
      value: settings.cut.share,
      title: 'place of the cut plane',
      oninput: () => this.chooseCut(),
    });
    this.flip = make('input', {
      id: 'cut-flip',
      type: 'checkbox',
      title: 'other side',
      onchange: () => this.chooseCut(),
    });
    this.most = make('select', {
      id: 'most',
      title: 'points that are drawn of each type, about',
      onchange: () => settings.change({ most: Number(this.most.value) }),
    });
    setOptions(
      this.most,
      POINTS.map((n) => [String(n), n.toLocaleString('en-GB')]),
      String(settings.most),
    );
    this.mostRow = row('points', this.most);
    this.mostRow.hidden = pageData !== null; // a page has a fixed choice of points
    this.look = make('select', {
      id: 'look',
      title: 'look of surfaces and oriented bodies',
      onchange: () => settings.change({ look: this.look.value }),
    });
    setOptions(
      this.look,
      [
        ['mesh', 'mesh'],
        ['discs', 'discs'],
      ],
      settings.look,
    );
    this.lookRow = row('drawn as', this.look);
    this.camera = make('input', {
      id: 'camera-line',
      readOnly: true,
      hidden: true,
      title: 'line of a scene',
      onfocus: () => this.camera.select(),
    });
    this.copy = make('button', {
      id: 'copy-camera',
      textContent: 'copy',
      title: 'copies a line for the scene',
      onclick: actions.copyCamera,
    });
    this.sceneCamera = make('button', {
      id: 'scene-camera',
      textContent: 'scene',
      title: 'camera of the scene',
      onclick: actions.sceneCamera,
    });
    this.theme = make('button', {
      id: 'theme',
      title: 'light or dark',
      textContent: '◐',
      onclick: actions.theme,
    });
    const body = make(
      'div',
      { className: 'body' },
      this.layers,
      row('colours', this.field),
      this.partRow,
      row('map', this.map),
      row('range', this.min, this.max),
      row('cut plane', this.axis, this.share, this.flip),
      this.mostRow,
      this.lookRow,
      make(
        'div',
        { className: 'row' },
        make('span', { textContent: 'camera' }),
        this.sceneCamera,
        make('button', { id: 'fit', textContent: 'fit', title: 'shows all points', onclick: actions.fit }),
        this.copy,
      ),
      this.camera,
    );
    this.title = make('strong', { id: 'title' });
    parent.prepend(
      make(
        'header',
        {},
        this.title,
        this.theme,
        make('button', {
          id: 'fold',
          textContent: '–',
          title: 'folds this panel',
          onclick: (event) => this.fold(body, event.target),
        }),
      ),
      body,
    );
    settings.listen(() => this.update());
  }

  fold(body, button) {
    body.hidden = !body.hidden;
    this.parent.classList.toggle('folded', body.hidden);
    button.textContent = body.hidden ? '☰' : '–';
  }

  rangeInput(id, title) {
    return make('input', {
      id,
      title: `${title}; empty: of the frames that were shown`,
      inputMode: 'decimal',
      placeholder: 'auto',
      onchange: () => this.chooseRange(),
    });
  }

  /// present: names of layers of the run. fields: [{name, unit, components, label}]. own: whether points have
  /// own colours.
  describe({ present, fields, own }) {
    this.fields = fields;
    const choices = fields.map(({ name, unit }) => [name, unit && unit !== '1' ? `${name} (${unit})` : name]);
    this.choices = [...(own ? [['', 'own colours']] : [['', 'none']]), ...choices];
    this.layers.replaceChildren(
      ...Object.entries(LAYER_NAMES)
        .filter(([name]) => present.includes(name))
        .map(([name, text]) =>
          make(
            'label',
            {},
            make('input', {
              type: 'checkbox',
              id: `layer-${name}`,
              checked: this.settings.layers[name],
              onchange: (event) =>
                this.settings.change({ layers: { ...this.settings.layers, [name]: event.target.checked } }),
            }),
            text,
          ),
        ),
    );
    this.lookRow.hidden = !present.includes('oriented') && !present.includes('surface');
    this.update();
  }

  update() {
    const { field, range, cut } = this.settings;
    this.look.value = this.settings.look;
    this.axis.value = cut.axis;
    this.share.value = cut.share;
    this.share.disabled = cut.axis === '';
    this.flip.checked = cut.flip;
    if (this.choices) setOptions(this.field, this.choices, field.name);
    const parts = partsOf(this.fields?.find((f) => f.name === field.name)?.components ?? 1);
    setOptions(this.part, parts, String(field.part));
    this.partRow.hidden = parts.length === 0;
    for (const [input, value] of [
      [this.min, range.min],
      [this.max, range.max],
    ])
      if (document.activeElement !== input) input.value = value === null ? '' : numberText(value);
  }

  chooseField() {
    const name = this.field.value,
      same = name === this.settings.field.name;
    const part = same && this.part.value !== '' ? Number(this.part.value) : -1;
    this.settings.change({ field: { name, part }, range: { min: null, max: null } });
  }

  chooseRange() {
    const number = (input) =>
      input.value.trim() === '' || !Number.isFinite(Number(input.value)) ? null : Number(input.value);
    this.settings.change({ range: { min: number(this.min), max: number(this.max) } });
  }

  chooseCut() {
    this.settings.change({
      cut: { axis: this.axis.value, share: Number(this.share.value), flip: this.flip.checked },
    });
  }

  /// Shows the line that was copied, or that the user must copy by hand.
  showCamera(line, copied) {
    this.camera.hidden = false;
    this.camera.value = line;
    this.copy.textContent = copied ? 'copied' : 'copy';
    setTimeout(() => {
      this.copy.textContent = 'copy';
    }, 2000);
  }
}
