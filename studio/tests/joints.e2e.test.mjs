// SPDX-License-Identifier: MIT
// Other parts of the body than hands, feet and head have goals too, and the eyes have something to look at.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { seriousFindings } from './axe.mjs';
import { ask, drag, openStudio, settled, visit } from './support.mjs';

const { site, browser } = await visit();
const { page, errors } = await openStudio(browser, site.url);
await settled(page);

const task = { character: 'human', evaluations: 64, goals: [{ effector: 'right_hand', position_m: [-0.25, 1.0, 0.45] }] };
const field = (key) => page.locator(`[data-key="${key}"]`);
const asked = () => page.evaluate(() => window.shigusa.task);

test('hips and an elbow are dragged to where they shall be, and have rows', { timeout: 240_000 }, async () => {
  await ask(page, task);
  assert.ok(await field('hips has').isHidden(), 'the rest of the body is folded away');
  await drag(page, 'hips', 0, 20, { hold: 30 });
  await settled(page);
  let { goals } = await asked();
  assert.deepEqual(goals.map(({ effector }) => effector), ['right_hand', 'hips']);
  const reached = await page.evaluate(() => window.shigusa.document.result.candidates[0].summary.reached.find(({ effector }) => effector === 'hips'));
  assert.ok(reached.error_mm < 1, `the hips end ${reached.error_mm} mm from there`);
  assert.ok(await field('hips up').isVisible(), 'their row is seen');
  assert.equal(await field('hips up').inputValue(), (100 * goals[1].position_m[1]).toFixed(1));
  for (const joint of ['chest', 'right_elbow', 'left_elbow', 'right_knee', 'left_knee']) assert.ok(await field(`${joint} has`).isVisible(), joint);

  await drag(page, 'left_elbow', 30, -30, { hold: 30 });
  await settled(page);
  ({ goals } = await asked());
  assert.deepEqual(goals.map(({ effector }) => effector), ['right_hand', 'hips', 'left_elbow']);
  await field('hips has').click();
  await settled(page);
  await page.keyboard.press('Control+z');
  await settled(page);
  assert.equal((await asked()).goals.length, 3);
  assert.deepEqual(await seriousFindings(page), []);
  assert.deepEqual(errors, []);
});

test('what is looked at is set, typed and dragged, and kept in the task', { timeout: 240_000 }, async () => {
  await ask(page, task);
  await field('look has').click();
  await settled(page);
  const first = (await asked()).look_at_m;
  assert.deepEqual([first[0], first[2]], [0, 1]);
  assert.ok((await page.evaluate(() => window.shigusa.marks)).includes('sight'));

  await field('look left').fill('60');
  await field('look left').press('Enter');
  await settled(page);
  const turn = () => page.evaluate(() => {
    const { series, summary } = window.shigusa.document.result.candidates[0];
    const index = window.shigusa.document.character.description.joints.findIndex(({ name }) => name === 'neck.rotation');
    return { angle: series.angles.values[(series.angles.frames - 1) * series.angles.columns + index], words: summary.final_posture.words };
  });
  const left = (await turn()).angle;
  await field('look left').fill('-90');
  await field('look left').press('Enter');
  await settled(page);
  assert.notEqual((await turn()).angle, left, 'the head turns elsewhere');

  await drag(page, '@look', -40, -30, { hold: 30 });
  await settled(page);
  const last = (await asked()).look_at_m;
  assert.ok(last[1] > first[1], `dragged up to ${last[1]} m`);
  assert.equal(await field('look up').inputValue(), (100 * last[1]).toFixed(1));

  await page.keyboard.press('Control+z');
  await settled(page);
  assert.equal((await asked()).look_at_m[1], first[1]);
  await field('look has').click();
  await settled(page);
  assert.equal((await asked()).look_at_m, undefined);
  assert.deepEqual(errors, []);
});
