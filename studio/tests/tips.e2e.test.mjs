// SPDX-License-Identifier: MIT
// What each slider does, in a sentence with a picture: by pointer, by keys and by touch.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { seriousFindings } from './axe.mjs';
import { ask, openStudio, settled, visit } from './support.mjs';

const { site, browser } = await visit();

const tip = (page) => page.locator('.tip');
const slider = (page, name) => page.locator(`[data-parameter="${name}"]`);

/** The heights, px, of the heads of a tip's two figures. */
async function heads(page) {
  await page.waitForFunction(() => document.querySelectorAll('.tip .tip-picture .head').length === 2, undefined, { timeout: 60_000 });
  return page.evaluate(() => [...document.querySelectorAll('.tip .tip-picture .head')].map((head) => Number(head.getAttribute('cy'))));
}

test('a tip shows what a slider comes to at both ends, and changes nothing', { timeout: 120_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url);
  await settled(page);
  await page.click('#tab-adjust');
  const edits = () => page.evaluate(() => Object.keys(window.shigusa.document.edits).length);

  await slider(page, 'squat_deg').hover();
  await tip(page).waitFor();
  const [straight, bent] = await heads(page); // with which the captions come
  assert.match(await tip(page).innerText(), /knees end bent[^]*0°[^]*130°/);
  assert.ok(bent > straight + 4, 'who squats is lower');
  assert.deepEqual(await seriousFindings(page, '.tip'), []);
  await page.keyboard.press('Escape');
  assert.ok(await tip(page).isHidden());

  // by keys: the focus brings it, another field takes it away
  await page.locator('.row .number').first().focus();
  await page.keyboard.press('Tab');
  await tip(page).waitFor();
  assert.equal(await page.evaluate(() => document.activeElement.getAttribute('aria-describedby')), 'tip');
  await heads(page);
  await page.keyboard.press('Tab');
  assert.ok(await tip(page).isHidden());
  assert.equal(await edits(), 0);

  await page.click('#tab-criteria');
  await page.locator('#panel-criteria .row-name').filter({ hasText: 'Lower back' }).click();
  await tip(page).waitFor();
  assert.match(await tip(page).innerText(), /lowest joint of the back/);
  assert.deepEqual(errors, []);
  await context.close();
});

test('a finger brings a tip by the name and moves the slider without one', { timeout: 120_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url, { hasTouch: true });
  await settled(page);
  await page.click('#tab-adjust');
  await page.locator('.row-name').first().tap();
  await tip(page).waitFor();
  await heads(page);
  await page.locator('.row-name').first().tap();
  await tip(page).waitFor({ state: 'hidden' }); // a finger's click comes after its touch
  await slider(page, 'lean_deg').tap();
  await page.waitForFunction(() => Object.keys(window.shigusa.document.edits).length === 1);
  assert.ok(await tip(page).isHidden());
  assert.deepEqual(errors, []);
  await context.close();
});

test('every slider has a sentence in both languages', { timeout: 180_000 }, async () => {
  const { page, context } = await openStudio(browser, site.url);
  await settled(page);
  const without = () => page.evaluate(() => {
    const { facts, document: d, tip: say } = window.shigusa;
    const missing = facts.criteria.filter(({ name }) => say('criterion', name) === '').map(({ name }) => name);
    return [...missing, ...d.result.candidates[0].parameters.filter(({ name }) => say('parameter', name) === '').map(({ name }) => name)];
  });
  const goals = [{ effector: 'right_hand', position_m: [-0.2, 0.9, 0.5] }];
  for (const task of [{ goals }, { goals, preset: 'human' }, { goals, preset: 'layers' }]) {
    await ask(page, { ...task, evaluations: 60 });
    for (const language of ['ja', 'en']) {
      await page.locator('.topbar select').last().selectOption(language);
      await page.waitForFunction((code) => document.documentElement.lang === code, language);
      assert.deepEqual(await without(), [], `${language}, ${task.preset}`);
    }
  }
  await context.close();
});
