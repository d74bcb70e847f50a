// SPDX-License-Identifier: MIT
// Plots show what the engine holds: its limits, nothing cut off, a colour for each joint; and they leave as picture and table.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { ask, openStudio, openTab, settled, visit } from './support.mjs';

const { site, browser } = await visit();
const { page, errors } = await openStudio(browser, site.url);
await settled(page);

const reach = (position_m, more = {}) => ({ character: 'human', goals: [{ effector: 'right_hand', position_m, ...more }] });

/** What a button of the plots saves. */
async function saved(format) {
  const [download] = await Promise.all([page.waitForEvent('download'), page.click(`[data-plots="${format}"]`)]);
  return readFileSync(await download.path());
}

/** Opens the tab; its curves are drawn once it has its size. */
async function openPlots() {
  await openTab(page, 'plots');
  await page.locator('#panel-plots .plot polyline').first().waitFor({ state: 'attached' });
}

/** The table's columns by name. */
function columnsOf(text) {
  const [head, ...rows] = text.trim().split('\n').map((line) => line.split(','));
  return Object.fromEntries(head.map((name, k) => [name, rows.map((row) => Number(row[k]))]));
}

const summary = () => page.evaluate(() => window.shigusa.document.result.candidates[window.shigusa.chosen].summary);

/** Curves that leave their plot's frame. */
const cut = () => page.evaluate(() => [...document.querySelectorAll('.plot polyline')].filter((line) => {
  const frame = line.parentElement.querySelector('.frame').getBBox();
  const box = line.getBBox();
  return box.y < frame.y - 0.2 || box.y + box.height > frame.y + frame.height + 0.2;
}).map((line) => line.dataset.curve));

test('joint ranges of plots are those of the verdict, on the floor too', { timeout: 120_000 }, async () => {
  await ask(page, reach([-0.1, 0.05, 0.45]));
  await openPlots();
  const { over_limit: beyond } = await summary();
  assert.deepEqual(beyond, [], 'the engine says that no joint is beyond its range');
  const columns = columnsOf((await saved('csv')).toString());
  const shares = Object.entries(columns).filter(([name]) => name.endsWith('.range_share'));
  assert.ok(shares.length > 40);
  for (const [name, values] of shares) assert.ok(Math.max(...values) < 1.002 && Math.min(...values) > -0.002, `${name}: ${Math.max(...values)}`);
  assert.ok(Math.max(...columns['left_hip.flexion.angle_deg']) > 85, 'a hip bends further with the knee bent');
  const colour = () => page.locator('.plot polyline').first().getAttribute('stroke');
  const light = await colour();
  await page.emulateMedia({ colorScheme: 'dark' });
  await page.waitForFunction((before) => document.querySelector('.plot polyline').getAttribute('stroke') !== before, light);
  await page.emulateMedia({ colorScheme: 'light' });
  assert.deepEqual(errors, []);
});

test('a torque beyond strength is seen in full, and said alike by table and verdict', { timeout: 120_000 }, async () => {
  await ask(page, reach([-0.3, 1.2, 0.6], { load_kg: 40 }));
  await openPlots();
  const { reasons } = await summary();
  const worst = reasons.find(({ kind }) => kind === 'strength');
  assert.ok(worst.share > 1.5, `${worst.share} of its strength`);
  const curve = page.locator(`figure:nth-of-type(2) polyline[data-curve="${worst.joint}"]`);
  assert.equal(await curve.count(), 1, 'the joint that is overloaded most is drawn');
  assert.deepEqual(await cut(), []);
  assert.match(await page.locator('figure').nth(1).locator('text').allTextContents().then((all) => all.join()), /100 %/);
  const columns = columnsOf((await saved('csv')).toString());
  const most = Math.max(...columns[`${worst.joint}.strength_share`]);
  assert.ok(Math.abs(most - worst.share) < 0.01, `${most} in the table, ${worst.share} in the verdict`);
  assert.deepEqual(errors, []);
});

test('a joint has one colour in all motions, a side its own line, and the plots leave as pictures', { timeout: 120_000 }, async () => {
  await ask(page, reach([-0.2, 0.3, 0.5]));
  await openPlots();
  const colours = new Map();
  const sides = new Set();
  const { candidates } = await page.evaluate(() => ({ candidates: window.shigusa.document.result.candidates.length }));
  for (let k = 1; k <= candidates; ++k) {
    await page.keyboard.press(`Digit${k}`);
    assert.deepEqual(await cut(), [], `motion ${k}`);
    const lines = await page.locator('.plot polyline').evaluateAll((all) => all.map((line) => [line.dataset.curve, line.getAttribute('stroke'), line.hasAttribute('stroke-dasharray')]));
    for (const [name, stroke, dashed] of lines.filter(([curve]) => curve.includes('.'))) {
      assert.equal(colours.get(name) ?? stroke, stroke, name);
      colours.set(name, stroke);
      assert.equal(dashed, name.startsWith('left_'), name);
    }
    for (const side of await page.locator('figure').first().locator('[data-side] b').allInnerTexts()) sides.add(side);
  }
  assert.equal(new Set(colours.values()).size, new Set([...colours.keys()].map((name) => name.replace(/^(left|right)_/, ''))).size, 'no two joints share one');
  assert.ok(sides.size > 1 && [...sides].every((side) => /^(Right|Left|Middle)$/.test(side)), [...sides].join());
  const svg = (await saved('svg')).toString();
  assert.match(svg, /^<svg xmlns/);
  assert.equal(svg.match(/<rect class="frame"/g).length, 4);
  assert.ok([...colours.values()].some((colour) => svg.includes(colour)));
  assert.equal((await saved('png')).subarray(1, 4).toString(), 'PNG');
  assert.deepEqual(errors, []);
});
