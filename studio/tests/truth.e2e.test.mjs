// SPDX-License-Identifier: MIT
// What is shown is true: the engine's verdict stands where a goal is called met.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { ask, openStudio, settled, state, visit } from './support.mjs';

const { site, browser } = await visit();
const { page, errors } = await openStudio(browser, site.url, { seen: true });
await settled(page);

const reach = (position_m, more = {}) => ({ character: 'human', goals: [{ effector: 'right_hand', position_m, ...more }] });
const chosen = () => page.evaluate(() => {
  const { document: d } = window.shigusa;
  const { verdict, reached, reasons } = d.result.candidates[d.chosen].summary;
  return { verdict, reasons, error: Math.max(...reached.map(({ error_mm }) => error_mm)) };
});

test('a goal that only a falling body gets to is not called met', { timeout: 120_000 }, async () => {
  await ask(page, reach([-0.3, 1, 1.6]));
  const { verdict, error, reasons } = await chosen();
  assert.equal(verdict, 'impossible');
  assert.ok(error < 1, `the hand is there, ${error} mm off`);
  const head = await page.locator('.verdict-line').innerText();
  const box = await page.locator('.verdict-box').innerText();
  const card = await page.locator('.card').first().innerText();
  assert.match(head, /not possible: would fall forward: a step is needed/);
  assert.match(card, /not possible/);
  const goals = await page.locator('.goal-list').innerText();
  for (const text of [box, card, goals, await page.locator('.message').innerText()]) assert.doesNotMatch(text, /would fall/, 'it is said once');
  assert.doesNotMatch(card, /best|about as good|worse/);
  for (const text of [head, box, card, goals]) assert.doesNotMatch(text, /\bmet\b/);
  const red = [...new Set(reasons.filter(({ joint }) => joint).map(({ joint }) => joint.split('.')[0]))];
  assert.ok(red.length > 0);
  assert.deepEqual(await page.evaluate(() => window.shigusa.strained), red, 'joints that are red on the figure');

  // a reason shows the moment that it is about
  await page.locator('.verdict-line button').click();
  const { time, playing } = await page.evaluate(() => ({ time: window.shigusa.time, playing: window.shigusa.state.playing }));
  assert.ok(Math.abs(time - reasons.find(({ kind }) => kind === 'pressure').time_s) < 1e-9);
  assert.equal(playing, false);
  await page.locator('.topbar select').last().selectOption('ja');
  await page.waitForFunction(() => document.documentElement.lang === 'ja');
  assert.match(await page.locator('.verdict-line').innerText(), /実行不可能：前に倒れます/);
  assert.match(await page.locator('.card').first().innerText(), /実行不可能/);
  await page.locator('.topbar select').last().selectOption('en');
  await page.waitForFunction(() => document.documentElement.lang === 'en');
  assert.deepEqual(errors, []);
});

test('a load that is too heavy is told by the joint that has not the strength', { timeout: 120_000 }, async () => {
  await ask(page, reach([-0.3, 1.2, 0.6], { load_kg: 40 }));
  const { verdict, reasons: [worst] } = await chosen();
  assert.deepEqual([verdict, worst.kind], ['impossible', 'strength']);
  const percent = Math.round(100 * worst.share);
  const side = worst.joint.split('_')[0];
  assert.match(await page.locator('.verdict-line .verdict').innerText(), new RegExp(`^not possible: ${side} .* at ${percent} % of its strength$`));
  assert.doesNotMatch(await page.locator('.goal-list').innerText(), /\bmet\b/);
  assert.deepEqual(errors, []);
});

test('a motion that a strong person could make is met, and told to be hard', { timeout: 120_000 }, async () => {
  await ask(page, reach([-0.2, 0.35, 0.4], { load_kg: 28 }));
  assert.equal((await chosen()).verdict, 'strains');
  assert.match(await page.locator('.goal.selected .goal-head').innerText(), /\bmet$/m);
  assert.match(await page.locator('.card.chosen .warning').innerText(), /^hard to do$/);
  assert.match(await page.locator('.verdict-line .verdict').innerText(), /^hard to do: .* % of its strength$/);
  assert.deepEqual(errors, []);
});

test('what is impossible for its haste alone can have the time that it takes', { timeout: 120_000 }, async () => {
  await ask(page, { ...reach([0.25, 0.3, 0.5]), duration_s: 0.45 });
  const { verdict } = await chosen();
  assert.equal(verdict, 'impossible');
  await page.locator('[data-key="slower"]').click();
  await page.waitForFunction(() => window.shigusa.document.settings.duration_s > 0.45);
  await settled(page);
  assert.notEqual((await chosen()).verdict, 'impossible');
  assert.equal((await state(page)).status, 'reached');
  assert.deepEqual(errors, []);
});
