// SPDX-License-Identifier: Apache-2.0
// Answers the requests of the page from data within it: pages of `thaw export --as html` and
// `thaw preview --html` have no server.
import { normalsOf, numbersOf, wholeOf } from './byte_planes.js';
import { decodePacket } from './packet.js';
import { Problem } from './problem.js';

const MOST_FRAMES = 24; // most unpacked frames that are kept

const elementOf = (name) => document.getElementById(`data-${name}`);

export const hasData = () => elementOf('run') !== null;

/// Returns the bytes of a block, or null without one.
async function blockOf(name) {
  const element = elementOf(name);
  if (!element) return null;
  const bytes = Uint8Array.from(atob(element.textContent), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Response(stream).arrayBuffer();
}

/// Returns the arrays of a frame as the server sends them, and its fields by name.
function unpack({ header, arrays }) {
  const shown = {},
    fields = new Map();
  const units = new Map(header.fields.map((field) => [field.name, field]));
  for (const [name, column] of Object.entries(header.columns ?? {})) {
    const planes = arrays[name].data,
      { components, rows } = column;
    const add = (data, width = components) => (shown[name] = { data, components: width, rows });
    if (name === 'id') fields.set('id', wholeOf(planes, column));
    else if (name.startsWith('field:')) {
      const known = units.get(name.slice(6));
      const data = known.label ? wholeOf(planes, column).low : numbersOf(planes, column);
      fields.set(known.name, { ...known, components, data });
    } else if (name === 'normal') add(normalsOf(planes, column), 4);
    else if (name === 'colour') {
      const colours = new Uint8Array(4 * rows).fill(255),
        { low } = wholeOf(planes, column);
      for (let k = 0; k < low.length; k++) colours[4 * Math.floor(k / 3) + (k % 3)] = low[k];
      add(colours, 4);
    } else if (column.step) add(numbersOf(planes, column));
    else add(wholeOf(planes, column).low);
  }
  return { header, shown, fields };
}

/// Returns a component of a field; part < 0: the length of a vector, the norm of a tensor.
function valuesOf({ data, components }, rows, part) {
  const values = new Float32Array(rows);
  for (let i = 0; i < rows; i++) {
    if (part >= 0 || components === 1) {
      values[i] = data[i * components + Math.max(0, part)];
      continue;
    }
    let sum = 0;
    for (let c = 0; c < components; c++)
      sum += (components === 6 && c >= 3 ? 2 : 1) * data[i * components + c] ** 2;
    values[i] = Math.sqrt(sum);
  }
  return values;
}

/// Returns {header, arrays, bytes} with one field for the colours.
function packetOf({ header, shown, fields }, { field: name, part = -1 }) {
  const arrays = { ...shown },
    { rows } = shown.position,
    field = fields.get(name);
  const described = { ...header };
  if (field?.label) arrays.label = { data: field.data, components: 1, rows };
  else if (field) {
    const data = valuesOf(field, rows, part);
    let min = Infinity,
      max = -Infinity;
    for (const v of data) if (Number.isFinite(v)) [min, max] = [Math.min(min, v), Math.max(max, v)];
    described.field = { name, part, unit: field.unit, ...(min <= max ? { min, max } : {}) };
    arrays.value = { data, components: 1, rows };
  }
  const bytes = Object.values(arrays).reduce((sum, { data }) => sum + data.byteLength, 0);
  return { header: described, arrays, bytes };
}

const idOf = (ids, i) =>
  ids.high ? String((BigInt(ids.high[i]) << 32n) | BigInt(ids.low[i])) : String(ids.low[i]);

function indexOf({ fields, shown }, { index, id }) {
  if (index !== undefined) return index;
  const ids = fields.get('id');
  for (let i = 0; ids && i < shown.position.rows; i++) if (idOf(ids, i) === id) return i;
  throw new Problem(`no point with id ${id} in this frame`);
}

/// Returns the reply of api/point.
function detailsOf(frame, query) {
  const i = indexOf(frame, query),
    ids = frame.fields.get('id');
  const { data } = frame.shown.position;
  const fields = [...frame.fields]
    .filter(([name]) => name !== 'id')
    .map(([name, field]) => ({
      name,
      unit: field.unit,
      values: [...field.data.subarray(i * field.components, (i + 1) * field.components)].map((v) =>
        Number.isFinite(v) ? Number(v.toPrecision(3)) : String(v),
      ),
    }));
  return {
    type: query.type,
    time: frame.header.time,
    index: i,
    position: [...data.subarray(3 * i, 3 * i + 3)],
    fields,
    ...(ids ? { id: idOf(ids, i) } : {}),
  };
}

export class PageData {
  constructor() {
    this.frames = new Map(); // promises of unpacked frames, the least recently used first
  }

  async about() {
    this.run ??= blockOf('run').then((buffer) => JSON.parse(new TextDecoder().decode(buffer)));
    return this.run;
  }

  frame({ number, type }) {
    const name = `${number}-${type}`;
    const frame = this.frames.get(name) ?? this.read(name);
    this.frames.delete(name);
    this.frames.set(name, frame);
    if (this.frames.size > MOST_FRAMES) this.frames.delete(this.frames.keys().next().value);
    return frame;
  }

  async read(name) {
    const buffer = await blockOf(name);
    if (!buffer) throw new Problem('this frame is not in the page');
    return unpack(decodePacket(buffer));
  }

  async getJson(name, query) {
    const { run, scene, logs } = await this.about();
    if (name === 'scene') return scene;
    if (name === 'log') {
      const log = logs[query.file] ?? { bytes: -1, rows: 0, columns: {} };
      return query.known === log.bytes ? { ...log, same: true } : log;
    }
    if (name === 'point') return detailsOf(await this.frame(query), query);
    if (name !== 'run') throw new Problem(`there is no ${name} in this page`);
    return query.frames === run.frames.revision ? { ...run, frames: undefined } : run;
  }

  /// Returns the mesh of a frame; null in a page without meshes.
  async mesh({ number }) {
    const buffer = await blockOf(`${number}-mesh`);
    if (!buffer) return null;
    const { header, shown } = unpack(decodePacket(buffer));
    return { header, arrays: shown, bytes: buffer.byteLength };
  }

  async getPacket(name, query) {
    if (name === 'mesh') return this.mesh(query);
    return name === 'frame' ? packetOf(await this.frame(query), query) : decodePacket(await blockOf(name));
  }
}
