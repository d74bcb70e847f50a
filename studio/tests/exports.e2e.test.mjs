// SPDX-License-Identifier: MIT
// What the page gives can be given back to it: each is read again, or a sentence says that it cannot be.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';
import { parseGlb, translationsOf } from './glb.mjs';
import { drop, openStudio, openTab, settled, take, visit } from './support.mjs';

const { site, browser } = await visit();

/** All that the tab Save offers now: the name and the bytes of each file, by format. */
async function takeAll(page) {
  await openTab(page, 'take');
  await page.locator('[data-film="size"]').selectOption('640 × 360');
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
  const { page, context, errors } = await openStudio(browser, site.url, { seen: true });
  await settled(page);
  const files = await takeAll(page);
  assert.deepEqual([...files.keys()].filter((format) => !['bvh', 'csv', 'npz', 'svg', 'png', 'glb', 'picture', 'film', 'result', 'task'].includes(format)), []);
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

test('frames a second, names of joints and clips, motions in place and all in one file are as chosen', { timeout: 180_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url);
  await settled(page);
  const spread = (glb, hips, animation) => {
    const places = translationsOf(glb, hips, animation);
    return [0, 1, 2].map((k) => Math.max(...places.map((place) => place[k])) - Math.min(...places.map((place) => place[k])));
  };
  const plain = parseGlb(await take(page, 'glb'));
  assert.deepEqual(plain.json.animations.map(({ name }) => name), ['shigusa']);
  assert.ok(spread(plain, 'hips')[2] > 0.01, 'the hips travel: else this shows nothing');

  await page.getByLabel('Frames a second', { exact: true }).selectOption('24');
  await page.locator('[data-key="clip"]').fill('Pick up');
  await page.locator('[data-key="clip"]').press('Enter');
  await page.locator('[data-key="joint names"]').selectOption('unreal');
  await page.locator('[data-key="inPlace"]').check();
  await page.locator('[data-key="together"]').check();
  const bytes = await take(page, 'glb');
  const glb = parseGlb(bytes);
  const count = await page.evaluate(() => window.shigusa.document.result.candidates.length);
  assert.ok(count > 1);
  assert.deepEqual(glb.json.animations.map(({ name }) => name), Array.from({ length: count }, (_, k) => `Pick up ${k + 1}`));
  const { duration_s } = await page.evaluate(() => window.shigusa.document.result.summary.candidates[0]);
  assert.equal(glb.json.accessors[glb.json.animations[0].samplers[0].input].count, Math.ceil(duration_s * 24 - 1e-6) + 1);
  const names = new Set(glb.json.nodes.map(({ name }) => name));
  for (const name of ['pelvis', 'spine_03', 'upperarm_l', 'calf_r', 'ball_l', 'head_end']) assert.ok(names.has(name), name);
  for (let k = 0; k < count; ++k) {
    const [x, y, z] = spread(glb, 'pelvis', k);
    assert.ok(x < 1e-7 && z < 1e-7 && y > 0.001, `${x} ${y} ${z}`);
  }

  const bvh = new TextDecoder().decode(await take(page, 'bvh'));
  assert.match(bvh, /Frame Time: 0\.041666666666666664/);
  assert.match(bvh, /ROOT pelvis/);
  assert.match(bvh, /JOINT upperarm_l/);
  const rows = bvh.slice(bvh.indexOf('Frame Time')).trim().split('\n').slice(1).map((row) => row.trim().split(/\s+/).map(Number));
  for (const row of rows) assert.deepEqual([row[0], row[2]], [rows[0][0], rows[0][2]]);

  // read by those names
  const after = await dropBack(page, { name: 'unreal.glb', bytes });
  assert.equal(after.source, 'unreal.glb');
  assert.equal(after.map.left_upper_arm, 'upperarm_l');
  // whose own names are kept
  await openTab(page, 'take');
  assert.ok(await page.locator('[data-key="joint names"]').isDisabled());
  const own = parseGlb(await take(page, 'glb'));
  const more = await page.evaluate(() => window.shigusa.document.result.candidates.length);
  assert.equal(own.json.animations.length, count + more, 'those that it had, and all motions');
  assert.deepEqual(own.json.animations.slice(more), glb.json.animations, 'as they were');
  assert.deepEqual(errors, []);
  await context.close();
});
