// SPDX-License-Identifier: Apache-2.0
// Colour maps of `thaw render` (io/image/colour_map.cpp): points of lightness, chroma and hue in Oklab
// (OT20), with lightness in equal steps.

// [position, lightness, chroma, hue in degrees]
const points = {
  ember: [
    [0, 0.44, 0.15, 285],
    [0.25, 0.55, 0.2, 325],
    [0.5, 0.66, 0.21, 383],
    [0.75, 0.77, 0.17, 415],
    [1, 0.88, 0.16, 458],
  ],
  sea: [
    [0, 0.43, 0.14, 300],
    [0.25, 0.55, 0.12, 255],
    [0.5, 0.67, 0.11, 200],
    [0.75, 0.79, 0.15, 150],
    [1, 0.91, 0.18, 108],
  ],
  grey: [
    [0, 0.4, 0, 0],
    [1, 0.95, 0, 0],
  ],
};
export const mapNames = Object.keys(points);

/// Returns [r, g, b] of sRGB from 0 to 255, and whether they are in the gamut.
function srgb(lightness, chroma, hue) {
  const a = chroma * Math.cos((hue * Math.PI) / 180),
    b = chroma * Math.sin((hue * Math.PI) / 180);
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  const linear = [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ];
  const inside = linear.every((c) => c > -1e-4 && c < 1 + 1e-4);
  const bytes = linear.map((c) => {
    const x = Math.min(1, Math.max(0, c));
    return Math.round(255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055));
  });
  return { bytes, inside };
}

/// Returns 256 colours as bytes r, g, b, 255.
export function paletteOf(name) {
  const line = points[name];
  const palette = new Uint8Array(4 * 256);
  for (let i = 0, k = 1; i < 256; i++) {
    const t = i / 255;
    while (k + 1 < line.length && line[k][0] < t) k++;
    const [p, q] = [line[k - 1], line[k]];
    const u = (t - p[0]) / (q[0] - p[0]);
    const [lightness, chroma, hue] = [1, 2, 3].map((c) => p[c] + u * (q[c] - p[c]));
    let colour = srgb(lightness, chroma, hue);
    for (let less = chroma; !colour.inside && less > 0; colour = srgb(lightness, less, hue)) less -= 0.002;
    palette.set([...colour.bytes, 255], 4 * i);
  }
  return palette;
}

/// Returns the colour of a label as in labelColour of shading.js: [r, g, b] of sRGB from 0 to 1.
export function labelColour(label) {
  const part = (x) => x - Math.floor(x);
  const hue = part((label % 4096) * 0.61803398875);
  const light = 0.58 + 0.14 * part((label % 4096) * 0.7548776662);
  return [0, 1, 2].map((k) => light + 0.26 * Math.cos(2 * Math.PI * (hue + k / 3)));
}
