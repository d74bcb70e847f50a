// SPDX-License-Identifier: MIT
// Light and shadows, and what is left of them when the browser takes the graphics card away for a while.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openStudio, settled, visit } from './support.mjs';

const { site, browser } = await visit();

/** The mean difference of two pictures' colours, 0 to 255. */
function difference(page, first, second) {
  return page.evaluate(async (pictures) => {
    const [a, b] = await Promise.all(pictures.map(async (base64) => {
      const image = new Image();
      image.src = `data:image/png;base64,${base64}`;
      await image.decode();
      const canvas = new OffscreenCanvas(image.width, image.height);
      const pen = canvas.getContext('2d');
      pen.drawImage(image, 0, 0);
      return pen.getImageData(0, 0, image.width, image.height).data;
    }));
    return a.reduce((sum, value, k) => sum + Math.abs(value - b[k]), 0) / a.length;
  }, [first, second].map((picture) => picture.toString('base64')));
}

/** Waits until the motion has ended and the page has had time to draw finely, which it does a quarter of a second after the last movement. */
async function rest(page) {
  await page.waitForFunction(() => !window.shigusa.state.playing);
  await page.evaluate(() => new Promise((done) => {
    const since = performance.now();
    let pictures = 0;
    const tick = () => (++pictures > 4 && performance.now() - since > 500 ? done() : requestAnimationFrame(tick));
    requestAnimationFrame(tick);
  }));
}

/** The picture once nothing changes any more. */
async function stillPicture(canvas) {
  await rest(canvas.page());
  for (let last = await canvas.screenshot(); ;) {
    await rest(canvas.page());
    const next = await canvas.screenshot();
    if (next.equals(last)) return next;
    last = next;
  }
}

test('feet have their contact shadow, and a lost WebGL context comes back with figure, ghosts and shadows', { timeout: 240_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url, { seen: true, viewport: { width: 940, height: 520 } });
  await settled(page);
  const canvas = page.locator('canvas.view');
  const bare = await stillPicture(canvas);
  await page.keyboard.press('g');
  await page.keyboard.press('p');
  await page.waitForFunction(() => window.shigusa.ghosts('right_hand').length === 5);
  const before = await stillPicture(canvas);
  const dark = await page.evaluate(() => window.shigusa.contactDarkness());
  assert.ok(dark > 0.2 && dark < 0.9, `the contact shadow is ${dark} dark`);
  assert.ok((await difference(page, bare, before)) > 1, 'ghosts are seen');
  await page.evaluate(async () => {
    const view = document.querySelector('canvas.view');
    const extension = view.getContext('webgl2').getExtension('WEBGL_lose_context');
    const event = (name) => new Promise((done) => view.addEventListener(name, done, { once: true }));
    const lost = event('webglcontextlost');
    extension.loseContext();
    await lost;
    await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    window.told = document.querySelector('.message').innerText;
    const restored = event('webglcontextrestored');
    extension.restoreContext();
    await restored;
    await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  });
  assert.match(await page.evaluate(() => window.told), /graphics card has let go of this page/);
  assert.equal(await page.locator('.message').innerText(), 'The picture is back.');
  await page.click('.message .icon-button');
  const after = await stillPicture(canvas);
  const changed = await difference(page, before, after);
  assert.ok(changed < 1, `the picture differs by ${changed}`);
  assert.ok(Math.abs((await page.evaluate(() => window.shigusa.contactDarkness())) - dark) < 0.02);
  // what the lost context had is thrown away without a word
  await page.locator('[data-key="right_hand up"]').fill('80');
  await page.keyboard.press('Enter');
  await settled(page);
  await page.keyboard.press('g');
  await stillPicture(canvas);
  assert.deepEqual(errors, []);
  await context.close();
});
