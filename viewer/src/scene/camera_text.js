// SPDX-License-Identifier: Apache-2.0
// The camera as a line of a scene.

/// Rounds to a digit that is small against `size`.
function rounded(value, size) {
  const digits = Math.max(0, 3 - Math.floor(Math.log10(size)));
  return Number(value.toFixed(Math.min(digits, 12)));
}

/// Returns `camera = { from = [...], at = [...], field_of_view = "30 deg" }`. from, at: three numbers, m;
/// angle: vertical, in degrees.
export function cameraLine(from, at, angle) {
  const distance = Math.hypot(...from.map((x, k) => x - at[k]));
  const list = (point) => `[${point.map((x) => rounded(x, distance)).join(', ')}]`;
  return `camera = { from = ${list(from)}, at = ${list(at)}, field_of_view = "${rounded(angle, 100)} deg" }`;
}
