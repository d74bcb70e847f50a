// SPDX-License-Identifier: MIT
// Panels in both languages: names that stand apart, and what is told where loads and things are set.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { seriousFindings } from './axe.mjs';
import { linkTo, openStudio, openTab, settled, visit } from './support.mjs';

const { site, browser } = await visit();

const box = { position_m: [0, 0.4, 0.9], size_m: [0.3, 0.3, 0.3] };
const task = { evaluations: 64, goals: [{ effector: 'right_hand', position_m: [-0.25, 1.1, 0.4], load_kg: 2 }, { effector: 'left_hand', position_m: [0.25, 1.1, 0.4] }], obstacles: [box] };

/** How far apart the words of neighbours are, px. */
const gaps = (page, selector) => page.evaluate((all) => {
  const boxes = [...document.querySelectorAll(all)].map((element) => {
    const range = document.createRange();
    range.selectNodeContents(element);
    return range.getBoundingClientRect();
  });
  return boxes.slice(1).map(({ left }, k) => left - boxes[k].right);
}, selector);

const said = {
  en: { load: /does not collide/, things: /The body keeps clear of them; loads in its hands do not/ },
  ja: { load: /衝突は、まだ扱いません/, things: /荷物はまだ避けません/ },
};

test('tabs, loads and things, what files are made by, in both languages', { timeout: 120_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, linkTo(site, task));
  await settled(page);
  for (const [language, words] of Object.entries(said)) {
    await page.locator('.topbar select').last().selectOption(language);
    await page.waitForFunction((code) => document.documentElement.lang === code, language);
    for (const tab of ['goals', 'body', 'take']) {
      await openTab(page, tab);
      for (const gap of await gaps(page, '[role="tab"]')) assert.ok(gap >= 8, `${language}, ${tab}: ${gap} px between tabs`);
    }
    const under = await page.evaluate(() => {
      const of = (selector) => document.querySelector(`#panel-take ${selector}`).getBoundingClientRect();
      return of('.take + .fields select').top - of('.take').bottom;
    });
    assert.ok(under >= 8, `${under} px between formats and frames a second`);
    await openTab(page, 'goals');
    const goal = (hand) => page.locator(`.goal:has([data-key="${hand} load"]) .quiet`);
    assert.match(await goal('right_hand').innerText(), words.load);
    assert.ok(!(await goal('left_hand').isVisible()), 'nothing is carried there');
    assert.match(await page.locator('.things .quiet').first().innerText(), words.things);
    assert.deepEqual(await seriousFindings(page), []);
  }
  await page.click('[data-key="thing 0 remove"]');
  await settled(page);
  assert.ok(!(await page.locator('.things .quiet').first().isVisible()));
  assert.deepEqual(errors, []);
  await context.close();
});
