// SPDX-License-Identifier: MIT
// Things in the way are turned, by numbers and by rings, and leave so.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { seriousFindings } from './axe.mjs';
import { angleBetween, turnByRings } from './rings.mjs';
import { ask, drop, linkTo, openStudio, settled, take, visit } from './support.mjs';

const { site, browser } = await visit();

const kBox = { name: 'box', position_m: [-0.3, 0.2, 0.6], size_m: [0.2, 0.4, 0.3] };
const task = { evaluations: 64, obstacles: [kBox], goals: [{ effector: 'right_hand', position_m: [-0.25, 1.2, 0.4] }] };
const thing = (page) => page.evaluate(() => window.shigusa.task.obstacles[0]);
const field = (page, key) => page.locator(`[data-key="${key}"]`);
const near = (a, b) => assert.ok(Math.hypot(...a.map((value, k) => value - b[k])) < 1e-9, `${a} in place of ${b}`);

async function type(page, key, text) {
  await field(page, key).fill(text);
  await field(page, key).press('Enter');
  await settled(page);
}

test('a thing is turned by numbers, stays on its floor, and is turned back by undo; link and result keep it', { timeout: 240_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, linkTo(site, task));
  await settled(page);
  await type(page, 'thing 0 heading', '30');
  const half = Math.PI / 12;
  near((await thing(page)).rotation_xyzw, [0, Math.sin(half), 0, Math.cos(half)]);
  near((await thing(page)).position_m, kBox.position_m);

  // it lies down: half its shorter side above the floor
  await type(page, 'thing 0 roll', '90');
  assert.ok(Math.abs((await thing(page)).position_m[1] - 0.1) < 1e-9);
  assert.equal(await field(page, 'thing 0 heading').inputValue(), '30');
  const lying = await thing(page);

  // dragged, in inches too: degrees are no lengths
  await page.click('.view-opener');
  await page.locator('[data-view="lengths"]').selectOption('in');
  await page.keyboard.press('Escape');
  await field(page, 'thing 0 heading').scrollIntoViewIfNeeded();
  const { x, y, width, height } = await field(page, 'thing 0 heading').boundingBox();
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.mouse.down();
  await page.mouse.move(x + width / 2 + 20, y + height / 2);
  await page.mouse.move(x + width / 2 + 40, y + height / 2);
  await page.waitForFunction(() => window.shigusa.state.trial !== null);
  assert.deepEqual(await thing(page), lying, 'not before it is let go of');
  await page.mouse.up();
  await settled(page);
  assert.ok(Math.abs(angleBetween((await thing(page)).rotation_xyzw, lying.rotation_xyzw) - 10) < 1e-6);
  assert.equal(await field(page, 'thing 0 heading').inputValue(), '40');
  assert.equal(await field(page, 'thing 0 size up').inputValue(), (0.4 / 0.0254).toFixed(2));
  assert.deepEqual(await seriousFindings(page), []);

  await page.keyboard.press('Control+z');
  await settled(page);
  assert.deepEqual(await thing(page), lying);

  const result = await take(page, 'result');
  await page.waitForFunction(() => window.shigusa.state.saving === 'saved');
  for (let k = 0; k < 2; ++k) await page.keyboard.press('Control+z');
  await settled(page);
  assert.deepEqual(await thing(page), kBox);
  await drop(page, 'result.json', result);
  await page.waitForFunction(() => window.shigusa.task.obstacles[0].rotation_xyzw !== undefined);
  await settled(page);
  near((await thing(page)).rotation_xyzw, lying.rotation_xyzw);

  // and no rotation is none
  await page.click('#tab-goals');
  for (const angle of ['roll', 'heading']) await type(page, `thing 0 ${angle}`, '0');
  assert.equal((await thing(page)).rotation_xyzw, undefined);

  await ask(page, { ...task, obstacles: [lying] });
  assert.equal(await field(page, 'thing 0 roll').inputValue(), '90');
  near((await thing(page)).rotation_xyzw, lying.rotation_xyzw);
  assert.deepEqual(errors, []);
  await context.close();
});

test('rings turn the thing that is selected, where it is', { timeout: 240_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, linkTo(site, task), { seen: true });
  await settled(page);
  await field(page, 'thing 0 rings').focus();
  await page.waitForFunction(() => window.shigusa.state.selected === '@thing 0');
  await field(page, 'thing 0 rings').setChecked(true);
  await turnByRings(page, '@thing 0', async () => (await thing(page)).rotation_xyzw ?? [0, 0, 0, 1]);
  const turned = await thing(page);
  assert.deepEqual([turned.position_m[0], turned.position_m[2]], [-0.3, 0.6]);
  const [qx, qy, qz, qw] = turned.rotation_xyzw;
  const upward = [2 * (qx * qy + qw * qz), 1 - 2 * (qx * qx + qz * qz), 2 * (qy * qz - qw * qx)];
  const standing = kBox.size_m.reduce((sum, side, k) => sum + (Math.abs(upward[k]) * side) / 2, 0);
  assert.ok(Math.abs(turned.position_m[1] - standing) < 1e-9, 'its lowest corner is on the floor');
  // each try at a ring may have been a small step
  while (await page.evaluate(() => window.shigusa.state.canUndo)) await page.keyboard.press('Control+z');
  await settled(page);
  assert.deepEqual(await thing(page), kBox);
  assert.deepEqual(errors, []);
  await context.close();
});
