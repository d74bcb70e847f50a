// SPDX-License-Identifier: MIT
// A habit, by its name or as the numbers of a task: chosen, explained, undone, kept in files.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { ask, drawn, drop, openStudio, settled, take, visit } from './support.mjs';

const { site, browser } = await visit();

const habit = (page) => page.evaluate(() => window.shigusa.task.habit);
const first = (page) => page.evaluate(() => ({ words: window.shigusa.words[0], knees: window.shigusa.document.result.candidates[0].summary.final_posture.knee_flexion_deg }));
/** Their select, and the names that a person can choose. */
const choice = (page) => page.locator('#panel-goals select').filter({ has: page.locator('option[value="stoop"]') });
const shown = (page) => choice(page).evaluate((select) => [...select.options].filter(({ hidden }) => !hidden).map(({ value }) => value));

async function choose(page, name) {
  await page.click('#tab-goals');
  await choice(page).selectOption(name);
  await settled(page);
}

test('a habit changes the motions, is undone, and is absent from a task where it is natural', { timeout: 120_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url);
  await settled(page);
  const names = await page.evaluate(() => window.shigusa.facts.habits.map(({ name }) => name));
  assert.deepEqual(await shown(page), names);
  assert.equal(await choice(page).inputValue(), 'natural');
  const before = await first(page);
  await choose(page, 'stoop');
  assert.equal(await habit(page), 'stoop');
  const after = await first(page);
  assert.notEqual(after.words, before.words);
  assert.ok(after.knees < before.knees / 2, `knees at ${after.knees}° in place of ${before.knees}°`);
  await page.click('[aria-label="Undo"]');
  await settled(page);
  assert.equal(await habit(page), undefined);
  assert.deepEqual(await first(page), before);
  assert.equal(await choice(page).inputValue(), 'natural');
  await choose(page, 'squat');
  await choose(page, 'natural');
  assert.equal(await habit(page), undefined);
  assert.deepEqual(errors, []);
  await context.close();
});

test('a task’s numbers are kept as learned until a name is chosen', { timeout: 120_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url);
  await settled(page);
  const before = await first(page);
  const { goals } = await page.evaluate(() => window.shigusa.task);
  const numbers = { knees: 0.3, round_rad: 0.1 };
  await drop(page, 'task.json', JSON.stringify({ version: 1, goals, habit: numbers }));
  await page.waitForFunction(() => typeof window.shigusa.task.habit === 'object');
  await settled(page);
  assert.deepEqual(await habit(page), numbers);
  assert.ok((await first(page)).knees < before.knees, 'motions follow them');
  assert.equal(await choice(page).inputValue(), 'learned');
  assert.equal((await shown(page)).at(-1), 'learned');
  assert.deepEqual(JSON.parse(new TextDecoder().decode(await take(page, 'task'))).habit, numbers);
  await choose(page, 'half');
  assert.equal(await habit(page), 'half');
  assert.ok(!(await shown(page)).includes('learned'));
  assert.deepEqual(errors, []);
  await context.close();
});

test('each habit is explained in both languages; presets of the paper have none', { timeout: 120_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url);
  await settled(page);
  const count = await page.evaluate(() => window.shigusa.facts.habits.length);
  for (const language of ['ja', 'en']) {
    await page.locator('.topbar select').last().selectOption(language);
    await page.waitForFunction((code) => document.documentElement.lang === code, language);
    await page.click('#tab-goals');
    await choice(page).scrollIntoViewIfNeeded();
    await drawn(page); // scrolling takes a tip away
    await choice(page).hover();
    await page.locator('.tip').waitFor();
    const lines = (await page.locator('.tip').innerText()).trim().split('\n');
    assert.equal(lines.filter((line) => line !== '').length, count, lines.join(' | '));
    await page.keyboard.press('Escape');
    await page.mouse.move(0, 0);
  }
  assert.ok(await choice(page).isEnabled());
  await ask(page, { goals: [{ effector: 'right_hand', position_m: [-0.2, 0.9, 0.5] }], preset: 'layers', evaluations: 60 });
  assert.ok(await choice(page).isDisabled());
  assert.deepEqual(errors, []);
  await context.close();
});
