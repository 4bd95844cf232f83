// SPDX-License-Identifier: Apache-2.0
// The page of `thaw view` in a browser: node browser_test.mjs CASE ADDRESS [ARGUMENT]. CASE is a function
// below. Environment: MODULES (node_modules with playwright-core), CHROMIUM (program).
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import http from 'node:http';
import { coloursIn, difference, launch, open, pixelsOf, settle } from './page.mjs';

/// Returns the status of a request without a browser.
function status(address, headers = {}, method = 'GET') {
  return new Promise((resolve, reject) => {
    http
      .request(address, { headers, method }, (reply) => {
        reply.resume();
        resolve(reply.statusCode);
      })
      .on('error', reject)
      .end();
  });
}

const cases = {
  async refusals(browser, address) {
    const api = `${address}api/run`,
      { origin, host } = new URL(address);
    assert.equal(await status(api), 200);
    assert.equal(await status(api.replace(/\w{32}/, '0'.repeat(32))), 403, 'wrong token');
    assert.equal(await status(`${origin}/`), 403, 'no token');
    assert.equal(await status(api, { Host: 'example.org' }), 403, 'DNS rebinding');
    assert.equal(await status(api, { Origin: 'http://example.org' }), 403, 'other origin');
    assert.equal(await status(api, { 'Sec-Fetch-Site': 'cross-site' }), 403, 'other site');
    assert.equal(await status(`${address}..%2f..%2fetc%2fpasswd`), 404, 'path out of the run');
    assert.equal(await status(`${address}api/stop`, { 'Content-Length': 0 }, 'POST'), 403, 'no origin');
    assert.equal(
      await status(`${address}api/stop`, { 'Content-Length': 0, Origin: `http://${host}` }, 'POST'),
      409,
      'no run is live',
    );
    // A page of another port cannot read the run.
    const other = http.createServer((request, reply) => {
      reply.setHeader('Content-Type', 'text/html');
      reply.end('<p>other');
    });
    await new Promise((done) => other.listen(0, '127.0.0.1', done));
    const page = await browser.newPage();
    await page.goto(`http://127.0.0.1:${other.address().port}/`);
    const isRead = ([url, mode]) =>
      fetch(url, { mode })
        .then(Boolean)
        .catch(() => false);
    for (const mode of ['cors', 'no-cors'])
      assert.equal(await page.evaluate(isRead, [api, mode]), false, `read by another origin, ${mode}`);
    await page.setContent(`<a href="${address}">view</a>`);
    const [reply] = await Promise.all([page.waitForResponse((r) => r.url() === address), page.click('a')]);
    assert.equal(reply.status(), 403, 'a link of another site');
    other.close();
  },

  async particles(browser, address) {
    const { page, errors } = await open(browser, address);
    const last = await pixelsOf(page);
    assert.ok(coloursIn(last) > 200, `the picture is blank: ${coloursIn(last)} colours`);
    assert.match(await page.textContent('#state'), /done/);
    assert.ok((await page.locator('.chart').count()) >= 3, 'charts');

    await page.locator('#time').fill('0');
    await page.waitForFunction(() => document.body.dataset.frame === '0');
    const first = await pixelsOf(page);
    assert.ok(difference(first, last) > 0.02, 'the slider changes the picture');
    await page.keyboard.press('Escape');
    await page.locator('#play').click();
    await page.waitForFunction(() => Number(document.body.dataset.frame) >= 2);
    await page.evaluate(() => window.thawView.settings.change({ playing: false }));

    await page.locator('#time').fill('12');
    const speed = await pixelsOf(page);
    await page.selectOption('#field', 'pressure');
    await page.waitForFunction(() => document.querySelector('.bar-title').textContent === 'pressure (Pa)');
    assert.ok(difference(speed, await pixelsOf(page)) > 0.05, 'the field changes the colours');
    await page.selectOption('#field', 'velocity');
    await page.selectOption('#part', '2');
    await page.waitForFunction(() => document.querySelector('.bar-title').textContent === 'velocity z (m/s)');
    await page.locator('#range-max').fill('0.5');
    await page.keyboard.press('Enter');
    await settle(page);
    assert.ok((await page.textContent('#colour-bar')).includes('0.5'), 'the range is that of the input');

    const whole = await pixelsOf(page);
    await page.selectOption('#cut', 'y');
    assert.ok(difference(whole, await pixelsOf(page)) > 0.01, 'the cut plane hides particles');
    await page.selectOption('#cut', '');
    await page.locator('#layer-particles').uncheck();
    assert.ok(difference(whole, await pixelsOf(page)) > 0.05, 'the layer is hidden');
    await page.locator('#layer-particles').check();
    assert.ok(difference(whole, await pixelsOf(page)) < 0.01, 'the layer is back');
    await page.locator('#theme').click();
    assert.ok(difference(whole, await pixelsOf(page)) > 0.3, 'the dark theme has another ground');
    assert.deepEqual(errors, []);
  },

  async picking(browser, address) {
    const { page, errors } = await open(browser, address);
    await page.locator('#time').fill('0');
    await page.waitForFunction(() => document.body.dataset.frame === '0');
    await settle(page);
    const middle = await page.evaluate(() => {
      const { stage, boxOf } = window.thawView,
        { packet } = stage.layers.get('particles');
      const centre = boxOf([packet]).getCenter(stage.camera.position.clone());
      return stage.onPage(centre);
    });
    const { x: left, y: top } = await page.locator('#canvas').boundingBox();
    const [x, y] = [left + middle.x, top + middle.y];
    assert.equal(
      await page.evaluate(([a, b]) => document.elementFromPoint(a, b).id, [x, y]),
      'canvas',
      'no panel covers the picture',
    );
    await page.mouse.click(x, y);
    await page.waitForSelector('#point-panel table');
    const { id, place, pixels } = await page.evaluate(() => {
      const { stage, selection } = window.thawView,
        { point } = selection;
      const size = stage.layers.get('particles').spheres.uniforms.size.value;
      const far = point.position.distanceTo(stage.camera.position);
      const scale = stage.size.height / 2 / Math.tan((stage.camera.fov * Math.PI) / 360);
      return { id: point.id, place: stage.onPage(point.position), pixels: (size / far) * scale };
    });
    const away = Math.hypot(place.x - middle.x, place.y - middle.y);
    assert.ok(away <= pixels + 1, `the click is ${away} pixels from the centre of a sphere of ${pixels}`);
    const text = await page.textContent('#point-panel');
    for (const word of [id, 'velocity', 'pressure', 'density', 'position'])
      assert.ok(text.includes(word), `no ${word} in: ${text}`);
    await page.locator('#time').fill('3');
    await page.waitForFunction(() => document.body.dataset.frame === '3');
    assert.equal(
      await page.evaluate(() => window.thawView.selection.point.id),
      id,
      'the point is followed by its id',
    );
    assert.ok(await page.locator('#marker').isVisible());
    await page.keyboard.press('Escape');
    assert.ok(await page.locator('#point-panel').isHidden());

    await page.evaluate(() => window.thawView.settings.change({ most: 100 }));
    await page.waitForSelector('[data-notice=thinned]');
    assert.match(await page.textContent('[data-notice=thinned]'), /particles: 1 of [\d.]+ drawn, of/);

    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 60, y + 40, { steps: 4 });
    await page.mouse.up();
    await page.locator('#copy-camera').click();
    const turned = await page.evaluate(() => navigator.clipboard.readText());
    assert.match(
      turned,
      /^camera = \{ from = \[[-\d., e]+\], at = \[[-\d., e]+\], field_of_view = "30 deg" \}$/,
    );
    await page.locator('#scene-camera').click();
    await page.locator('#copy-camera').click();
    assert.equal(
      await page.evaluate(() => navigator.clipboard.readText()),
      'camera = { from = [2.9, -1.9, 1.7], at = [0.8, 0.3, 0.25], field_of_view = "30 deg" }',
    );
    assert.notEqual(turned, await page.inputValue('#camera-line'));
    assert.deepEqual(errors, []);
  },

  /// ARGUMENT: name of the layer.
  async layer(browser, address, name) {
    const { page, errors } = await open(browser, address);
    await page.locator('#fit').click();
    const shown = await pixelsOf(page);
    assert.ok(coloursIn(shown) > 100, `the picture is blank: ${coloursIn(shown)} colours`);
    await page.locator(`#layer-${name}`).uncheck();
    assert.ok(difference(shown, await pixelsOf(page)) > 0.03, `the layer ${name} is drawn`);
    assert.deepEqual(errors, []);
  },

  /// A surface is drawn as a mesh, and as discs by choice.
  async mesh(browser, address) {
    const { page, errors } = await open(browser, address);
    const meshed = () => page.evaluate(() => window.thawView.stage.layers.get('surface').meshed);
    await page.locator('#fit').click();
    await page.waitForFunction(() => window.thawView.stage.layers.get('surface').meshed);
    const mesh = await pixelsOf(page);
    assert.ok(coloursIn(mesh) > 100, `the picture is blank: ${coloursIn(mesh)} colours`);
    await page.selectOption('#field', '');
    const own = await pixelsOf(page);
    assert.ok(difference(mesh, own) > 0.03, 'the field changes the colours of the mesh');
    await page.selectOption('#look', 'discs');
    const discs = await pixelsOf(page);
    assert.equal(await meshed(), false, 'discs by choice');
    const changed = difference(own, discs);
    assert.ok(changed > 1e-3, 'the picture changes');
    assert.ok(changed < 0.3, `mesh and discs show the same surface: ${changed} of the pixels differ`);
    await page.locator('#layer-surface').uncheck();
    const ground = await pixelsOf(page);
    const [covered, meant] = [own, discs].map((shown) => difference(ground, shown));
    assert.ok(Math.abs(covered - meant) < 0.02, `a mesh covers ${covered} of the picture, discs ${meant}`);
    await page.locator('#layer-surface').check();
    await page.selectOption('#look', 'mesh');
    assert.ok(difference(own, await pixelsOf(page)) < 0.005, 'the mesh is back');
    assert.equal(await meshed(), true);
    const { x, y } = await page.locator('#canvas').boundingBox();
    const at = await page.evaluate(() => {
      const { stage, boxOf } = window.thawView;
      return stage.onPage(
        boxOf([stage.layers.get('surface').packet]).getCenter(stage.camera.position.clone()),
      );
    });
    await page.mouse.click(x + at.x, y + at.y);
    await page.waitForSelector('#point-panel table');
    const far = await page.evaluate(() => {
      const { selection, stage } = window.thawView;
      return stage.onPage(selection.point.position);
    });
    const away = Math.hypot(far.x - at.x, far.y - at.y);
    assert.ok(away < 30, `the picked surfel is ${away} pixels from the click`);
    assert.deepEqual(errors, []);
  },

  /// Pictures in motion look like those at rest, which follow. ARGUMENT: name of the layer.
  async motion(browser, address, name) {
    const { page, errors } = await open(browser, address);
    await page.locator('#fit').click();
    if (name === 'surface')
      await page.waitForFunction(() => window.thawView.stage.layers.get('surface').meshed);
    const full = await pixelsOf(page);
    await page.locator(`#layer-${name}`).uncheck();
    const ground = await pixelsOf(page);
    await page.locator(`#layer-${name}`).check();
    const covered = difference(ground, full);
    for (const coarse of [false, true]) {
      const quick = await pixelsOf(page, { quick: true, coarse });
      const share = difference(ground, quick) / covered;
      assert.ok(Math.abs(share - 1) < 0.1, `coarse ${coarse}: ${share} of the points' pixels are covered`);
      assert.ok(coloursIn(quick) > 100, 'the points are shaded');
    }
    await page.evaluate(() => {
      const { stage } = window.thawView;
      stage.pace.level = 3;
      stage.touch();
    });
    await page.waitForFunction(() => window.thawView.stage.quality.coarse);
    await page.waitForFunction(() => !window.thawView.stage.quality.quick);
    await page.evaluate(() => (window.pictures = window.thawView.stage.drawn));
    await new Promise((done) => setTimeout(done, 1500));
    const more = await page.evaluate(() => window.thawView.stage.drawn - window.pictures);
    assert.ok(more <= 1, `${more} pictures are drawn at rest`);
    assert.deepEqual(errors, []);
  },

  /// The post is solid and red.
  async obstacles(browser, address) {
    const { page, errors } = await open(browser, address);
    const pixels = await pixelsOf(page);
    let red = 0;
    for (let k = 0; k < pixels.length; k += 4)
      if (pixels[k] > 60 && pixels[k] > 2.2 * pixels[k + 1] && pixels[k] > 2.2 * pixels[k + 2]) red++;
    assert.ok(red > 200, `${red} pixels are red`);
    await page.locator('#layer-obstacles').uncheck();
    assert.ok(difference(pixels, await pixelsOf(page)) > 0.003, 'obstacles can be hidden');
    assert.deepEqual(errors, []);
  },

  /// The run is live, and the page stops it.
  async live(browser, address) {
    const { page, errors } = await open(browser, address, { frame: false });
    await page.waitForFunction(() => document.body.dataset.frame !== undefined);
    assert.equal(await page.textContent('#state'), 'running');
    assert.ok(await page.locator('#follow').isChecked(), 'a running run is followed');
    const count = () => page.evaluate(() => window.thawView.frames.numbers.length);
    const before = await count();
    await page.waitForFunction((n) => window.thawView.frames.numbers.length > n + 1, before);
    await page.waitForFunction(
      () => Number(document.body.dataset.frame) >= window.thawView.frames.numbers.length - 2,
    );
    await page.waitForFunction(() => document.querySelector('#time-left').textContent.includes('left'));
    await page.waitForFunction(() => /left the domain/.test(document.querySelector('#warnings').textContent));
    await page.locator('#stop').click();
    await page.locator('#stop-yes').click();
    await page.waitForFunction(() => document.querySelector('#state').textContent === 'stopped');
    assert.deepEqual(errors, []);
  },

  /// The newest frame is half-written.
  async damaged(browser, address) {
    const { page, errors } = await open(browser, address, { frame: false });
    await page.waitForSelector('[data-notice=frame]');
    assert.match(await page.textContent('[data-notice=frame]'), /\.hdf: /);
    await page.locator('#time').fill('0');
    await page.waitForFunction(() => document.body.dataset.frame === '0');
    assert.ok(coloursIn(await pixelsOf(page)) > 200, 'other frames are drawn');
    assert.ok(
      errors.every((error) => error.includes('422')),
      errors.join('\n'),
    ); // errors of the frame itself
  },

  /// A page of `thaw export --as html`. ARGUMENT: words of what it left out, or nothing.
  async page(browser, address, leftOut) {
    const { page, errors } = await open(browser, address);
    const requests = [];
    page.on('request', (request) => requests.push(request.url()));
    const last = await pixelsOf(page);
    assert.ok(coloursIn(last) > 200, `the picture is blank: ${coloursIn(last)} colours`);
    assert.ok((await page.locator('.chart').count()) >= 3, 'charts');
    await page.selectOption('#field', 'pressure');
    await page.waitForFunction(() => document.querySelector('.bar-title').textContent === 'pressure (Pa)');
    assert.ok(difference(last, await pixelsOf(page)) > 0.05, 'the field changes the colours');
    await page.locator('#time').fill('0');
    await page.waitForFunction(() => document.body.dataset.frame === '0');
    const first = await pixelsOf(page);
    assert.ok(difference(first, last) > 0.02, 'the slider changes the picture');
    const before = Number(await page.evaluate(() => document.body.dataset.frame));
    await page.locator('#play').click();
    await page.waitForFunction((n) => Number(document.body.dataset.frame) > n, before);
    await page.evaluate(() => window.thawView.settings.change({ playing: false }));
    const at = await page.evaluate(() => {
      const { stage, boxOf } = window.thawView,
        { packet } = stage.layers.get('particles');
      return stage.onPage(boxOf([packet]).getCenter(stage.camera.position.clone()));
    });
    const { x, y } = await page.locator('#canvas').boundingBox();
    await page.mouse.click(x + at.x, y + at.y);
    await page.waitForSelector('#point-panel table');
    const text = await page.textContent('#point-panel');
    for (const word of ['id ', 'velocity', 'pressure', 'density', 'position'])
      assert.ok(text.includes(word), `no ${word} in: ${text}`);
    const notes = await page.textContent('#notices');
    assert.ok(leftOut ? notes.includes(leftOut) : !notes.includes('left out'), notes);
    assert.match(await page.textContent('footer pre'), /three 0/, 'licences');
    assert.deepEqual(requests, [], 'no request');
    assert.deepEqual(errors, []);
  },

  /// A page of `thaw preview --html`. ARGUMENT: a layer that it has.
  async preview(browser, address, layer) {
    const { page, errors } = await open(browser, address);
    const shown = await pixelsOf(page);
    assert.ok(coloursIn(shown) > 20, `the picture is blank: ${coloursIn(shown)} colours`);
    await page.locator(`#layer-${layer}`).uncheck();
    assert.ok(difference(shown, await pixelsOf(page)) > 1e-4, `${layer} are drawn`);
    assert.ok(await page.locator('#time-bar').isHidden());
    assert.deepEqual(errors, []);
  },

  /// ARGUMENT: file of a picture for the manual. The address ends with #dark for the dark theme.
  async picture(browser, address, file) {
    const { page } = await open(browser, address, { size: [1280, 760], dark: address.endsWith('#dark') });
    await page.evaluate(() =>
      window.thawView.time.go(Math.round(0.75 * window.thawView.frames.numbers.length)),
    );
    await settle(page);
    const point = await page.evaluate(() => {
      const { stage } = window.thawView,
        { packet } = stage.layers.get('surface');
      const { data } = packet.arrays.position;
      // The surfel that is nearest to the camera is not hidden.
      let best = 0,
        least = Infinity;
      for (let k = 0; k < data.length; k += 3) {
        const far = stage.camera.position.distanceTo({ x: data[k], y: data[k + 1], z: data[k + 2] });
        if (far < least) [best, least] = [k, far];
      }
      return stage.onPage(stage.camera.position.clone().set(data[best], data[best + 1], data[best + 2]));
    });
    const { x, y } = await page.locator('#canvas').boundingBox();
    await page.mouse.click(x + point.x, y + point.y);
    await page.waitForSelector('#point-panel table');
    await settle(page);
    writeFileSync(file, await page.screenshot());
  },
};

const [name, address, argument] = process.argv.slice(2);
const browser = await launch(process.env.MODULES, process.env.CHROMIUM);
try {
  await cases[name](browser, address, argument);
} finally {
  await browser.close();
}
