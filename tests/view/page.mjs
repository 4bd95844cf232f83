// SPDX-License-Identifier: Apache-2.0
// Headless Chromium with the page of `thaw view`, for browser_test.mjs.
import { createRequire } from 'node:module';
import { join } from 'node:path';

const SECONDS = 120; // software rendering on a busy machine is slow

/// Returns a browser. modules: the node_modules folder with playwright-core. program: of Chromium.
export async function launch(modules, program) {
  const { chromium } = createRequire(join(modules, 'x'))('playwright-core');
  const args = [
    '--no-sandbox',
    '--use-angle=swiftshader',
    '--enable-unsafe-swiftshader',
    '--ignore-gpu-blocklist',
  ];
  return chromium.launch({ executablePath: program, args, timeout: SECONDS * 1000 });
}

/// Opens the page and waits for its first frame, if there is one. Returns it with `errors`, its messages of
/// console and scripts.
export async function open(browser, address, { frame = true, dark = false, size = [1000, 500] } = {}) {
  const context = await browser.newContext({
    viewport: { width: size[0], height: size[1] },
    colorScheme: dark ? 'dark' : 'light',
    permissions: ['clipboard-read', 'clipboard-write'],
  });
  context.setDefaultTimeout(SECONDS * 1000);
  const page = await context.newPage();
  const errors = [];
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) errors.push(message.text());
  });
  page.on('pageerror', (error) => errors.push(String(error)));
  await page.goto(address);
  if (frame) await page.waitForFunction(() => document.body.dataset.frame !== undefined);
  return { page, errors };
}

const FULL = { quick: false, coarse: false };

/// Waits until the page has drawn all changes. quality: of viewer/src/scene/pace.js.
export async function settle(page, quality = FULL) {
  await page.evaluate(async (wanted) => {
    const { thawView: app } = window;
    const drawn = () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    await app.show();
    await drawn();
    while (app.stage.due) await drawn();
    clearTimeout(app.stage.resting);
    app.stage.setQuality(wanted, 1); // independent of the speed of the machine
    app.stage.draw();
    await drawn();
  }, quality);
}

/// Returns the pixels (r, g, b, a) of the middle of the picture, without the colour bar and the time slider.
export async function pixelsOf(page, quality = FULL) {
  await settle(page, quality);
  const { x, y, width, height } = await page.locator('#canvas').boundingBox();
  const clip = { x: x + width * 0.1, y: y + height * 0.15, width: width * 0.65, height: height * 0.65 };
  const png = (await page.screenshot({ clip, timeout: SECONDS * 1000 })).toString('base64');
  const pixels = await page.evaluate(async (text) => {
    const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
    const picture = await createImageBitmap(new Blob([bytes]));
    const canvas = new OffscreenCanvas(picture.width, picture.height),
      context = canvas.getContext('2d');
    context.drawImage(picture, 0, 0);
    return [...context.getImageData(0, 0, picture.width, picture.height).data];
  }, png);
  return Uint8Array.from(pixels);
}

/// Returns the share of pixels that differ by more than a little.
export function difference(a, b) {
  let count = 0;
  for (let k = 0; k < a.length; k += 4)
    if (Math.abs(a[k] - b[k]) + Math.abs(a[k + 1] - b[k + 1]) + Math.abs(a[k + 2] - b[k + 2]) > 24) count++;
  return (4 * count) / a.length;
}

/// Returns the number of different colours.
export function coloursIn(pixels) {
  const colours = new Set();
  for (let k = 0; k < pixels.length; k += 4)
    colours.add((pixels[k] << 16) | (pixels[k + 1] << 8) | pixels[k + 2]);
  return colours.size;
}
