// SPDX-License-Identifier: MIT
// Files that come together: each character is there, and what was not opened is told.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { dropAll, eventually, openStudio, settled, take, visit } from './support.mjs';

const { site, browser } = await visit();

const shelf = (page) => page.evaluate(() => window.shigusa.state.shelf.map(({ character }) => character.spec.source));
const shown = (page) => page.evaluate(() => window.shigusa.document.character.spec.source);
const message = (page) => page.locator('.message').innerText();

test('several characters that are dropped are all there, the first in the view; what was refused is told with why', { timeout: 180_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url);
  await settled(page);
  const own = await take(page, 'glb');
  const task = JSON.stringify({ version: 1, goals: [{ effector: 'right_hand', position_m: [0, 1, 0.4] }] });
  await dropAll(page, [['notes.txt', 'mine'], ['a.glb', own], ['broken.bvh', 'Dear reader'], ['b.glb', own], ['c.glb', own]]);
  const said = await eventually(() => message(page), /b\.glb, c\.glb/);
  await settled(page);
  assert.equal(await shown(page), 'a.glb');
  assert.deepEqual((await shelf(page)).slice(-3), ['a.glb', 'b.glb', 'c.glb']);
  assert.match(said, /notes\.txt: only characters in .*broken\.bvh cannot be read\..*HIERARCHY/s);
  assert.ok(await page.locator('.message').evaluate((element) => element.classList.contains('bad')));
  assert.equal(await page.evaluate(() => window.shigusa.state.tab), 'body');
  // a click shows another, with motions
  await page.locator('.characters .pick-character', { hasText: 'c.glb' }).click();
  await settled(page);
  assert.equal(await shown(page), 'c.glb');

  // a task, its own list, and a character that is there already
  await dropAll(page, [['b.glb', own], ['task.json', task], ['task-2.json', task]]);
  await eventually(() => message(page), /b\.glb.*task-2\.json: results and tasks are opened one at a time/s);
  assert.equal((await shelf(page)).filter((name) => name === 'b.glb').length, 1);
  await settled(page);
  assert.deepEqual(await page.evaluate(() => window.shigusa.document.goals[0].position_m), [0, 1, 0.4]);
  assert.deepEqual(errors, []);
  await context.close();
});
