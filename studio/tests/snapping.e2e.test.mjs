// SPDX-License-Identifier: MIT
// Both hands' goals move alike, and places snap to the floor, to faces of things and to the other hand.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { seriousFindings } from './axe.mjs';
import { drag, drop, handleOf, linkTo, openStudio, settled, take, visit } from './support.mjs';

const { site, browser } = await visit();

const field = (page, key) => page.locator(`[data-key="${key}"]`);
const goals = (page) => page.evaluate(() => window.shigusa.document.goals);
const things = (page) => page.evaluate(() => window.shigusa.task.obstacles);
const snapped = (page) => page.evaluate(() => window.shigusa.snapped);
const near = (a, b) => assert.ok(Math.abs(a - b) < 1e-9, `${a} in place of ${b}`);

/** Takes hold of a handle, moves it to a place in the page and leaves it held. */
async function hold(page, name, [x, y]) {
  const from = await handleOf(page, name);
  await page.mouse.move(...from);
  await page.mouse.down();
  for (let k = 1; k <= 4; ++k) await page.mouse.move(from[0] + ((x - from[0]) * k) / 4, from[1] + ((y - from[1]) * k) / 4);
}

async function beside(page, name, dx, dy) {
  const [x, y] = await handleOf(page, name);
  return [x + dx, y + dy];
}

async function letGo(page) {
  await page.mouse.up();
  await settled(page);
}

test('where hands move alike, the other goal is the mirror image, in one step', { timeout: 240_000 }, async () => {
  const right = { effector: 'right_hand', position_m: [-0.25, 1, 0.45], axis: { axis: 'palm', direction: 'left' } };
  const { page, context, errors } = await openStudio(browser, linkTo(site, { evaluations: 64, goals: [right] }));
  await settled(page);
  await field(page, 'symmetric').click();
  await settled(page);
  assert.deepEqual(await goals(page), [right, { effector: 'left_hand', position_m: [0.25, 1, 0.45], axis: { axis: 'palm', direction: 'right' } }]);

  const assertMirrored = async () => {
    const [a, b] = await goals(page);
    assert.deepEqual([a.effector, b.effector], ['right_hand', 'left_hand']);
    assert.deepEqual(b.position_m, [-a.position_m[0], a.position_m[1], a.position_m[2]]);
    return a.position_m;
  };
  await drag(page, 'right_hand', -20, -40, { hold: 30 });
  await settled(page);
  const moved = await assertMirrored();
  assert.ok(moved[1] > 1.02);
  await page.keyboard.press('Control+z');
  await settled(page);
  assert.deepEqual(await assertMirrored(), right.position_m, 'one step');

  await field(page, 'symmetric').click();
  await drag(page, 'right_hand', 0, 30, { hold: 30 });
  await settled(page);
  const [a, b] = await goals(page);
  assert.ok(a.position_m[1] < right.position_m[1]);
  assert.equal(b.position_m[1], right.position_m[1], 'each by itself again');
  assert.deepEqual(errors, []);
  await context.close();
});

// where else: document.test.mjs
test('what is dragged snaps to faces and the floor, as the switch or Ctrl says', { timeout: 240_000 }, async () => {
  const table = { name: 'table', position_m: [-0.4, 0.7, 0.6], size_m: [0.8, 0.04, 0.6] };
  const box = { name: 'box', position_m: [0.6, 0.19, 0.3], size_m: [0.3, 0.3, 0.3] };
  const task = { character: 'human', evaluations: 64, obstacles: [table, box], goals: [{ effector: 'right_hand', position_m: [-0.3, 1, 0.5] }, { effector: 'left_hand', position_m: [0.2, 1.2, 0.4] }] };
  const { page, context, errors } = await openStudio(browser, linkTo(site, task), { seen: true });
  await settled(page);
  const thick = await page.evaluate(() => window.shigusa.document.character.description.capsules.find(({ name }) => name === 'right_hand').radius_m);
  assert.ok(thick > 0.005);

  // not at first, and with Ctrl all the same
  const onTable = await beside(page, '@thing 0', 40, 10);
  await hold(page, 'right_hand', onTable);
  assert.equal(await snapped(page), null);
  await page.keyboard.down('Control');
  await page.mouse.move(onTable[0] + 4, onTable[1]);
  assert.equal(await snapped(page), '@thing 0');
  await letGo(page);
  await page.keyboard.up('Control');
  near((await goals(page))[0].position_m[1], 0.72 + thick + 0.012);
  assert.equal(await snapped(page), null, 'the mark goes');

  await field(page, 'snap').click();
  await hold(page, '@thing 1', await beside(page, '@thing 1', 12, 0));
  assert.equal(await snapped(page), 'floor');
  await letGo(page);
  near((await things(page))[1].position_m[1], 0.15);
  assert.deepEqual(await seriousFindings(page), []);
  assert.deepEqual(errors, []);
  await context.close();
});

test('snap and hands that move alike are as they were after a reload and in a result', { timeout: 240_000 }, async () => {
  const task = { evaluations: 64, goals: [{ effector: 'right_hand', position_m: [-0.25, 1, 0.45] }] };
  const { page, context, errors } = await openStudio(browser, linkTo(site, task));
  await settled(page);
  await field(page, 'snap').click();
  await field(page, 'symmetric').click();
  await settled(page);
  await page.waitForFunction(() => window.shigusa.state.saving === 'saved');
  const result = await take(page, 'result');
  await page.reload();
  await settled(page);
  const switches = () => page.evaluate(() => [window.shigusa.state.snap, window.shigusa.state.symmetric]);
  assert.deepEqual(await switches(), [true, true]);
  await page.click('#tab-goals');
  assert.ok(await field(page, 'snap').isChecked());
  assert.equal((await goals(page)).length, 2);
  await drag(page, 'left_hand', 20, -30, { hold: 30 });
  await settled(page);
  const [right, left] = await goals(page);
  assert.deepEqual(right.position_m, [-left.position_m[0], left.position_m[1], left.position_m[2]]);

  for (const key of ['snap', 'symmetric']) await field(page, key).click();
  assert.deepEqual(await switches(), [false, false]);
  await drop(page, 'result.json', result);
  await page.waitForFunction(() => window.shigusa.state.snap);
  assert.deepEqual(await switches(), [true, true]);
  assert.deepEqual(errors, []);
  await context.close();
});
