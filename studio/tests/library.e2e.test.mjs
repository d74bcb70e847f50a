// SPDX-License-Identifier: MIT
// The library: goals and start postures are kept under names with pictures, used in any project, and carried as JSON.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';
import { seriousFindings } from './axe.mjs';
import { records } from './kept.mjs';
import { drop, openStudio, openTab, settled, visit } from './support.mjs';

const { site, browser } = await visit();

const asked = (page) => page.evaluate(() => {
  const { goals, settings, character } = window.shigusa.document;
  return { goals, things: settings.more.obstacles ?? [], seat: character.spec.seat_m };
});
const entry = (page, name) => page.locator('.library li').filter({ has: page.locator('b').getByText(name, { exact: true }) });
const use = (page, name) => entry(page, name).locator('.pick-character').click();
const undo = (page) => page.keyboard.press('Control+z');
const pick = (page, text, name = 'library.json') =>
  page.locator('[data-library="file"]').setInputFiles({ name, mimeType: 'application/json', buffer: Buffer.from(text) });

test('goals with things in the way and start postures are kept, used by a click as one step, renamed, deleted, brought back and carried', { timeout: 300_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url, { seen: true, viewport: { width: 940, height: 620 } });
  await settled(page);
  await page.click('[data-key="add thing"]');
  await settled(page);
  const first = await asked(page);
  assert.equal(first.things.length, 1);
  await page.click('[data-library="keep goals"]');
  await entry(page, 'Goals 1').waitFor();
  const [record] = await records(page, 'poses');
  assert.match(record.picture, /^data:image\/jpeg;base64,.{1000,}/);
  assert.deepEqual([record.goals, record.things], [first.goals, first.things]);

  await page.keyboard.press('Escape');
  await undo(page);
  await settled(page);
  await page.locator('.goal').filter({ hasText: 'Left hand' }).locator('input[type="checkbox"]').first().click();
  await settled(page);
  const second = await asked(page);
  assert.equal(second.goals.length, 2);
  await use(page, 'Goals 1');
  await page.waitForFunction(() => window.shigusa.document.goals.length === 1);
  await settled(page);
  assert.deepEqual(await asked(page), first);
  await page.locator('#tab-goals').focus();
  await undo(page);
  await settled(page);
  assert.deepEqual(await asked(page), second, 'one step of undo');

  // a seat, kept and used again by the one who stands
  await openTab(page, 'body');
  await page.check('[data-key="seated"]');
  await page.waitForFunction(() => window.shigusa.document.character.spec.seat_m > 0);
  await settled(page);
  const seated = await asked(page);
  await page.click('#tab-goals');
  await page.click('[data-library="keep start"]');
  await entry(page, 'Start posture 1').waitFor();
  await page.locator('#tab-goals').focus();
  await undo(page);
  await page.waitForFunction(() => window.shigusa.document.character.spec.seat_m === undefined);
  await settled(page);
  await use(page, 'Start posture 1');
  await page.waitForFunction(() => window.shigusa.document.character.spec.seat_m > 0);
  await settled(page);
  assert.deepEqual(await asked(page), seated);

  await entry(page, 'Goals 1').getByRole('button', { name: 'Rename “Goals 1”' }).click();
  await page.locator('.naming input').fill('Across');
  await page.keyboard.press('Enter');
  await entry(page, 'Across').waitFor();
  await entry(page, 'Across').getByRole('button', { name: 'Delete “Across”' }).click();
  await entry(page, 'Across').waitFor({ state: 'detached' });
  assert.equal((await records(page, 'poses')).length, 1);
  await page.click('[data-library="undo"]');
  await entry(page, 'Across').waitFor();
  assert.deepEqual(await seriousFindings(page, '#panel-goals'), []);

  await page.reload();
  await settled(page);
  await entry(page, 'Across').waitFor();
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('[data-library="export"]')]);
  const text = await readFile(await download.path(), 'utf8');
  const elsewhere = await openStudio(browser, site.url, { viewport: { width: 940, height: 620 } });
  await settled(elsewhere.page);
  await pick(elsewhere.page, text);
  await entry(elsewhere.page, 'Across').waitFor();
  await use(elsewhere.page, 'Across');
  await elsewhere.page.waitForFunction(() => window.shigusa.document.settings.more.obstacles?.length === 1);
  await settled(elsewhere.page);
  assert.deepEqual(await asked(elsewhere.page), first);
  const plain = (list) => list.map(({ id: _, changed_ms: __, ...rest }) => JSON.parse(JSON.stringify(rest))).sort((a, b) => a.name.localeCompare(b.name));
  assert.deepEqual(plain(await records(elsewhere.page, 'poses')), plain(await records(page, 'poses')));
  assert.deepEqual([...errors, ...elsewhere.errors], []);
  await elsewhere.context.close();
  await context.close();
});

test('a damaged library is told of and adds nothing; what the engine refuses changes nothing', { timeout: 240_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url, { viewport: { width: 940, height: 620 } });
  await settled(page);
  const goal = { effector: 'right_hand', position_m: [0.2, 0.9, 0.4] };
  const good = { name: 'Good', kind: 'goals', goals: [goal], things: [] };
  // all that is refused of one: work.test.mjs
  const bad = ['{', JSON.stringify({ shigusa_library: 1, entries: [good, { ...good, kind: 'film' }] })];
  for (const text of bad) {
    await page.evaluate(() => document.querySelector('.message .icon-button')?.click());
    await page.waitForFunction(() => window.shigusa.state.notice === null);
    await pick(page, text, 'bad.json');
    await page.waitForFunction(() => window.shigusa.state.notice?.kind === 'failure');
    assert.match(await page.locator('.message').innerText(), /bad\.json/, text.slice(0, 200));
  }
  await pick(page, ' '.repeat(8_000_001), 'large.json');
  await page.waitForFunction(() => window.shigusa.state.notice?.key === 'tooLarge');
  assert.equal((await records(page, 'poses')).length, 0);

  // well formed, but nothing that a body could be asked for
  const entries = [{ ...good, name: 'Axis', goals: [{ ...goal, axis: { axis: 'elbow', direction: 'up' } }] }, { ...good, name: 'Wings', goals: [{ ...goal, effector: 'left_wing' }] },
    { name: 'Frame', kind: 'start', start: { source: 'other.bvh', frame: 3 } }];
  await pick(page, JSON.stringify({ shigusa_library: 1, entries }));
  await entry(page, 'Wings').waitFor();
  const before = await asked(page);
  const notices = { Axis: /axis/, Wings: /none of the parts that “Wings”/, Frame: /“Frame” is a posture of “other\.bvh”/ };
  for (const [name, told] of Object.entries(notices)) {
    await page.evaluate(() => document.querySelector('.message .icon-button')?.click());
    await use(page, name);
    await page.waitForFunction(() => window.shigusa.state.notice !== null);
    assert.match(await page.locator('.message').innerText(), told);
    assert.deepEqual(await asked(page), before);
  }
  assert.equal(await page.evaluate(() => window.shigusa.state.canUndo), false);
  assert.deepEqual(errors, []);
  await context.close();
});

test('a library that is dropped on the page is added, and a damaged one told of', { timeout: 120_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url);
  await settled(page);
  await openTab(page, 'body');
  const before = await asked(page);
  const good = { name: 'Dropped', kind: 'goals', goals: [{ effector: 'right_hand', position_m: [0.2, 0.9, 0.4] }], things: [] };
  await drop(page, 'bad.json', JSON.stringify({ shigusa_library: 1, entries: [{ ...good, name: '' }] }));
  await page.locator('.message', { hasText: 'bad.json' }).waitFor();
  await drop(page, 'library.json', JSON.stringify({ shigusa_library: 1, entries: [good] }));
  await page.locator('.message', { hasText: 'Added from the file: 1' }).waitFor();
  await entry(page, 'Dropped').waitFor();
  assert.equal(await page.evaluate(() => window.shigusa.state.tab), 'goals', 'where it is');
  assert.deepEqual(await asked(page), before, 'the task is as it was');
  assert.equal((await records(page, 'poses')).length, 1);
  await use(page, 'Dropped');
  await page.waitForFunction(() => window.shigusa.document.goals[0].position_m[0] === 0.2);
  assert.deepEqual(errors, []);
  await context.close();
});
