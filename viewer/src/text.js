// SPDX-License-Identifier: Apache-2.0
// Numbers and durations as text.

/// Returns a number in a few digits: "0.0025", "12.3", "4.1e-7".
export function numberText(value, digits = 4) {
  if (value === null || value === undefined || value === '') return '–';
  if (typeof value !== 'number') return String(value);
  if (!Number.isFinite(value)) return String(value);
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size >= 1e-3 && size < 1e6) return String(Number(value.toPrecision(digits)));
  return value
    .toExponential(Math.max(0, digits - 2))
    .replace('e+', 'e')
    .replace(/\.?0+e/, 'e');
}

export const countText = (count) => count.toLocaleString('en-GB');

/// Returns "12 s", "5 min 3 s", "3 h 20 min" or "4 days".
export function durationText(seconds) {
  if (!(seconds >= 0) || !Number.isFinite(seconds)) return '–';
  if (seconds < 100) return `${Math.round(seconds)} s`;
  if (seconds < 6000) return `${Math.floor(seconds / 60)} min ${Math.floor(seconds % 60)} s`;
  if (seconds < 345600) return `${Math.floor(seconds / 3600)} h ${Math.floor((seconds % 3600) / 60)} min`;
  return `${Math.round(seconds / 86400)} days`;
}

/// Returns simulated times with as many digits as distinguish frames.
export function timeText(time, last) {
  const digits = last > 0 ? Math.min(9, Math.max(1, 3 - Math.floor(Math.log10(last)))) : 3;
  return `${time.toFixed(digits)} s`;
}
