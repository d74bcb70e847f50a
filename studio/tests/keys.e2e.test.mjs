// SPDX-License-Identifier: MIT
// The keys after a number was typed, in a list, and from wherever the view is seen; and the hint, which is given once.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { ask, openStudio, openTab, settled, visit } from './support.mjs';

const { site, browser } = await visit();
const { page, errors } = await openStudio(browser, site.url);
await settled(page);

const task = { evaluations: 864, goals: [{ effector: 'right_hand', position_m: [-0.25, 1.1, 0.4] }] };
const place = () => page.evaluate(() => window.shigusa.document.goals[0].position_m.map((value) => Math.round(value * 1e6) / 1e6));
const focused = () => page.evaluate(() => document.activeElement.className);

test('after a typed number the keys are the view’s: undo, the number of a motion; with Escape nothing was typed', { timeout: 120_000 }, async () => {
  await ask(page, task);
  const up = page.locator('[data-key="right_hand up"]');
  await up.fill('90');
  await up.press('Enter');
  await settled(page);
  assert.equal(await focused(), 'view');
  assert.equal((await place())[1], 0.9);
  await page.keyboard.press('2');
  assert.equal(await up.inputValue(), '90.0', 'a key is no digit of the field any more');
  assert.ok(await page.locator('.card').nth(1).evaluate((card) => card.classList.contains('chosen')));
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await settled(page);
  assert.equal((await place())[1], 1.1);

  // left by Tab, the next field has nothing typed yet: undo is of the step
  await up.fill('95');
  await page.keyboard.press('Tab');
  await settled(page);
  assert.equal((await place())[1], 0.95);
  await page.keyboard.press('Control+z');
  await settled(page);
  assert.equal((await place())[1], 1.1);
  // what is being typed is the field's
  await up.fill('9');
  await page.keyboard.press('Control+z');
  assert.equal((await place())[1], 1.1);
  await up.fill('77');
  await page.keyboard.press('Escape');
  assert.equal(await focused(), 'view');
  assert.equal(await up.inputValue(), '110.0');
  assert.equal((await place())[1], 1.1);
  assert.ok(await page.locator('[aria-label="Undo"]').isDisabled());

  const seed = page.locator('[data-key="seed"]');
  await seed.fill('7');
  await seed.press('Enter');
  await settled(page);
  assert.equal(await focused(), 'view');
  assert.equal(await page.evaluate(() => window.shigusa.document.settings.seed), 7);
  assert.deepEqual(errors, []);
});

test('the list of joints beside the plots keeps the focus while keys go through it', { timeout: 120_000 }, async () => {
  await ask(page, task);
  await openTab(page, 'plots');
  const list = page.locator('#panel-plots select');
  await list.focus();
  const curves = () => page.evaluate(() => [...document.querySelectorAll('.plot polyline')].map((line) => line.dataset.curve));
  const seen = [];
  for (let k = 0; k < 3; ++k) {
    await page.keyboard.press('ArrowDown');
    assert.ok(await list.evaluate((element) => element === document.activeElement), `press ${k + 1}`);
    seen.push(await list.inputValue());
  }
  assert.equal(new Set(seen).size, 3);
  assert.ok((await curves()).includes(seen[2]));
  // another motion changes the curves, not the list
  await page.evaluate(() => document.querySelectorAll('.card .pick')[1].click());
  assert.equal(await list.inputValue(), seen[2]);
  assert.ok(await list.evaluate((element) => element === document.activeElement));
  assert.deepEqual(errors, []);
});

test('arrow keys move a goal as it is seen', { timeout: 120_000 }, async () => {
  await ask(page, task);
  await page.focus('canvas.view');
  // from the front right, then from the side of the hand that acts
  for (const { keys, to } of [
    { keys: ['Shift+ArrowRight'], to: [-0.15, 1.1, 0.4] }, { keys: ['v', 'v', 'Shift+ArrowRight'], to: [-0.15, 1.1, 0.5] }, { keys: ['PageDown'], to: [-0.14, 1.1, 0.5] },
  ]) {
    for (const key of keys) await page.keyboard.press(key);
    await settled(page);
    assert.deepEqual(await place(), to, keys.join());
  }
  assert.deepEqual(errors, []);
});

test('the hint is given until it is closed, at later visits neither', { timeout: 120_000 }, async () => {
  const { page: visitor, context, errors: others } = await openStudio(browser, site.url);
  const hint = visitor.locator('.hint');
  await settled(visitor);
  await visitor.reload();
  await settled(visitor);
  assert.ok(await hint.isVisible(), 'who has done nothing may not have seen it');
  await visitor.click('.hint .icon-button');
  assert.ok(!(await hint.isVisible()));
  await visitor.reload();
  await settled(visitor);
  assert.ok(!(await hint.isVisible()));
  assert.deepEqual(others, []);
  await context.close();
});
