// SPDX-License-Identifier: MIT
// Ways to work: cancel, undo, keys alone, Japanese, screen readers; and what 200 searches leave behind.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { seriousFindings } from './axe.mjs';
import { drag, drawn, openStudio, openTab, settled, slide, state, visit } from './support.mjs';

const { site, browser } = await visit();

test('a search can be cancelled, and the page goes on', { timeout: 120_000 }, async () => {
  const task = { goals: [{ effector: 'right_hand', position_m: [0.2, 0.6, 0.5] }], character: 'human', evaluations: 1_000_000 };
  const link = `${site.url}#task=${Buffer.from(JSON.stringify(task)).toString('base64url')}`;
  const { page, context, errors } = await openStudio(browser, link);
  await page.waitForFunction(() => window.shigusa?.state.search?.fraction > 0, undefined, { timeout: 30_000 });
  await page.locator('.search button').click();
  assert.equal(await page.evaluate(() => window.shigusa.state.search), null);
  assert.match(await page.locator('.message').innerText(), /stopped/);
  await page.locator('select').filter({ hasText: 'thorough' }).selectOption('effortQuick');
  await settled(page);
  assert.equal((await state(page)).status, 'reached');
  assert.deepEqual(errors, []);
  await context.close();
});

test('a number that is typed counts, and so does the box that is clicked next; a goal out of reach is told with what is left', { timeout: 120_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url);
  await settled(page);
  await page.locator('[data-key="left_hand has"]').click();
  await page.locator('[data-key="left_hand up"]').fill('120');
  await page.locator('[data-key="right_hand up"]').click();
  await page.locator('[data-key="right_hand up"]').fill('9900');
  await page.locator('[data-key="head has"]').click();
  await page.waitForFunction(() => window.shigusa.document.goals.length === 3);
  await page.locator('[data-key="right_hand has"]').click();
  await page.waitForFunction(() => window.shigusa.document.goals.length === 2);
  await settled(page);
  const { goals } = await state(page);
  assert.deepEqual(goals.map((goal) => goal.effector), ['left_hand', 'head']);
  assert.equal(goals[0].position_m[1], 1.2);
  await page.locator('[data-key="head up"]').fill('9900');
  await page.keyboard.press('Enter');
  assert.equal((await state(page)).goals[1].position_m[1], 3, 'no farther than a drag goes');
  await settled(page);
  assert.equal((await state(page)).status, 'unreachable');
  assert.match(await page.locator('.message').innerText(), /Out of reach: .* \d+\.\d cm short/);
  assert.match(await page.locator('.goal .bad').innerText(), /cm short/);
  assert.deepEqual(errors, []);
  await context.close();
});

test('keys alone: move the goal, choose, play, change a parameter, save', { timeout: 120_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url);
  await settled(page);
  const before = await state(page);
  const focused = () => page.evaluate(() => document.activeElement?.className ?? '');
  for (let k = 0; k < 60 && (await focused()) !== 'view'; ++k) await page.keyboard.press('Tab');
  assert.equal(await focused(), 'view', 'the view is reached by Tab');
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('Shift+ArrowUp');
  await settled(page); // the keys' drag ends a while after the last one
  const moved = (await state(page)).goals[0].position_m[1] - before.goals[0].position_m[1];
  assert.ok(Math.abs(moved - 0.11) < 1e-9, `moved by ${moved}`);
  await page.keyboard.press('Digit2');
  for (const playing of [true, false]) {
    await page.keyboard.press('Space');
    assert.equal((await state(page)).playing, playing);
  }
  const tab = () => page.evaluate(() => document.activeElement?.id ?? '');
  for (let k = 0; k < 30 && !(await tab()).startsWith('tab-'); ++k) await page.keyboard.press('Tab');
  await page.keyboard.press('ArrowRight');
  assert.equal(await tab(), 'tab-adjust');
  const parameter = () => page.evaluate(() => document.activeElement?.dataset.parameter ?? '');
  for (let k = 0; k < 20 && (await parameter()) === ''; ++k) await page.keyboard.press('Tab');
  for (let k = 0; k < 5; ++k) await page.keyboard.press('ArrowRight');
  await page.waitForFunction(() => Object.keys(window.shigusa.document.edits).length === 1);
  await page.keyboard.press('m');
  await page.waitForFunction(() => window.shigusa.document.goals[0].effector === 'left_hand');
  await page.keyboard.press('?');
  assert.ok(await page.locator('dialog').isVisible());
  await page.keyboard.press('Escape');
  await page.locator('dialog').waitFor({ state: 'hidden' });
  assert.deepEqual(errors, []);
  await context.close();
});

test('Japanese: nothing is left in English; what nobody has translated is in the engine’s words', { timeout: 120_000 }, async (t) => {
  const { page, context, errors } = await openStudio(browser, site.url, { locale: 'ja-JP' });
  await settled(page);
  assert.equal(await page.evaluate(() => document.documentElement.lang), 'ja');
  for (const tab of ['goals', 'adjust', 'criteria', 'body', 'plots', 'take']) {
    await openTab(page, tab);
    const text = await page.locator(`#panel-${tab}`).innerText();
    const english = text.match(/[A-Za-z]{4,}/g)?.filter((word) => !['JSON', 'VRMA', 'human', 'Mixamo', 'Unreal', 'HumanIK', 'URDF', 'MJCF', 'WebM', 'Chrome', 'Edge'].includes(word)) ?? [];
    assert.deepEqual(english, [], tab);
  }
  const words = await page.locator('.words').allInnerTexts();
  assert.ok(words.every((word) => !/[a-z]{3,}/.test(word)), words.join(' | '));
  await page.locator('.topbar select').last().selectOption('en');
  await page.waitForFunction(() => document.documentElement.lang === 'en');
  assert.match(await page.locator('.gallery h2').innerText(), /Motions/);

  const { untranslated, facts } = await page.evaluate(async () => ({
    untranslated: { en: await window.shigusa.untranslated('en'), ja: await window.shigusa.untranslated('ja') }, facts: window.shigusa.facts,
  }));
  for (const [language, lacking] of Object.entries(untranslated)) t.diagnostic(`${language} lacks: ${lacking.join(', ') || 'nothing'}`);
  await page.click('#tab-criteria');
  const names = await page.locator('#panel-criteria .row-name').allInnerTexts();
  assert.equal(names.length, facts.criteria.length);
  await openTab(page, 'take');
  await page.locator('[data-format]').first().waitFor(); // the panel comes when it is asked for
  for (const { name } of facts.formats.filter(({ written }) => written)) assert.equal(await page.locator(`[data-format="${name}"]`).count(), 1, name);
  assert.ok([...names, ...(await page.locator('#panel-take button').allInnerTexts())].every((text) => text !== ''));
  assert.deepEqual(errors, []);
  await context.close();
});

test('axe finds nothing serious, light and dark', { timeout: 180_000 }, async () => {
  const { page, context } = await openStudio(browser, site.url);
  await settled(page);
  for (const tab of ['goals', 'adjust', 'criteria', 'body', 'plots', 'take']) {
    await openTab(page, tab);
    for (const colorScheme of ['light', 'dark']) {
      await page.emulateMedia({ colorScheme });
      await drawn(page);
      assert.deepEqual(await seriousFindings(page), [], `${tab}, ${colorScheme}`);
    }
  }
  await context.close();
});

test('searches leave nothing behind', { timeout: 1_800_000, skip: !process.env.SHIGUSA_LONG && 'long: set SHIGUSA_LONG' }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url, { viewport: { width: 920, height: 420 } });
  await settled(page);
  await page.locator('select').filter({ hasText: 'thorough' }).selectOption('effortQuick');
  await settled(page);
  const session = await context.newCDPSession(page);
  const heap = async () => {
    await session.send('HeapProfiler.collectGarbage');
    return (await session.send('Runtime.getHeapUsage')).usedSize / 1e6;
  };
  const field = page.locator('[data-key="right_hand up"]');
  const engine = () => page.evaluate(async () => Object.values(await window.shigusa.memory()).reduce((sum, bytes) => sum + bytes / 1e6, 0));
  let reference = 0;
  let taken = 0;
  for (let k = 1; k <= 200; ++k) {
    await field.evaluate((input, value) => {
      input.value = value;
      input.dispatchEvent(new Event('change'));
    }, String(60 + 0.1 * k));
    await settled(page);
    // undo holds sixty steps; from there on nothing may grow
    if (k === 80) [reference, taken] = [await heap(), await engine()];
    if (k % 40 === 0) console.log(`# ${k} searches: ${(await heap()).toFixed(1)} MB, the engine ${(await engine()).toFixed(1)} MB`);
  }
  const last = await heap();
  assert.ok(last < reference * 1.1 + 2, `${reference.toFixed(1)} MB after 80 searches, ${last.toFixed(1)} MB after 200`);
  assert.equal(await engine(), taken, 'the engine takes no more');
  assert.deepEqual(errors, []);
  await context.close();
});

test('drag to pose and slider to motion, as measured here', { timeout: 120_000 }, async () => {
  const { page, context } = await openStudio(browser, site.url);
  await settled(page);
  await drag(page, 'right_hand', -60, -80, { hold: 80, steps: 12, followed: true });
  await settled(page);
  await page.click('#tab-adjust');
  for (const share of [0.2, 0.4, 0.6, 0.3]) await slide(page, '[data-parameter="squat_deg"]', share);
  const { dragToPose, sliderToMotion } = await page.evaluate(() => window.shigusa.timings);
  const median = (list, key) => [...list].map((x) => x[key]).sort((a, b) => a - b)[Math.floor(list.length / 2)];
  console.log(`# engine: drag to pose ${median(dragToPose, 'engine_ms').toFixed(1)} ms, slider to motion ${median(sliderToMotion, 'engine_ms').toFixed(1)} ms (medians of ${dragToPose.length} and ${sliderToMotion.length}); with the way to the worker and this page's drawing ${median(dragToPose, 'total_ms').toFixed(0)} and ${median(sliderToMotion, 'total_ms').toFixed(0)} ms`);
  assert.ok(dragToPose.length > 0 && sliderToMotion.length > 0);
  await context.close();
});
