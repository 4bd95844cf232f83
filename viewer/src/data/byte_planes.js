// SPDX-License-Identifier: Apache-2.0
// Numbers of pages without a server: io/view/page/byte_planes.hpp.

/// Returns {low, high}: whole numbers of `rows` rows, and their upper 32 bits if they are 8 bytes wide.
export function wholeOf(planes, { components, rows, width }) {
  const count = rows * components;
  const low = new Uint32Array(count),
    high = width === 8 ? new Uint32Array(count) : null;
  const mask = width >= 4 ? 0xffffffff : 2 ** (8 * width) - 1;
  for (let c = 0; c < components; c++) {
    const byte = (b, i) => planes[(c * width + b) * rows + i];
    let before = 0,
      upper = 0;
    for (let i = 0; i < rows; i++) {
      let step = 0;
      for (let b = 0; b < Math.min(4, width); b++) step += byte(b, i) * 2 ** (8 * b);
      const sum = before + step;
      before = (sum & mask) >>> 0;
      low[i * components + c] = before;
      if (!high) continue;
      let more = sum > 0xffffffff ? 1 : 0;
      for (let b = 4; b < 8; b++) more += byte(b, i) * 2 ** (8 * (b - 4));
      upper = (upper + more) >>> 0;
      high[i * components + c] = upper;
    }
  }
  return { low, high };
}

/// Returns dequantised numbers; NaN for those that were not finite.
export function numbersOf(planes, column) {
  const { low: codes } = wholeOf(planes, column),
    { components, width, low, step } = column;
  const none = 2 ** (8 * width) - 1,
    numbers = new Float32Array(codes.length);
  for (let k = 0; k < codes.length; k++) {
    const c = k % components;
    numbers[k] = codes[k] === none ? NaN : low[c] + step[c] * codes[k];
  }
  return numbers;
}

/// Returns unit vectors of four components each, as in packets of the server.
export function normalsOf(planes, column) {
  const { low: codes } = wholeOf(planes, column),
    normals = new Int16Array(4 * column.rows);
  for (let i = 0; i < column.rows; i++) {
    let u = codes[2 * i] / 511 - 1,
      v = codes[2 * i + 1] / 511 - 1;
    const z = 1 - Math.abs(u) - Math.abs(v);
    if (z < 0) {
      const folded = (1 - Math.abs(v)) * (u < 0 ? -1 : 1);
      v = (1 - Math.abs(u)) * (v < 0 ? -1 : 1);
      u = folded;
    }
    const scale = 32767 / Math.hypot(u, v, z);
    normals.set([u * scale, v * scale, z * scale], 4 * i);
  }
  return normals;
}
