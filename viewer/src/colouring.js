// SPDX-License-Identifier: Apache-2.0
// Range of the colours, and the fields that can give them.

export class Colouring {
  constructor() {
    this.reset('');
  }

  /// key: names the field; ranges of another one count no more.
  reset(key) {
    this.key = key;
    this.seen = { min: Infinity, max: -Infinity };
    this.unit = '';
  }

  /// Widens the range by a packet's header.
  add({ field }) {
    if (field?.min === undefined) return;
    this.unit = field.unit;
    this.seen.min = Math.min(this.seen.min, field.min);
    this.seen.max = Math.max(this.seen.max, field.max);
  }

  /// chosen: {min, max}, null where it is that of the frames that were shown.
  range(chosen) {
    const any = this.seen.min <= this.seen.max;
    return { min: chosen.min ?? (any ? this.seen.min : 0), max: chosen.max ?? (any ? this.seen.max : 1) };
  }
}

/// Returns the fields of several packets, each once.
export function fieldsOf(packets) {
  const fields = new Map();
  for (const { header } of packets) for (const field of header.fields) fields.set(field.name, field);
  return [...fields.values()].sort((a, b) => (a.name < b.name ? -1 : 1));
}

export const titleOf = ({ name, part }) => {
  const parts =
    name.endsWith('stress') || name.endsWith('strain')
      ? ['xx', 'yy', 'zz', 'xy', 'yz', 'xz']
      : ['x', 'y', 'z', 'w'];
  return part < 0 ? name : `${name} ${parts[part] ?? part}`;
};
