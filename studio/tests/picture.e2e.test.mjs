// SPDX-License-Identifier: MIT
// The view leaves as a picture.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openStudio, openTab, settled, take, visit } from './support.mjs';

const { site, browser } = await visit();

/** Width, height and the opacity of the first pixel and of the most opaque one. */
async function read(page, bytes) {
  assert.equal(bytes.subarray(1, 4).toString('latin1'), 'PNG');
  const opacity = await page.evaluate(async (base64) => {
    const image = new Image();
    image.src = `data:image/png;base64,${base64}`;
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height);
    const pen = canvas.getContext('2d');
    pen.drawImage(image, 0, 0);
    const { data } = pen.getImageData(0, 0, image.width, image.height);
    let most = 0;
    for (let k = 3; k < data.length; k += 4) most = Math.max(most, data[k]);
    return { corner: data[3], most };
  }, bytes.toString('base64'));
  return { width: bytes.readUInt32BE(16), height: bytes.readUInt32BE(20), ...opacity };
}

test('a picture has the size that was asked for, and a background or none', { timeout: 240_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url, { seen: true, viewport: { width: 940, height: 520 } });
  await settled(page);
  await openTab(page, 'take');
  const [width, height] = await page.locator('canvas.view').evaluate((canvas) => [canvas.clientWidth, canvas.clientHeight]);
  const plain = await read(page, await take(page, 'picture'));
  assert.deepEqual(plain, { width: 2 * width, height: 2 * height, corner: 255, most: 255 });
  await page.locator('[data-picture="times"]').selectOption('1');
  await page.check('[data-picture="transparent"]');
  const bare = await read(page, await take(page, 'picture'));
  assert.deepEqual(bare, { width, height, corner: 0, most: 255 });
  assert.deepEqual(errors, []);
  await context.close();
});
