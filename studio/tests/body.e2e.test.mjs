// SPDX-License-Identifier: MIT
// Whose body it is: a file's bone map mended by hand, and how a goal turns its hand. Needs no characters of
// others: the person is the page's own body, taken away as BVH and dropped back.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { angleBetween, turnByRings } from './rings.mjs';
import { drop, openStudio, openTab, settled, state, take, visit } from './support.mjs';

const { site, browser } = await visit();

const character = (page) => page.evaluate(() => {
  const { id, spec, description } = window.shigusa.document.character;
  return { id, map: spec.map, humanoid: description.humanoid, doubts: description.doubts };
});

/** Sets rows of the bone map and applies them; back when the character is read or has been refused. */
async function mend(page, rows) {
  const { id } = await character(page);
  for (const [bone, node] of rows) await page.locator(`[data-bone="${bone}"]`).selectOption(node);
  await page.locator('[data-key="apply map"]').click();
  await page.waitForFunction((old) => window.shigusa.document.character.id !== old || window.shigusa.state.notice?.kind === 'failure', id, { timeout: 60_000 });
  await settled(page);
}

test('a row of the bone map is changed, and a wrong one is told of', { timeout: 240_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url);
  await settled(page);
  await drop(page, 'person.bvh', await take(page, 'bvh'));
  await page.waitForFunction(() => window.shigusa.document.character.spec.source === 'person.bvh', undefined, { timeout: 60_000 });
  await settled(page);
  assert.deepEqual((await character(page)).doubts, []);
  await openTab(page, 'body');
  assert.ok(await page.locator('[data-key="apply map"]').isHidden(), 'the table is closed at first');
  await page.locator('summary').filter({ hasText: 'Bones' }).click();
  assert.ok(await page.locator('[data-key="apply map"]').isDisabled(), 'nothing to apply yet');

  // the hand is where it grips: the forearm is longer than the other one
  await mend(page, [['right_hand', 'right_hand_grip']]);
  const mended = await character(page);
  assert.deepEqual(mended.map, { right_hand: 'right_hand_grip' });
  assert.equal(mended.humanoid.right_hand, 'right_hand_grip');
  assert.match(mended.doubts.join(), /forearm/);
  assert.equal(await page.locator('[data-bone="right_hand"]').inputValue(), 'right_hand_grip');
  assert.equal((await state(page)).status, 'reached');

  const wrong = [
    ['a hand that is a foot', [['left_hand', 'left_foot']], /left_foot/],
    ['two bones of one node', [['left_lower_arm', 'left_hand'], ['left_upper_arm', 'left_hand']], /left_hand/],
    ['arms the wrong way about', [['left_upper_arm', 'left_lower_arm'], ['left_lower_arm', 'left_upper_arm']], /left_(upper|lower)_arm/],
  ];
  for (const [name, rows, told] of wrong) {
    await mend(page, rows);
    const now = await state(page);
    assert.equal(now.notice?.kind, 'failure', name);
    assert.match(await page.locator('.message').innerText(), told, name);
    assert.equal((await character(page)).id, mended.id, `${name}: the character stays`);
    assert.equal(await page.locator(`[data-bone="${rows[0][0]}"]`).inputValue(), rows[0][0], `${name}: the table shows what holds`);
    await page.locator('.message .icon-button').click();
  }

  // the page goes on: back to the hand as found, and a step back
  await mend(page, [['right_hand', 'right_hand']]);
  assert.equal((await character(page)).humanoid.right_hand, 'right_hand');
  await page.keyboard.press('Control+z');
  await page.waitForFunction((id) => window.shigusa.document.character.id === id, mended.id);
  await settled(page);
  assert.equal(await page.locator('[data-bone="right_hand"]').inputValue(), 'right_hand_grip');
  assert.deepEqual(errors, []);
  await context.close();
});

test('rings turn a goal that asks for a rotation', { timeout: 240_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url);
  await settled(page);
  const before = (await state(page)).goals[0];
  assert.equal(before.rotation_xyzw, undefined);
  const reached = () => page.evaluate(() => window.shigusa.document.result.summary.candidates[window.shigusa.chosen].reached[0]);
  const free = await reached();
  await page.locator('[data-key="right_hand turn"]').click();
  await page.waitForFunction(() => window.shigusa.document.goals[0].rotation_xyzw !== undefined);
  await settled(page);
  assert.deepEqual((await state(page)).goals[0].rotation_xyzw, free.rotation_xyzw, 'as the hand was');
  await page.locator('[data-key="right_hand rings"]').setChecked(true);
  await turnByRings(page, 'right_hand', () => page.evaluate(() => window.shigusa.document.goals[0].rotation_xyzw));
  const now = await state(page);
  assert.deepEqual(now.goals[0].position_m, before.position_m);
  assert.equal(now.status, 'reached');
  const turned = await reached();
  assert.ok(turned.rotation_error_deg <= 0.5, `${turned.rotation_error_deg}° are left`);
  assert.ok(angleBetween(turned.rotation_xyzw, now.goals[0].rotation_xyzw) <= 0.5);
  assert.deepEqual(errors, []);
  await context.close();
});
