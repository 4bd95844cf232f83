// SPDX-License-Identifier: Apache-2.0
// Reads USD layers of `thaw export` with the parsers of three.js and with tinyusdz. Compares them with each
// other and with PLY meshes of the same frames: node read_usd.mjs MODULES LAYER.usdc LAYER.usda PLY...
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';

const [modules, crateFile, textFile, ...meshFiles] = process.argv.slice(2);
const load = (file) => import(pathToFileURL(`${modules}/${file}`).href);
const bytesOf = (file) => new Uint8Array(readFileSync(file));

/// Returns vertices and triangles of a binary PLY file.
function readPly(file) {
  const bytes = readFileSync(file),
    end = bytes.indexOf('end_header\n') + 11,
    head = bytes.toString('latin1', 0, end),
    count = (element) => Number(new RegExp(`element ${element} (\\d+)`).exec(head)[1]),
    body = head.slice(head.indexOf('element vertex'), head.indexOf('element face')),
    properties = [...body.matchAll(/property (float|uchar|int) (\w+)/g)]
        .map(([, type, name]) => ({ type, name }));
  let at = end;
  const vertices = [];
  for (let v = 0; v < count('vertex'); v++) {
    const vertex = {};
    for (const { type, name } of properties) {
      const size = type === 'uchar' ? 1 : 4;
      vertex[name] = type === 'float' ? bytes.readFloatLE(at) : bytes.readUIntLE(at, size);
      at += size;
    }
    vertices.push(vertex);
  }
  const corners = [];
  for (let f = 0; f < count('face'); f++, at += 17)
    for (let k = 0; k < 3; k++) corners.push(bytes.readInt32LE(at + 1 + 4 * k));
  return { vertices, corners };
}

function samples(specs, path, attribute) {
  const spec = specs[`${path}.${attribute}`];
  assert.ok(spec, `three.js finds no ${path}.${attribute}`);
  return spec.fields.timeSamples;
}

/// Compares samples of a crate file with meshes.
function compareWithMeshes(specs, path, meshes) {
  const fields = [
    ['points', ['x', 'y', 'z']],
    ['normals', ['nx', 'ny', 'nz']],
    ['velocities', ['velocity_x', 'velocity_y', 'velocity_z']],
    ['primvars:temperature', ['temperature']],
    ['primvars:liquid', ['liquid']],
  ];
  for (const [attribute, names] of fields) {
    const { times, values } = samples(specs, path, attribute);
    assert.deepEqual([...times], meshes.map((_, k) => k), `time codes of ${attribute}`);
    meshes.forEach(({ vertices }, k) => {
      assert.equal(values[k].length, names.length * vertices.length, `${attribute} of frame ${k}`);
      vertices.forEach((vertex, v) =>
        names.forEach((name, c) => assert.equal(values[k][names.length * v + c], vertex[name], attribute)),
      );
    });
  }
  const corners = samples(specs, path, 'faceVertexIndices').values,
    counts = samples(specs, path, 'faceVertexCounts').values;
  meshes.forEach((mesh, k) => {
    assert.deepEqual([...corners[k]], mesh.corners);
    assert.ok(counts[k].every((n) => n === 3) && 3 * counts[k].length === mesh.corners.length);
  });
}

/// Returns the layer as text by tinyusdz, which is built for browsers.
async function textsByTinyusdz(files) {
  process.type = 'renderer';
  globalThis.window = globalThis;
  const { default: start } = await load('tinyusdz/tinyusdz.js');
  const native = await start({ wasmBinary: bytesOf(`${modules}/tinyusdz/tinyusdz.wasm`) });
  return files.map((file) => {
    const reader = new native.TinyUSDZLoaderNative();
    assert.ok(reader.loadAsLayerFromBinary(bytesOf(file), file), `tinyusdz cannot read ${file}`);
    return reader.layerToString();
  });
}

const { USDCParser } = await load('three/examples/jsm/loaders/usd/USDCParser.js');
const { USDLoader } = await load('three/examples/jsm/loaders/USDLoader.js');
const meshes = meshFiles.map(readPly);
const { specsByPath } = new USDCParser().parseData(bytesOf(crateFile).buffer);
const root = specsByPath['/'].fields.defaultPrim,
  layer = specsByPath['/'].fields;
assert.equal(layer.upAxis, 'Z');
assert.equal(layer.metersPerUnit, 1);
assert.equal(layer.timeCodesPerSecond, 20);
assert.equal(layer.endTimeCode, meshes.length - 1);
compareWithMeshes(specsByPath, `/${root}/surface`, meshes);
assert.ok(specsByPath[`/${root}/particles.ids`] && specsByPath[`/${root}/particles.widths`]);
const lid = samples(specsByPath, `/${root}/lid`, 'xformOp:transform').values;
assert.equal(lid.length, meshes.length);
lid.forEach((matrix, k) => assert.ok(Math.abs(matrix[14] - 0.01 * k) < 1e-6, 'height of the lid'));

/// Compares numbers of a prim with expected ones.
function isNear(path, attribute, expected) {
  const spec = specsByPath[`/${root}/${path}.${attribute}`];
  assert.ok(spec, `three.js finds no ${path}.${attribute}`);
  const found = spec.fields.default,
    values = typeof found === 'number' ? [found] : Array.from(found);
  [expected].flat().forEach((wanted, k) =>
    assert.ok(
      wanted === undefined || Math.abs(values[k] - wanted) < 1e-5,
      `${path}.${attribute}: ${values[k]}`,
    ),
  );
}
const half = Math.SQRT1_2; // lights shine along their -z axis, the third row
isNear('light', 'xformOp:transform', [...Array(8), half, 0, half, 0, 0, 0, 0, 1]);
isNear('light', 'inputs:color', [1, 0.86 / 0.88, 0.82 / 0.88]);
isNear('light', 'inputs:intensity', 0.88 * Math.PI);
isNear('light', 'inputs:angle', 4);
isNear('light_2', 'xformOp:transform', [...Array(8), 0, -1, 0, 0, 0, 0, 0, 1]);
isNear('light_2', 'inputs:color', [1, 0, 0]);
isNear('light_2', 'inputs:intensity', 0.44 * Math.PI);
isNear('camera', 'userProperties:background', [0.2158605, 0.2158605, 0.2158605]);
isNear('camera', 'userProperties:background_top', [0, 0, 1]);
isNear('sky', 'inputs:intensity', 0.5 * 0.58);
isNear('lid', 'primvars:displayOpacity', 0.25); // glass

for (const file of [crateFile, textFile]) {
  const scene = new USDLoader().parse(bytesOf(file).buffer);
  const found = {};
  scene.traverse((o) => (found[o.name] = o));
  assert.ok(found.camera.isCamera, 'camera');
  assert.equal(found.surface.geometry.attributes.position.count, meshes[0].corners.length, 'surface');
  assert.ok(found.lid.isMesh && found.plate.isMesh, 'obstacles');
}

const [crate, text] = await textsByTinyusdz([crateFile, textFile]);
// tinyusdz reads 64-bit integers of text digit by digit
const linesOf = (layer) => layer.replace(/int64\[\] ids\.timeSamples = \{[^}]*\}/, '').split('\n'),
  textLines = linesOf(text);
linesOf(crate).forEach((line, k) => {
  const other = textLines[k] ?? '';
  assert.ok(line === other, `crate and text differ: ${line.slice(0, 200)} | ${other.slice(0, 200)}`);
});
for (const part of ['def Mesh "surface"', 'def Points "particles"', 'def Camera "camera"',
    'custom color3f userProperties:background = (', 'primvars:displayColor', 'def DistantLight "light"',
    'def DistantLight "light_2"', 'def DomeLight "sky"'])
  assert.ok(crate.includes(part), part);
const first = /point3f\[\] points\.timeSamples = \{\s*0: \[\(([^)]*)\)/.exec(crate)[1].split(',').map(Number);
['x', 'y', 'z'].forEach((name, c) =>
    assert.ok(Math.abs(first[c] - meshes[0].vertices[0][name]) < 1e-6, name));
