// SPDX-License-Identifier: MIT
// Ease and gaze lead: all motions by another timing, without a search.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { drop, openStudio, settled, slide, take, visit } from './support.mjs';

const { site, browser } = await visit();

/** How far the hand of the chosen motion is on its way at half its time. */
const halfWay = (page) => page.evaluate(() => {
  const { document: d, chosen } = window.shigusa;
  const { effectors } = (d.edits[chosen]?.generated.candidates[0] ?? d.result.candidates[chosen]).series;
  const at = (frame) => Array.from(effectors.values.subarray(frame * effectors.columns, frame * effectors.columns + 3));
  const far = (frame) => Math.hypot(...at(frame).map((value, k) => value - at(0)[k]));
  return far(Math.floor(effectors.frames / 2)) / far(effectors.frames - 1);
});

test('ease and gaze lead change all motions, are kept in files, and are undone', { timeout: 180_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url);
  await settled(page);
  const before = await page.evaluate(() => ({ words: [...window.shigusa.words] }));
  const plain = await halfWay(page);
  await page.click('#tab-adjust');
  await slide(page, '[data-parameter="ease"]', 1);
  await page.waitForFunction(() => window.shigusa.task.ease === 0.8);
  await settled(page);
  assert.ok((await halfWay(page)) > plain + 0.1);
  await slide(page, '[data-parameter="gaze_lead"]', 0);
  await page.waitForFunction(() => window.shigusa.task.gaze_lead === -0.45);
  await settled(page);
  const after = await page.evaluate(() => ({
    words: window.shigusa.words, evaluations: window.shigusa.document.result.summary.evaluations, error: window.shigusa.document.result.summary.candidates[0].reached[0].error_mm,
  }));
  assert.deepEqual(after.words, before.words, 'the same postures');
  assert.equal(after.evaluations, 0, 'nothing was searched');
  assert.ok(after.error < 1);

  const task = JSON.parse(new TextDecoder().decode(await take(page, 'task')));
  assert.deepEqual([task.ease, task.gaze_lead], [0.8, -0.45]);
  for (let k = 0; k < 2; ++k) await page.keyboard.press('Control+z');
  await page.waitForFunction(() => window.shigusa.task.ease === undefined);
  await settled(page);
  assert.ok(Math.abs((await halfWay(page)) - plain) < 1e-9);
  await drop(page, 'task.json', JSON.stringify(task));
  await page.waitForFunction(() => window.shigusa.task.ease === 0.8);
  await settled(page);
  assert.ok((await halfWay(page)) > plain + 0.1);
  assert.deepEqual(errors, []);
  await context.close();
});
