// SPDX-License-Identifier: Apache-2.0
// Fewer points and triangles of the same shape, for pictures in motion when full detail is too slow.

const MOST_POINTS = 18000,
  MOST_VERTICES = 8000,
  MOST_CELLS = 2 ** 23;

/// A grid of cubes around points.
class Grid {
  /// positions: three numbers each. cell: target edge length, m.
  constructor(positions, cell) {
    const low = [Infinity, Infinity, Infinity],
      high = [-Infinity, -Infinity, -Infinity];
    for (let k = 0; k < positions.length; k++) {
      const c = k % 3;
      if (positions[k] < low[c]) low[c] = positions[k];
      if (positions[k] > high[c]) high[c] = positions[k];
    }
    // plus a border of empty cells
    const cellsOf = (edge) => low.map((from, c) => Math.floor((high[c] - from) / edge) + 3);
    const product = ([x, y, z]) => x * y * z;
    let edge = Math.max(cell, 1e-30);
    while (product(cellsOf(edge)) > MOST_CELLS) edge *= 1.3;
    this.low = low;
    this.scale = 1 / edge;
    this.counts = cellsOf(edge);
    this.size = product(this.counts);
  }

  /// Returns the number of the cell of a point by the index of its first number.
  at(positions, k) {
    const [x, y, z] = this.low,
      [nx, ny] = this.counts;
    const i = 1 + Math.floor((positions[k] - x) * this.scale),
      j = 1 + Math.floor((positions[k + 1] - y) * this.scale),
      l = 1 + Math.floor((positions[k + 2] - z) * this.scale);
    return i + nx * (j + ny * l);
  }
}

/// Returns a number from 0 to 1 that leaves no pattern.
function hashOf(number) {
  let h = Math.imul(number ^ 0x9e3779b9, 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return ((h ^ (h >>> 16)) >>> 0) / 2 ** 32;
}

/// Returns {index, share}: points near an empty cell, which hide all others, and the fraction drawn. size:
/// radius of the spheres, m, which overlap.
export function exposedPoints({ data, rows }, size) {
  const grid = new Grid(data, 2.5 * size),
    [nx, ny] = grid.counts;
  const full = new Uint8Array(grid.size),
    cells = new Uint32Array(rows);
  for (let k = 0; k < rows; k++) full[(cells[k] = grid.at(data, 3 * k))] = 1;
  const around = [];
  for (let z = -1; z <= 1; z++)
    for (let y = -1; y <= 1; y++) for (let x = -1; x <= 1; x++) around.push(x + nx * (y + ny * z));
  const hidden = new Uint8Array(grid.size); // 1: no neighbour is empty, 2: one is
  const isHidden = (cell) => {
    if (hidden[cell] === 0) hidden[cell] = around.every((step) => full[cell + step] === 1) ? 1 : 2;
    return hidden[cell] === 1;
  };
  const index = new Uint32Array(rows);
  let count = 0;
  for (let k = 0; k < rows; k++) if (!isHidden(cells[k])) index[count++] = k;
  const share = Math.min(1, MOST_POINTS / Math.max(1, count));
  let drawn = 0;
  for (let k = 0; k < count; k++) if (hashOf(index[k]) <= share) index[drawn++] = index[k];
  return { index: index.slice(0, drawn), share };
}

/// Returns corners of triangles between fewer vertices: each grid cell keeps one.
export function coarseTriangles({ data, rows }, { data: corners }) {
  if (rows <= MOST_VERTICES) return corners;
  let length = 0,
    edges = 0;
  for (let k = 0; k + 2 < corners.length; k += 3 * 64, edges++) {
    const [a, b] = [3 * corners[k], 3 * corners[k + 1]];
    length += Math.hypot(data[a] - data[b], data[a + 1] - data[b + 1], data[a + 2] - data[b + 2]);
  }
  const grid = new Grid(data, (length / Math.max(1, edges)) * Math.sqrt(rows / MOST_VERTICES));
  const firsts = new Map(),
    leaders = new Uint32Array(rows);
  for (let k = 0; k < rows; k++) {
    const cell = grid.at(data, 3 * k);
    if (!firsts.has(cell)) firsts.set(cell, k);
    leaders[k] = firsts.get(cell);
  }
  const coarse = new Uint32Array(corners.length);
  let count = 0;
  for (let k = 0; k < corners.length; k += 3) {
    const a = leaders[corners[k]],
      b = leaders[corners[k + 1]],
      c = leaders[corners[k + 2]];
    if (a === b || b === c || c === a) continue;
    coarse[count++] = a;
    coarse[count++] = b;
    coarse[count++] = c;
  }
  return coarse.slice(0, count);
}
