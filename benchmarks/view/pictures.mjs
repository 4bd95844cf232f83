// SPDX-License-Identifier: Apache-2.0
// The page of `thaw view` in headless Chromium: node pictures.mjs follow|rate ADDRESS. Environment: MODULES
// (node_modules with playwright-core), CHROMIUM (program).
import { launch, open, settle } from '../../tests/view/page.mjs';

const SIZE = [1280, 760], // pixels
  TURNS = 24;

/// Turns the camera once around the scene. Returns the pictures per second.
function turn(turns) {
  const { stage } = window.thawView;
  const gl = stage.renderer.getContext();
  const from = stage.camera.position.toArray(),
    at = stage.controls.target.toArray(),
    angle = stage.camera.fov;
  stage.setScale(1);
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

  /// Prints pictures per second of particles, of the surface, and of both.
  async rate(browser, address) {
    const { page } = await open(browser, address, { size: SIZE });
    await page.locator('#fit').click();
    await page.evaluate(() => window.thawView.settings.change({ most: 1e6 }));
    await settle(page);
    const rows = [];
    for (const layers of [['particles'], ['surface'], ['particles', 'surface']]) {
      for (const name of ['particles', 'surface'])
        await page.locator(`#layer-${name}`).setChecked(layers.includes(name));
      await settle(page);
      if (layers.includes('surface'))
        await page.waitForFunction(() => window.thawView.stage.layers.get('surface').meshed);
      const { counts, renderer } = await page.evaluate(() => {
        const { stage } = window.thawView,
          gl = stage.renderer.getContext(),
          names = gl.getExtension('WEBGL_debug_renderer_info');
        const count = (name) => (stage.layers.get(name).packet?.arrays.position.data.length ?? 0) / 3;
        return {
          counts: { particles: count('particles'), surface: count('surface') },
          renderer: names ? gl.getParameter(names.UNMASKED_RENDERER_WEBGL) : '',
        };
      });
      const shown = (name) => (layers.includes(name) ? counts[name] : 0);
      rows.push({
        layers: layers.join(' and '),
        particles: shown('particles'),
        surfels: shown('surface'),
        rate: await page.evaluate(turn, TURNS),
        renderer,
      });
    }
    console.log(JSON.stringify(rows));
  },
};

const [name, address] = process.argv.slice(2);
const browser = await launch(process.env.MODULES, process.env.CHROMIUM);
try {
  await cases[name](browser, address);
} finally {
  await browser.close();
}
