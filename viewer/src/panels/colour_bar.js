// SPDX-License-Identifier: Apache-2.0
// Colours of the field with their values.
import { make } from '../dom.js';
import { labelColour, paletteOf } from '../scene/colour_maps.js';
import { numberText } from '../text.js';

const MOST_LABELS = 12;

/// Returns about five round numbers between two others, `least` or more apart.
export function ticksOf(min, max, least = 0) {
  if (!(max > min)) return [min];
  const rough = (max - min) / 5,
    power = 10 ** Math.floor(Math.log10(rough));
  const round = [1, 2, 5, 10].map((k) => k * power).find((s) => s >= rough);
  const step = Math.max(round, least);
  const ticks = [];
  for (let k = Math.ceil(min / step - 1e-9); k * step <= max + 1e-9 * step; k++) ticks.push(k * step);
  return ticks;
}

export class ColourBar {
  constructor(parent) {
    this.parent = parent;
  }

  hide() {
    this.parent.hidden = true;
  }

  /// whole: all values are integers, and so are the ticks.
  showValues({ title, unit, min, max, map, whole }) {
    const palette = paletteOf(map);
    const canvas = make('canvas', { width: 1, height: 256 });
    const context = canvas.getContext('2d'),
      picture = context.createImageData(1, 256);
    for (let k = 0; k < 256; k++) picture.data.set(palette.subarray(4 * (255 - k), 4 * (256 - k)), 4 * k);
    context.putImageData(picture, 0, 0);
    const share = (v) => (max > min ? (v - min) / (max - min) : 0);
    const ticks = ticksOf(min, max, whole ? 1 : 0).map((v) =>
      make('span', {
        className: 'tick',
        textContent: numberText(Number(v.toPrecision(6))),
        style: { bottom: `${100 * share(v)}%` },
      }),
    );
    this.parent.replaceChildren(
      make('div', {
        className: 'bar-title',
        textContent: unit && unit !== '1' ? `${title} (${unit})` : title,
      }),
      make('div', { className: 'bar' }, canvas, make('div', { className: 'ticks' }, ...ticks)),
    );
    this.parent.hidden = false;
  }

  /// labels: Set of the labels in the picture.
  showLabels(title, labels) {
    const all = [...labels].sort((a, b) => a - b);
    const entries = all
      .slice(0, MOST_LABELS)
      .map((label) =>
        make(
          'div',
          { className: 'label' },
          make('i', { style: { background: `rgb(${labelColour(label).map((c) => Math.round(255 * c))})` } }),
          label < 2 ** 31 ? String(label) : '…',
        ),
      );
    if (all.length > MOST_LABELS)
      entries.push(make('div', { textContent: `and ${all.length - MOST_LABELS} more` }));
    this.parent.replaceChildren(make('div', { className: 'bar-title', textContent: title }), ...entries);
    this.parent.hidden = false;
  }
}
