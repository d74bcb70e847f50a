// SPDX-License-Identifier: MIT
// pictures.mjs FOLDER: the pictures of the studio in the docs, from the built page: three of it at rest, and a moving one of a drag,
// the motion that follows and another choice. Calls img2webp.
import { execFileSync } from 'node:child_process';
import { mkdir, mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { launch, openStudio, serve, settled } from './tests/support.mjs';

const folder = process.argv[2];
if (!folder) {
  console.error('usage: node pictures.mjs FOLDER');
  process.exit(2);
}
await mkdir(folder, { recursive: true });
const site = await serve();
const browser = await launch({ full: true });

/** Shows the posture at a share of the motion's time. */
function scrub(page, share) {
  return page.locator('.scrub').evaluate((range, value) => {
    range.value = String(value * 1000);
    range.dispatchEvent(new Event('input'));
  }, share);
}

/** The same, finely drawn, with all cards. */
async function at(page, share) {
  await scrub(page, share);
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

await movingPicture();
await browser.close();
site.close();

/** The hand is dragged, the motion plays, then another one. */
async function movingPicture() {
  const work = await mkdtemp(join(tmpdir(), 'shigusa-'));
  const { page, context } = await openStudio(browser, site.url, { viewport: { width: 1120, height: 680 } });
  await settled(page);
  await at(page, 1);
  const frames = [];
  const shoot = async (ms) => {
    const path = join(work, `${frames.length}.png`);
    await page.waitForTimeout(600); // to be drawn
    await page.screenshot({ path });
    frames.push('-d', String(ms), path);
  };
  const play = async () => {
    const kSteps = 24;
    for (let k = 0; k <= kSteps; ++k) {
      await scrub(page, k / kSteps);
      await shoot(k < kSteps ? 50 : 1200);
    }
  };
  await shoot(1200);
  const [x, y] = await page.evaluate(() => window.shigusa.handle('right_hand'));
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let k = 1; k <= 20; ++k) {
    await page.mouse.move(x + 2.5 * k, y + 5 * k);
    await shoot(80);
  }
  await page.mouse.up();
  await settled(page);
  await play();
  await page.locator('.card .pick').nth(4).click();
  await play();
  await context.close();
  const file = join(folder, 'studio.webp');
  execFileSync('img2webp', ['-loop', '0', '-lossy', '-q', '75', '-m', '6', ...frames, '-o', file]);
  await rm(work, { recursive: true });
}
