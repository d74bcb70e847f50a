// SPDX-License-Identifier: MIT
// Goals of feet stop at the floor, with their soles.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { drag, drop, openStudio, settled, state, visit } from './support.mjs';

const { site, browser } = await visit();

const step = (up, rotation_xyzw) => JSON.stringify({ version: 1, goals: [{ effector: 'left_foot', position_m: [0.1, up, 0.3], ...(rotation_xyzw && { rotation_xyzw }) }] });

test('a foot that is dragged or typed below the floor stops there', { timeout: 180_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url);
  await settled(page);
  await drop(page, 'step.json', step(0.3));
  await page.waitForFunction(() => window.shigusa.document.goals[0].effector === 'left_foot');
  await settled(page);
  const least = await page.evaluate(() => window.shigusa.document.character.description.feet.find(({ effector }) => effector === 'left_foot').least_m);
  const height = async () => (await state(page)).goals[0].position_m[1];

  await drag(page, 'left_foot', 0, 300);
  await settled(page);
  assert.equal(await height(), least);
  assert.notEqual((await state(page)).notice?.kind, 'failure');

  await page.click('#tab-goals');
  const field = page.locator('[data-key="left_foot up"]');
  for (const text of ['1', '-200']) {
    await field.fill(text);
    await field.press('Enter');
    await settled(page);
    assert.equal(await height(), least);
    assert.equal(await field.inputValue(), (100 * least).toFixed(1));
  }
  const end = await page.evaluate(() => window.shigusa.hand('left_foot'));
  assert.ok(Math.abs(end[1] - least) < 1e-3, `ends at ${end[1]} m`);

  // toes down, the ankle has to be higher: what a task says is told, what a person does then stops there
  const half = Math.PI / 9;
  await drop(page, 'tip.json', step(least, [Math.sin(half), 0, 0, Math.cos(half)]));
  await page.waitForFunction(() => window.shigusa.state.notice?.kind === 'failure');
  assert.match(await page.locator('.message').innerText(), /left_foot.*below the floor/);
  await drop(page, 'tip.json', step(0.25, [Math.sin(half), 0, 0, Math.cos(half)]));
  await page.waitForFunction(() => window.shigusa.document.goals[0].rotation_xyzw !== undefined);
  await settled(page);
  await field.fill('2');
  await field.press('Enter');
  await page.waitForFunction(() => window.shigusa.document.goals[0].position_m[1] !== 0.25);
  await settled(page);
  assert.ok((await height()) > least + 0.05);
  assert.deepEqual(errors, []);
  await context.close();
});
