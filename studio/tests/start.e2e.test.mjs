// SPDX-License-Identifier: MIT
// The cards to begin with: seen at a first visit, each opens a task with motions that a body can make.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { seriousFindings } from './axe.mjs';
import { drag, drop, openStudio, settled, visit } from './support.mjs';

const { site, browser } = await visit();

const cards = (page) => page.locator('.start');
const task = (page) => page.evaluate(() => {
  const { document: d, task: asked } = window.shigusa;
  const { status, candidates } = d.result.summary;
  return { goals: d.goals, obstacles: asked.obstacles, seat: d.character.spec.seat_m, status, verdicts: candidates.map(({ verdict }) => verdict) };
});

test('each card opens a task with motions at once', { timeout: 240_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url, { cards: true });
  await settled(page);
  assert.ok(await cards(page).isVisible());
  assert.equal(await cards(page).locator('.start-card').count(), 6);
  assert.deepEqual(await seriousFindings(page, '.start'), []);
  const opened = {};
  for (const name of ['pick', 'shelf', 'box', 'seated', 'overhead']) {
    const before = await page.evaluate(() => window.shigusa.document.goals[0].position_m.join());
    await page.click(`[data-start="${name}"]`);
    await page.waitForFunction((old) => window.shigusa.document.goals[0].position_m.join() !== old, before, { timeout: 30_000 });
    await settled(page);
    opened[name] = await task(page);
    assert.equal(opened[name].status, 'reached', name);
    assert.ok(opened[name].verdicts.length >= 2, name);
    assert.ok(opened[name].verdicts.every((verdict) => verdict === 'possible'), `${name}: ${opened[name].verdicts}`);
  }
  assert.ok(opened.pick.goals[0].position_m[1] < 0.2);
  assert.equal(opened.shelf.obstacles.length, 1);
  assert.deepEqual(opened.box.goals.map(({ effector }) => effector), ['right_hand', 'left_hand']);
  assert.ok(opened.seated.seat > 0.3);
  assert.equal(opened.overhead.seat, undefined, 'who sat stands up');
  const [chooser] = await Promise.all([page.waitForEvent('filechooser'), page.click('[data-start="vrm"]')]);
  assert.ok(chooser.isMultiple());
  assert.deepEqual(errors, []);
  await context.close();
});

test('the cards go when a hand is dragged, come by a button, and are for the body at hand', { timeout: 120_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url, { cards: true });
  await settled(page);
  await drag(page, 'right_hand', 20, -20);
  await settled(page);
  assert.ok(await cards(page).isHidden());
  await page.reload();
  await settled(page);
  assert.ok(await cards(page).isHidden(), 'closed for good');
  const child = { character: { source: 'human', stature_m: 1.2 }, goals: [{ effector: 'right_hand', position_m: [-0.2, 0.8, 0.3] }] };
  await drop(page, 'task.json', JSON.stringify(child));
  await page.waitForFunction(() => window.shigusa.document.character.description.stature_m === 1.2);
  await settled(page);
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  await page.click('[data-start="overhead"]');
  await page.waitForFunction(() => window.shigusa.document.goals[0].position_m[1] > 1.3);
  await settled(page);
  const { goals, status } = await task(page);
  assert.ok(goals[0].position_m[1] < 1.4, 'scaled to who is small');
  assert.equal(status, 'reached');
  assert.deepEqual(errors, []);
  await context.close();
});

test('a link opens its task and no cards', { timeout: 120_000 }, async () => {
  const task64 = Buffer.from(JSON.stringify({ character: 'human', goals: [{ effector: 'right_hand', position_m: [-0.2, 1.2, 0.4] }] })).toString('base64url');
  const { page, context } = await openStudio(browser, `${site.url}#task=${task64}`, { cards: true });
  await settled(page);
  assert.ok(await cards(page).isHidden());
  await context.close();
});
