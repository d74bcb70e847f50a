// SPDX-License-Identifier: MIT
// What the page gives can be given back to it: each is read again, or a sentence says that it cannot be.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';
import { parseGlb } from './glb.mjs';
import { drop, openStudio, settled, visit } from './support.mjs';

const { site, browser } = await visit();

/** All that the tab Save offers now: the name and the bytes of each file, by format. */
async function takeAll(page) {
  await page.click('#tab-take');
  const buttons = page.locator('[data-format]:not([data-format="link"]):not(:disabled)');
  const formats = await buttons.evaluateAll((all) => all.map((button) => button.dataset.format));
  const files = new Map();
  for (const format of formats) {
    const [download] = await Promise.all([page.waitForEvent('download'), page.click(`[data-format="${format}"]`)]);
    files.set(format, { name: download.suggestedFilename(), bytes: await readFile(await download.path()) });
  }
  return files;
}

/** What came of a file that was let go over the page. */
async function dropBack(page, { name, bytes }) {
  await page.evaluate(() => {
    document.querySelector('.message .icon-button')?.click();
    window.seen = window.shigusa.document;
  });
  await drop(page, name, bytes);
  await page.waitForFunction(() => !window.shigusa.state.opening && (window.shigusa.document !== window.seen || window.shigusa.state.notice !== null), undefined, { timeout: 60_000 });
  await settled(page);
  return page.evaluate(() => {
    const { document: d, state } = window.shigusa;
    return {
      changed: d !== window.seen, notice: state.notice, source: d.character.spec.source, status: d.result.summary.status, map: d.character.description.humanoid,
      stature: d.character.description.stature_m,
    };
  });
}

test('every file that the page offers of a built-in body is read back or told of', { timeout: 300_000 }, async (t) => {
  const { page, context, errors } = await openStudio(browser, site.url);
  await settled(page);
  const files = await takeAll(page);
  assert.deepEqual([...files.keys()].filter((format) => !['bvh', 'csv', 'svg', 'png', 'glb', 'result', 'task'].includes(format)), []);
  const characters = await page.evaluate(() => window.shigusa.facts.formats.filter(({ person }) => person).map(({ name }) => name));
  const stature = await page.evaluate(() => window.shigusa.document.character.description.stature_m);
  for (const [format, file] of files) {
    await t.test(format, async () => {
      const after = await dropBack(page, file);
      if (characters.includes(format)) {
        assert.equal(after.notice, null);
        assert.equal(after.source, file.name);
        assert.equal(after.status, 'reached');
        for (const bone of ['hips', 'left_lower_leg', 'right_foot', 'right_lower_arm', 'left_hand', 'head']) assert.equal(after.map[bone], bone);
        assert.ok(Math.abs(after.stature - stature) < 0.01 * stature, `${after.stature} m is not ${stature} m`);
      } else if (format === 'result' || format === 'task') {
        assert.ok(after.changed);
        assert.equal(after.notice, null);
        assert.equal(after.status, 'reached');
      } else {
        assert.ok(!after.changed);
        assert.equal(after.notice?.key, 'unknownFile');
        assert.ok((await page.locator('.message').innerText()).includes(file.name));
      }
    });
  }
  assert.deepEqual(errors, []);
  await context.close();
});

test('the motion of a GLB that is dropped back is still in the next one', { timeout: 120_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url);
  await settled(page);
  const first = (await takeAll(page)).get('glb');
  await dropBack(page, first);
  const again = (await takeAll(page)).get('glb');
  const [old, now] = [first, again].map(({ bytes }) => parseGlb(bytes).json.animations);
  assert.equal(now.length, old.length + 1);
  assert.deepEqual(now.slice(0, old.length), old);
  assert.deepEqual(errors, []);
  await context.close();
});
