// SPDX-License-Identifier: Apache-2.0
// Checks texture coordinates of a USD layer with the parser of three.js: node read_usd_uv.mjs MODULES FILE.
// The surface is a cube of 0.2 m that moves by 1 m/s. Its mesh has u = x and v = z, 0 to 1.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';

const [modules, file] = process.argv.slice(2);
const { USDCParser } = await import(
  pathToFileURL(`${modules}/three/examples/jsm/loaders/usd/USDCParser.js`).href
);
const { specsByPath } = new USDCParser().parseData(new Uint8Array(readFileSync(file)).buffer);
const root = specsByPath['/'].fields.defaultPrim,
  attribute = (name) => specsByPath[`/${root}/surface.${name}`].fields,
  st = attribute('primvars:st'),
  { values: points } = attribute('points').timeSamples,
  { values: corners } = attribute('faceVertexIndices').timeSamples;
assert.equal(st.interpolation, 'faceVarying');
st.timeSamples.values.forEach((texture, k) => {
  assert.equal(texture.length, 2 * corners[k].length);
  const away = [...corners[k]].map((v, c) =>
    Math.hypot(
      texture[2 * c] - (points[k][3 * v] - 0.05 * k) / 0.2 - 0.5,
      texture[2 * c + 1] - points[k][3 * v + 2] / 0.2 - 0.5,
    ),
  );
  away.sort((a, b) => a - b);
  assert.ok(away[Math.floor(away.length / 2)] < 0.03, `frame ${k}: ${away[Math.floor(away.length / 2)]}`);
});
