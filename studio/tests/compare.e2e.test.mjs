// SPDX-License-Identifier: MIT
// Two motions side by side are told apart, and a goal can be dragged there; mirroring takes the camera and the open sliders along.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { seriousFindings } from './axe.mjs';
import { ask, drag, drawn, openStudio, settled, visit } from './support.mjs';

const { site, browser } = await visit();
const { page, errors } = await openStudio(browser, site.url, { seen: true });
await settled(page);

const task = { character: 'human', goals: [{ effector: 'right_hand', position_m: [-0.25, 1, 0.45] }], obstacles: [{ name: 'box', position_m: [-0.5, 0.15, 0.6], size_m: [0.3, 0.3, 0.3] }] };

test('keys lead to the figure at once and to Save, and the last goal says why it stays', { timeout: 120_000 }, async () => {
  await ask(page, task);
  await page.evaluate(() => document.activeElement.blur());
  await page.keyboard.press('Tab');
  const skip = page.locator('.skip');
  assert.ok(await skip.evaluate((element) => element === document.activeElement && element.getBoundingClientRect().width > 60), 'it is seen with the focus');
  assert.deepEqual(await seriousFindings(page), []);
  await page.keyboard.press('Enter');
  assert.ok(await page.evaluate(() => document.activeElement.matches('canvas.view')));
  assert.match(await page.locator('[data-key="right_hand has"]').getAttribute('title'), /only goal/);
  await page.keyboard.press('Control+s');
  await page.waitForFunction(() => window.shigusa.state.tab === 'take');
  assert.deepEqual(errors, []);
});

test('two motions side by side have signs with their numbers and durations, and handles', { timeout: 180_000 }, async () => {
  await ask(page, task);
  assert.deepEqual(await page.evaluate(() => window.shigusa.tags), []);
  const alone = await page.evaluate(() => window.shigusa.handle('right_hand'));
  await page.keyboard.press('Shift+Digit3');
  await page.waitForFunction(() => window.shigusa.document.compared !== null && window.shigusa.tags.length === 2);
  await drawn(page);
  const { tags, durations } = await page.evaluate(() => {
    const { document: d, tags: texts } = window.shigusa;
    return { tags: texts, durations: [d.chosen, d.compared].map((index) => d.result.candidates[index].summary.duration_s.toFixed(2)) };
  });
  assert.deepEqual(tags, [`1 · ${durations[0]} s`, `3 · ${durations[1]} s`]);
  await page.locator('.scrub').evaluate((range) => {
    range.value = '0';
    range.dispatchEvent(new Event('input', { bubbles: true }));
  });
  for (const key of ['', 'v', 'v', 'v', 'v']) {
    if (key !== '') await page.keyboard.press(key);
    await drawn(page);
    const [chosen, other] = await page.evaluate(() => window.shigusa.sizes);
    // from above they are looked at along their length
    assert.ok(Math.abs(chosen - other) < 0.005 * Math.max(Math.abs(chosen), 0.2), `${chosen} and ${other} of the picture's height`);
  }
  const beside = await page.evaluate(() => window.shigusa.handle('right_hand'));
  assert.ok(Math.hypot(beside[0] - alone[0], beside[1] - alone[1]) > 20, 'the handle goes with its figure');

  const before = await page.evaluate(() => window.shigusa.document.goals[0].position_m);
  await drag(page, 'right_hand', 0, -40, { hold: 30 });
  await settled(page);
  const after = await page.evaluate(() => window.shigusa.document.goals[0].position_m);
  assert.ok(after[1] > before[1] + 0.03, `${after[1]} m`);
  assert.ok(Math.hypot(after[0] - before[0], after[2] - before[2]) < 0.06, 'up, and not to the other side');
  await page.waitForFunction(() => window.shigusa.tags.length === 0);
  assert.deepEqual(errors, []);
});

test('who mirrors sees the hand that acts now, and its sliders', { timeout: 120_000 }, async () => {
  await ask(page, task);
  await page.click('#tab-adjust');
  const group = (name) => page.locator('#panel-adjust details').filter({ has: page.locator('summary', { hasText: name }) });
  await group('Right arm').locator('summary').click();
  const [x, y, z] = await page.evaluate(() => window.shigusa.look().position_m);
  await page.keyboard.press('m');
  await page.waitForFunction(() => window.shigusa.document.goals[0].effector === 'left_hand');
  await drawn(page);
  const now = await page.evaluate(() => window.shigusa.look().position_m);
  assert.ok(Math.hypot(now[0] + x, now[1] - y, now[2] - z) < 1e-6, `${now}`);
  assert.equal(await group('Left arm').getAttribute('open'), '');
  assert.equal(await group('Right arm').getAttribute('open'), null);
  assert.deepEqual(errors, []);
});
