// SPDX-License-Identifier: MIT
// What the View menu shows of a motion in space.
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { seriousFindings } from './axe.mjs';
import { drawn, drop, linkTo, openStudio, settled, visit } from './support.mjs';

const folder = process.env.SHIGUSA_CHARACTERS ?? fileURLToPath(new URL('../../../shared/characters/', import.meta.url));
const kMesh = join(folder, 'lab0_CesiumMan.glb');

const { site, browser } = await visit();

const distance = (a, b) => Math.hypot(...a.map((value, k) => value - b[k]));

/** Waits until what a condition reads from the page is so. */
const until = (page, condition, argument) => page.waitForFunction(condition, argument, { timeout: 30_000 });

/** Shows the posture at a share of the motion's time and waits until it is drawn. */
async function at(page, share) {
  await page.locator('.scrub').evaluate((range, value) => {
    range.value = String(value * 1000);
    range.dispatchEvent(new Event('input'));
  }, share);
  await drawn(page);
}

async function ghostsFollowTheMotion(page) {
  await page.keyboard.press('g');
  await until(page, () => window.shigusa.ghosts('right_hand').length === 5);
  await page.click('.view-opener');
  await page.locator('[data-view="ghosts"]').fill('3');
  await page.keyboard.press('Escape');
  await until(page, () => window.shigusa.ghosts('right_hand').length === 3);
  const ghosts = await page.evaluate(() => window.shigusa.ghosts('right_hand'));
  for (const [k, share] of [0, 0.5, 1].entries()) {
    await at(page, share);
    const hand = await page.evaluate(() => window.shigusa.drawn('right_hand'));
    assert.ok(distance(ghosts[k], hand) < 0.01, `ghost ${k} has its hand at ${ghosts[k]}, the figure at ${hand}`);
  }
  assert.ok(distance(ghosts[0], ghosts[2]) > 0.2, 'the hand moves');
}

test('ghosts stand where the motion has the figure, and another motion has others', async () => {
  const { page, context, errors } = await openStudio(browser, site.url, { seen: true });
  await settled(page);
  await ghostsFollowTheMotion(page);
  const first = await page.evaluate(() => window.shigusa.ghosts('head'));
  await page.keyboard.press('Digit2');
  await until(page, (old) => JSON.stringify(window.shigusa.ghosts('head')) !== old, JSON.stringify(first));
  await page.keyboard.press('g');
  await until(page, () => window.shigusa.ghosts('right_hand').length === 0);
  assert.deepEqual(errors, []);
  await context.close();
});

test('a character with its own mesh has ghosts too', { skip: !existsSync(kMesh) && 'no characters here', timeout: 120_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url, { seen: true });
  await settled(page);
  await page.keyboard.press('g');
  await until(page, () => window.shigusa.ghosts('right_hand').length === 5);
  await page.keyboard.press('g');
  await drop(page, 'CesiumMan.glb', readFileSync(kMesh));
  await until(page, () => window.shigusa.document.character.spec.source === 'CesiumMan.glb');
  await settled(page);
  await ghostsFollowTheMotion(page);
  assert.deepEqual(errors, []);
  await context.close();
});

test('the path’s colours have a legend that the fastest hand fits in, ever darker or ever lighter', async () => {
  // with all that goals are marked with
  const goal = { effector: 'right_hand', position_m: [-0.2, 0.8, 0.4], axis: { axis: 'palm', direction: 'down' }, tolerance_m: [0.05, 0, 0.1], load_kg: 2 };
  const { page, context, errors } = await openStudio(browser, linkTo(site, { character: { source: 'human', seat_m: 0.45 }, goals: [goal] }), { seen: true });
  await settled(page);
  assert.ok(await page.locator('.speed-legend').isHidden());
  await page.keyboard.press('p');
  const legend = page.locator('.speed-legend');
  assert.ok(await legend.isVisible());
  const fastest = await page.evaluate(() => {
    const { document: d, chosen } = window.shigusa;
    const { time, effectors } = d.result.candidates[chosen].series;
    const steps = Array.from({ length: time.frames - 1 }, (_, f) => Math.hypot(
      ...[0, 1, 2].map((k) => effectors.values[(f + 1) * effectors.columns + k] - effectors.values[f * effectors.columns + k]),
    ) / (time.values[f + 1] - time.values[f]));
    return Math.max(...steps);
  });
  const numbers = (await legend.locator('.speed-numbers span').allInnerTexts()).map(Number);
  assert.ok(numbers[2] >= 0.99 * fastest && numbers[2] <= fastest + 0.55, `the scale ends at ${numbers[2]} m/s, the hand has ${fastest}`);
  for (const [theme, way] of [['light', -1], ['dark', 1]]) {
    await page.locator('.topbar select').first().selectOption(theme);
    const lightness = await legend.locator('i').evaluate((bar) => bar.style.background.match(/rgb\([^)]*\)/g).map((colour) => {
      const [r, g, b] = colour.match(/\d+/g).map((value) => (Number(value) / 255) ** 2.2);
      return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    }));
    for (let k = 1; k < lightness.length; ++k) assert.ok(way * (lightness[k] - lightness[k - 1]) > 0.02, `${theme}: ${lightness}`);
    await page.click('.view-opener');
    assert.deepEqual(await seriousFindings(page), [], theme);
    await page.keyboard.press('Escape');
    await page.locator('#view-menu').waitFor({ state: 'hidden' });
  }
  assert.deepEqual(errors, []);
  await context.close();
});
