// SPDX-License-Identifier: MIT
// A newcomer's way from opening the page to a file of their own character in a motion that they adjusted, counted by actions. The
// character is the page's own body, taken away as GLB.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';
import { endOfNode, parseGlb } from './glb.mjs';
import { drag, openStudio, openTab, settled, slide, take, visit } from './support.mjs';

const { site, browser } = await visit();

const kMost = 8; // actions

test('from opening to one’s own character in an adjusted motion in eight actions', { timeout: 240_000 }, async () => {
  const maker = await openStudio(browser, site.url);
  await settled(maker.page);
  const own = await take(maker.page, 'glb');
  await maker.context.close();

  const { page, context, errors } = await openStudio(browser, site.url, { cards: true, seen: true });
  await settled(page);
  let actions = 0;
  const act = async (action) => {
    ++actions;
    const result = await action();
    await settled(page);
    return result;
  };
  const chooser = await act(async () => (await Promise.all([page.waitForEvent('filechooser'), page.click('[data-start="vrm"]')]))[0]);
  await act(async () => {
    await chooser.setFiles({ name: 'mine.glb', mimeType: 'model/gltf-binary', buffer: own });
    await page.waitForFunction(() => window.shigusa.document.character.spec.source === 'mine.glb', undefined, { timeout: 60_000 });
  });
  const goal = await page.evaluate(() => window.shigusa.document.goals[0].position_m);
  await act(() => drag(page, 'right_hand', 30, 40));
  assert.notDeepEqual(await page.evaluate(() => window.shigusa.document.goals[0].position_m), goal, 'the goal is elsewhere');
  await act(() => page.locator('.card .pick').nth(1).click());
  await act(() => page.click('#tab-adjust'));
  await act(async () => {
    await slide(page, '[data-parameter="squat_deg"]', 0.35);
    await page.waitForFunction(() => Object.keys(window.shigusa.document.edits).length === 1, undefined, { timeout: 20_000 });
  });
  await act(() => openTab(page, 'take'));
  const [download] = await act(() => Promise.all([page.waitForEvent('download'), page.click('[data-format="glb"]')]));
  assert.ok(actions <= kMost, `${actions} actions`);

  const glb = parseGlb(await readFile(await download.path()));
  assert.ok(glb.json.animations.at(-1).channels.length > 10);
  assert.equal(glb.json.skins.length, 1, 'the character’s own skin');
  const { place, wanted } = await page.evaluate(() => ({ place: window.shigusa.hand(), wanted: window.shigusa.document.goals[0].position_m }));
  assert.ok(Math.hypot(...place.map((x, k) => x - wanted[k])) < 0.002, 'the adjusted motion still ends on the goal');
  const before = await page.evaluate(() => window.shigusa.document.result.candidates[window.shigusa.chosen].parameters.find(({ name }) => name === 'squat_deg').value);
  const after = await page.evaluate(() => Number(window.shigusa.document.edits[window.shigusa.chosen].assignments.squat_deg));
  assert.ok(Math.abs(after - before) > 5, `${before}° became ${after}°`);
  const hips = glb.json.nodes.find(({ name }) => /hips/i.test(name)).name;
  assert.ok(endOfNode(glb, hips)[1] > 0.2, 'the file moves the body');
  assert.deepEqual(errors, []);
  await context.close();
});
