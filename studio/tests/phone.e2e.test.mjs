// SPDX-License-Identifier: MIT
// The page on a phone, upright and on its side: all of it fits, fingers hit what they aim at, and the figure is seen while a
// slider moves.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { answered, openStudio, settled, visit } from './support.mjs';

const { site, browser } = await visit();

const kLeast = 40; // px, of what a finger aims at

/** How far the page goes beyond the screen, px. */
const beyond = (page) => page.evaluate(() => {
  const { scrollWidth, scrollHeight, clientWidth, clientHeight } = document.documentElement;
  return [scrollWidth - clientWidth, scrollHeight - clientHeight];
});

/** What is seen and too small for a finger; the link that skips is for keys, and seen once these get to it. */
const small = (page, least) => page.evaluate((px) => [...document.querySelectorAll('button:not(.link, .skip:not(:focus)), select, input:not([type="checkbox"], [hidden]), summary')]
  .filter((element) => element.checkVisibility() && element.getBoundingClientRect().height < px - 0.5)
  .map((element) => `${element.outerHTML.slice(0, 90)}: ${element.getBoundingClientRect().height}`), least);

/** How much of the view can be seen, px: its box within the screen, where nothing but the view is at its middle. */
const seen = (page) => page.evaluate(() => {
  const { left, right, top, bottom } = document.querySelector('canvas.view').getBoundingClientRect();
  const at = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
  const height = Math.min(bottom, innerHeight) - Math.max(top, 0);
  return { width: Math.min(right, innerWidth) - Math.max(left, 0), height: at?.matches('canvas.view') ? height : 0 };
});

async function touch(page, context, selector, along) {
  const session = await context.newCDPSession(page);
  const slider = page.locator(selector);
  await slider.scrollIntoViewIfNeeded();
  const { x, y, width, height } = await slider.boundingBox();
  const middle = y + height / 2;
  const points = (share) => [{ x: x + width * share, y: middle }];
  const from = await slider.evaluate((range) => Number(range.value) / Number(range.max));
  await session.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: points(from) });
  for (let k = 1; k <= 4; ++k) await session.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: points(from + (along * k) / 4) });
  return () => session.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
}

for (const [width, height, least] of [[390, 844, 300], [844, 390, 200]]) {
  test(`${width} × ${height}: nothing is cut off, and the figure is seen while a finger moves a slider`, { timeout: 240_000 }, async () => {
    const { page, context, errors } = await openStudio(browser, site.url, { viewport: { width, height }, hasTouch: true, isMobile: true, cards: true });
    await settled(page);
    assert.deepEqual(await beyond(page), [0, 0], 'with the cards to begin with');
    assert.ok((await seen(page)).height >= 0.25 * height);
    await page.locator('.start > .icon-button').tap();
    if (await page.locator('.hint').isVisible()) await page.locator('.hint .icon-button').tap();
    for (const tab of ['goals', 'criteria', 'body', 'plots', 'take', 'adjust']) {
      await page.locator(`#tab-${tab}`).tap();
      await page.waitForFunction((name) => window.shigusa.state.tab === name && document.querySelector(`#panel-${name} > *`), tab); // panels may come late
      assert.deepEqual(await beyond(page), [0, 0], tab);
      assert.deepEqual(await small(page, kLeast), [], tab);
    }
    await page.waitForFunction((px) => document.querySelector('canvas.view').clientHeight >= px, least);
    const before = await page.evaluate(() => window.shigusa.document.result.candidates[0].parameters.find(({ name }) => name === 'squat_deg').value);
    const release = await touch(page, context, '[data-parameter="squat_deg"]', 0.3);
    await page.waitForFunction(() => Object.keys(window.shigusa.document.edits).length === 1);
    const { width: wide, height: tall } = await seen(page);
    assert.ok(tall >= least && wide >= Math.min(width, 390) * 0.9, `${wide} × ${tall} of the view is seen`);
    await release();
    await answered(page); // for the last place of the finger
    const after = await page.evaluate(() => Number(window.shigusa.document.edits[window.shigusa.chosen].assignments.squat_deg));
    assert.ok(after > before + 15, `${before}° became ${after}°`);
    assert.deepEqual(await beyond(page), [0, 0]);
    assert.deepEqual(errors, []);
    await context.close();
  });
}
