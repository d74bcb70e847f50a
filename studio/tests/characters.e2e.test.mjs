// SPDX-License-Identifier: MIT
// The characters that were opened stay, each with what was last done with it. The file is the page's own body, taken away as BVH.
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { seriousFindings } from './axe.mjs';
import { drop, openStudio, openTab, settled, state, take, visit } from './support.mjs';

const { site, browser } = await visit();

const shelf = (page) => page.evaluate(() => window.shigusa.state.shelf.map(({ character }) => character.spec.source));
const source = (page) => page.evaluate(() => window.shigusa.document.character.spec.source);

async function dropped(page, name, bytes) {
  await drop(page, name, bytes);
  await page.waitForFunction((file) => window.shigusa.document.character.spec.source === file, name, { timeout: 60_000 });
  await settled(page);
}

/** Whether the picture of a row shows anything. */
const isDrawn = (page, row) => page.waitForFunction((n) => {
  const canvas = document.querySelectorAll('.characters .portrait')[n];
  if (!canvas || canvas.width === 0) return false;
  return canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.some((value) => value > 0);
}, row, { timeout: 30_000 });

test('characters are kept with what was done with them, and switched', { timeout: 240_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url, { seen: true });
  await settled(page);
  const bvh = await take(page, 'bvh');
  await dropped(page, 'person.bvh', bvh);
  await dropped(page, 'small.bvh', bvh);
  assert.deepEqual(await shelf(page), ['human', 'person.bvh', 'small.bvh']);
  await page.keyboard.press('Digit2');
  const left = await state(page);
  await openTab(page, 'body');
  const rows = page.locator('.characters li');
  assert.equal(await rows.count(), 3);
  assert.match(await rows.nth(0).innerText(), /Person\s+1\d\d cm, \d+ kg/);
  await isDrawn(page, 2);
  assert.match(await rows.nth(2).innerText(), /small\.bvh[^]*no mesh/);
  assert.deepEqual(await seriousFindings(page, '.side'), []);

  await rows.nth(0).locator('.pick-character').click();
  await page.waitForFunction(() => window.shigusa.document.character.spec.source === 'human');
  await settled(page);
  assert.equal(await rows.nth(0).locator('.pick-character').getAttribute('aria-pressed'), 'true');
  await rows.nth(2).locator('.pick-character').click();
  await page.waitForFunction(() => window.shigusa.document.character.spec.source === 'small.bvh');
  await settled(page);
  const back = await state(page);
  assert.deepEqual([back.words, back.chosen, back.goals], [left.words, left.chosen, left.goals], 'as it was left');
  assert.equal(back.search, null, 'nothing is searched again');

  // a slider still works on a character that came back
  await page.click('#tab-adjust');
  await page.locator('.slider .number').first().fill('30');
  await page.locator('.slider .number').first().press('Enter');
  await page.waitForFunction(() => Object.keys(window.shigusa.document.edits).length === 1);

  // the same file again has no second place; another of its name has one
  await dropped(page, 'person.bvh', bvh);
  assert.deepEqual(await shelf(page), ['human', 'person.bvh', 'small.bvh']);
  await drop(page, 'person.bvh', `${bvh}\n`);
  await page.waitForFunction(() => window.shigusa.state.shelf.length === 4);
  await settled(page);

  await openTab(page, 'body');
  await rows.nth(1).locator('.icon-button').click();
  assert.equal(await rows.count(), 3);
  assert.equal(await rows.nth(2).locator('.icon-button').count(), 0, 'the one at hand stays');
  await page.getByLabel('Built-in body').selectOption('half_body');
  await page.waitForFunction(() => window.shigusa.document.character.spec.source === 'half_body');
  await settled(page);
  assert.deepEqual(await shelf(page), ['human', 'small.bvh', 'person.bvh', 'half_body']);
  await page.keyboard.press('Control+z');
  await page.waitForFunction(() => window.shigusa.document.character.spec.source === 'person.bvh');
  assert.equal(await source(page), 'person.bvh');
  assert.deepEqual(errors, []);
  await context.close();
});

test('stature is asked for where the file has none, and given in centimetres', { timeout: 180_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url);
  await settled(page);
  const bvh = (await take(page, 'bvh')).toString();
  // twice as large: no unit makes a person of that
  const large = bvh.replace(/OFFSET ([^\r\n]*)/g, (_, numbers) => `OFFSET ${numbers.trim().split(/\s+/).map((value) => 2 * Number(value)).join(' ')}`);
  await dropped(page, 'large.bvh', large);
  await page.locator('#panel-body .asked').waitFor(); // the panel comes where it is asked for
  assert.match(await page.locator('.asked').innerText(), /170 cm is a guess/);
  const field = page.locator('[data-key="stature"]');
  assert.equal(await field.inputValue(), '170');
  await field.fill('9');
  await field.press('Enter');
  await page.waitForFunction(() => window.shigusa.state.notice?.key === 'badRange');
  assert.match(await page.locator('.message').innerText(), /50 to 250 cm, not “9”/);
  assert.equal(await field.inputValue(), '170');
  await field.fill('182');
  await field.press('Enter');
  await page.waitForFunction(() => Math.abs(window.shigusa.document.character.description.stature_m - 1.82) < 1e-9);
  await settled(page);
  assert.equal(await page.locator('.asked').count(), 0);
  assert.deepEqual(errors, []);
  await context.close();
});

test('a person starts from a frame of the file, or at rest', { timeout: 180_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url);
  await settled(page);
  const bvh = await take(page, 'bvh');
  await dropped(page, 'person.bvh', bvh);
  await openTab(page, 'body');
  const hand = () => page.evaluate(() => window.shigusa.document.character.description.places.find(({ effector }) => effector === 'right_hand').start_m[1]);
  const opened = async (act) => {
    const id = await page.evaluate(() => window.shigusa.document.character.id);
    await act();
    await page.waitForFunction((old) => window.shigusa.document.character.id !== old, id, { timeout: 30_000 });
    await settled(page);
  };
  const first = await hand();
  const choice = page.locator('[data-key="start posture"]');
  assert.equal(await page.locator('[data-key="frame"]').count(), 0);
  await opened(() => choice.selectOption({ label: 'from a frame' }));
  const frame = page.locator('[data-key="frame"]');
  const last = Number(await frame.getAttribute('max'));
  assert.ok(last > 20);
  await opened(async () => {
    await frame.fill('999');
    await frame.press('Enter');
  });
  assert.equal(await page.evaluate(() => window.shigusa.document.character.spec.frame), last);
  assert.equal(await frame.inputValue(), String(last));
  assert.ok((await hand()) < first - 0.05, 'as the reach ends: the hand is low');
  assert.deepEqual(await seriousFindings(page, '#panel-body'), []);
  await opened(() => choice.selectOption({ label: 'at rest' }));
  assert.ok((await hand()) > first - 0.05);
  assert.equal(await page.evaluate(() => window.shigusa.document.character.spec.frame), 'rest');
  assert.deepEqual(errors, []);
  await context.close();
});

const knight = fileURLToPath(new URL('../../../shared/characters/KayKit_Knight.glb', import.meta.url));
test('the animations of a glTF file are offered by name', { skip: !existsSync(knight) && 'no knight here', timeout: 120_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url);
  await settled(page);
  await dropped(page, 'knight.glb', readFileSync(knight));
  await openTab(page, 'body');
  const names = await page.evaluate(() => window.shigusa.document.character.description.animations);
  assert.ok(names.length > 1);
  const choice = page.locator('[data-key="start posture"]');
  assert.equal((await choice.locator('option').allInnerTexts()).length, names.length + 2);
  await choice.selectOption({ label: names[1] });
  await page.waitForFunction((name) => window.shigusa.document.character.spec.animation === name, names[1], { timeout: 30_000 });
  await settled(page);
  assert.ok(await page.locator('[data-key="frame"]').isVisible());
  assert.equal((await shelf(page)).length, 2, 'the same knight');
  assert.deepEqual(errors, []);
  await context.close();
});
