// SPDX-License-Identifier: MIT
// pictures.mjs FOLDER [--frames]: the pictures of the studio in the docs, from the built page: three of it at rest, and
// with --frames those of a drag with the motion that follows, to make a moving one of.
import { mkdir } from 'node:fs/promises';
import { join } from 'node:path';
import { launch, openStudio, serve, settled } from './tests/support.mjs';

const folder = process.argv[2];
if (!folder) {
  console.error('usage: node pictures.mjs FOLDER');
  process.exit(2);
}
await mkdir(folder, { recursive: true });
const site = await serve();
const browser = await launch();

/** A share of the motion's time, and the fine picture of it with all cards drawn. */
async function at(page, share) {
  await page.locator('.scrub').evaluate((range, value) => {
    range.value = String(value * 1000);
    range.dispatchEvent(new Event('input'));
  }, share);
  await page.mouse.move(0, 0);
  await page.evaluate(() => document.activeElement?.blur());
  await page.waitForTimeout(3000);
}

async function picture(name, options, act) {
  const { page, context } = await openStudio(browser, site.url, options);
  await settled(page);
  await act(page);
  await page.screenshot({ path: join(folder, `${name}.jpg`), quality: 88 });
  await context.close();
}

await picture('studio-candidates', {}, async (page) => {
  await page.keyboard.press('Digit2');
  await at(page, 1);
});
await picture('studio-adjust', { colorScheme: 'dark' }, async (page) => {
  await page.keyboard.press('Shift+Digit5');
  await page.click('#tab-adjust');
  await at(page, 1);
});
await picture('studio-plots-ja', { locale: 'ja-JP' }, async (page) => {
  await page.keyboard.press('Digit5');
  await page.click('#tab-plots');
  await at(page, 0.7);
});

if (process.argv[3] === '--frames') await frames();
await browser.close();
site.close();

/** The hand is dragged, then the motion plays. */
async function frames() {
  const { page, context } = await openStudio(browser, site.url, { viewport: { width: 1120, height: 680 } });
  await settled(page);
  await at(page, 1);
  let frame = 0;
  const shoot = async () => page.screenshot({ path: join(folder, `frame-${String(frame++).padStart(3, '0')}.png`) });
  await shoot();
  const [x, y] = await page.evaluate(() => window.shigusa.handle('right_hand'));
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let k = 1; k <= 12; ++k) {
    await page.mouse.move(x - 5 * k, y - 14 * k);
    await page.waitForTimeout(700);
    await shoot();
  }
  await page.mouse.up();
  await settled(page);
  for (let k = 0; k <= 16; ++k) {
    await page.locator('.scrub').evaluate((range, value) => {
      range.value = String(value * 1000);
      range.dispatchEvent(new Event('input'));
    }, k / 16);
    await page.waitForTimeout(700);
    await shoot();
  }
  await context.close();
}
