// SPDX-License-Identifier: Apache-2.0
// Binary replies of the server: io/view/frames/packet.hpp.

const types = { f32: Float32Array, u32: Uint32Array, i16: Int16Array, u8: Uint8Array };

/// Returns {header, arrays}: each array is {data, components, rows}, a view of the buffer.
export function decodePacket(buffer) {
  const length = new DataView(buffer).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length)));
  const arrays = {};
  for (const [name, a] of Object.entries(header.arrays ?? {})) {
    const data = new types[a.type](buffer, 4 + length + a.offset, a.rows * a.components);
    arrays[name] = { data, components: a.components, rows: a.rows };
  }
  return { header, arrays, bytes: buffer.byteLength };
}
