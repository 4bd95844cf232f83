// SPDX-License-Identifier: Apache-2.0
// The page of `thaw view` in headless Chromium: node pictures.mjs follow|rate ADDRESS
// [PREFIX]. Environment: MODULES (node_modules with playwright-core), CHROMIUM (program).
import { launch, open, settle } from '../../tests/view/page.mjs';

const SIZE = [1280, 760], // pixels of the page that follows a run
  PICTURE = [800, 600], // pixels of the pictures whose rate is measured
  VERTICES = 100000, // least number of vertices of the surface
  TURNS = 6, // pictures of full quality
  SETTLES = 3000, // ms in which the quality adapts
  MOTION = 6000; // ms of motion that are measured

/// Draws pictures of full quality while the camera turns once around the scene. Returns pictures per second.
async function turn(turns) {
  const { stage } = window.thawView;
  const gl = stage.renderer.getContext();
  const from = stage.camera.position.toArray(),
    at = stage.controls.target.toArray(),
    angle = stage.camera.fov;
  stage.setQuality({ quick: false, coarse: false }, 1);
  let begin = 0;
  // the first picture compiles shaders
  for (let k = 0; k <= turns; k++) {
    const [c, s] = [Math.cos((2 * Math.PI * k) / turns), Math.sin((2 * Math.PI * k) / turns)];
    const [x, y] = [from[0] - at[0], from[1] - at[1]];
    stage.setCamera([at[0] + c * x - s * y, at[1] + s * x + c * y, from[2]], at, angle);
    stage.draw();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4)); // waits for the picture
    if (k === 0) begin = performance.now();
  }
  return (1000 * turns) / (performance.now() - begin);
}

/// Turns the camera as a mouse does. Returns the rate of pictures, the quality that the page chose, and the
/// median of the time of a picture in scripts.
async function move({ settles, motion }) {
  const { stage } = window.thawView;
  const from = stage.camera.position.toArray(),
    at = stage.controls.target.toArray(),
    angle = stage.camera.fov;
  const times = [];
  const draw = stage.drawTimed;
  stage.drawTimed = (...given) => {
    const begin = performance.now();
    draw.apply(stage, given);
    times.push(performance.now() - begin);
  };
  const turnFor = async (time) => {
    const begin = performance.now(),
      before = stage.drawn;
    for (let now = begin; now < begin + time; now = performance.now()) {
      const [c, s] = [Math.cos((now - begin) / 2000), Math.sin((now - begin) / 2000)];
      const [x, y] = [from[0] - at[0], from[1] - at[1]];
      stage.setCamera([at[0] + c * x - s * y, at[1] + s * x + c * y, from[2]], at, angle);
      await new Promise((done) => requestAnimationFrame(done));
    }
    return (1000 * (stage.drawn - before)) / (performance.now() - begin);
  };
  await turnFor(settles);
  times.length = 0;
  const rate = await turnFor(motion);
  delete stage.drawTimed;
  const { quality } = stage.pace;
  stage.setCamera(from, at, angle);
  times.sort((a, b) => a - b);
  return { rate, quality, script: times[Math.floor(times.length / 2)] };
}

/// Shows the packets of the frame as a new frame. Returns the median of the time in scripts, ms.
function renew(repeats) {
  const { stage, scene } = window.thawView,
    times = [];
  for (let k = 0; k < repeats; k++) {
    const begin = performance.now();
    for (const layer of stage.layers.values())
      if (layer.group.visible) layer.show(layer.packet, scene.spacing, layer.look, layer.mesh);
    stage.setQuality(stage.pace.quality, stage.scale);
    stage.draw();
    times.push(performance.now() - begin);
    stage.renderer.getContext().finish();
  }
  times.sort((a, b) => a - b);
  return times[Math.floor(repeats / 2)];
}

/// Divides the triangles of the surface into four until it has the wanted number of vertices. The server
/// sends coarser meshes.
function refine(least) {
  const layer = window.thawView.stage.layers.get('surface');
  let { position, normal, surfel, triangles } = layer.mesh.arrays;
  while (position.rows < least) {
    const places = [...position.data],
      normals = [...normal.data],
      surfels = [...surfel.data],
      corners = [],
      middles = new Map();
    const middleOf = (a, b) => {
      const key = Math.min(a, b) * 2 ** 24 + Math.max(a, b);
      if (middles.has(key)) return middles.get(key);
      const row = surfels.length;
      middles.set(key, row);
      for (let c = 0; c < 3; c++) places.push((places[3 * a + c] + places[3 * b + c]) / 2);
      for (let c = 0; c < 4; c++) normals.push(normal.data[4 * a + c]);
      surfels.push(surfels[a]);
      return row;
    };
    for (let k = 0; k < triangles.data.length; k += 3) {
      const [a, b, c] = triangles.data.subarray(k, k + 3);
      const [ab, bc, ca] = [middleOf(a, b), middleOf(b, c), middleOf(c, a)];
      corners.push(a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca);
    }
    const rows = surfels.length;
    position = { ...position, data: Float32Array.from(places), rows };
    normal = { ...normal, data: Int16Array.from(normals), rows };
    surfel = { ...surfel, data: Uint32Array.from(surfels), rows };
    triangles = { ...triangles, data: Uint32Array.from(corners), rows: corners.length / 3 };
  }
  layer.mesh.arrays = { ...layer.mesh.arrays, position, normal, surfel, triangles };
  layer.show(layer.packet, window.thawView.scene.spacing, layer.look, layer.mesh);
}

/// Sets the size of the page so that its picture has the wanted size.
async function setPicture(page, [width, height]) {
  const size = await page.evaluate(() => window.thawView.stage.size);
  const { width: wide, height: tall } = page.viewportSize();
  await page.setViewportSize({ width: wide + width - size.width, height: tall + height - size.height });
  await page.waitForFunction((w) => window.thawView.stage.size.width === w, width);
}

/// Saves pictures at rest and in motion. prefix: of the names of the files.
async function shots(page, prefix) {
  for (const [name, quality, scale] of [
    ['full', { quick: false, coarse: false }, 1],
    ['quick', { quick: true, coarse: false }, 1],
    ['coarse', { quick: true, coarse: true }, 0.5],
  ]) {
    await settle(page, quality);
    await page.evaluate(
      ([q, s]) => {
        const { stage } = window.thawView;
        stage.setQuality(q, s);
        stage.draw();
      },
      [quality, scale],
    );
    await page.locator('#canvas').screenshot({ path: `${prefix}_${name}.png` });
  }
}

const cases = {
  /// Follows a live run until a line is read from stdin. Prints the number of frames that were shown.
  async follow(browser, address) {
    const { page } = await open(browser, address, { frame: false, size: SIZE });
    await page.evaluate(() => {
      window.shownFrames = new Set();
      new MutationObserver(() => window.shownFrames.add(document.body.dataset.frame)).observe(document.body, {
        attributes: true,
        attributeFilter: ['data-frame'],
      });
    });
    console.log('open');
    await new Promise((done) => process.stdin.once('data', done));
    console.log(await page.evaluate(() => window.shownFrames.size));
    process.stdin.destroy();
  },

  /// Prints rows of the pictures of particles, of the surface, and of both: at rest and in motion. prefix:
  /// where to save pictures, if any.
  async rate(browser, address, prefix) {
    const { page } = await open(browser, address, { size: SIZE });
    await setPicture(page, PICTURE);
    await page.locator('#fit').click();
    await page.evaluate(() => window.thawView.settings.change({ most: 1e6 }));
    await settle(page);
    const rows = [];
    for (const layers of [['particles'], ['surface'], ['particles', 'surface']]) {
      for (const name of ['particles', 'surface'])
        await page.locator(`#layer-${name}`).setChecked(layers.includes(name));
      await settle(page);
      if (layers.includes('surface')) {
        await page.waitForFunction(() => window.thawView.stage.layers.get('surface').meshed);
        await page.evaluate(refine, VERTICES);
      }
      const { particles, vertices, renderer } = await page.evaluate(() => {
        const { stage } = window.thawView,
          gl = stage.renderer.getContext(),
          names = gl.getExtension('WEBGL_debug_renderer_info');
        const rowsOf = (name, from) => {
          const layer = stage.layers.get(name);
          return layer.group.visible ? from(layer).arrays.position.rows : 0;
        };
        return {
          particles: rowsOf('particles', (layer) => layer.packet),
          vertices: rowsOf('surface', (layer) => layer.mesh),
          renderer: names ? gl.getParameter(names.UNMASKED_RENDERER_WEBGL) : '',
        };
      });
      const full = await page.evaluate(turn, TURNS);
      const motion = await page.evaluate(move, { settles: SETTLES, motion: MOTION });
      const frame = await page.evaluate(renew, 9);
      rows.push({ layers: layers.join(' and '), particles, vertices, full, ...motion, frame, renderer });
      if (prefix) await shots(page, `${prefix}_${layers.join('_')}`);
    }
    console.log(JSON.stringify(rows));
  },
};

const [name, address, argument] = process.argv.slice(2);
const browser = await launch(process.env.MODULES, process.env.CHROMIUM);
try {
  await cases[name](browser, address, argument);
} finally {
  await browser.close();
}
