// SPDX-License-Identifier: MIT
// Robots from URDF and MJCF files: drawn as rods, kept, switched, and taken away as CSV in their own joints.
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { seriousFindings } from './axe.mjs';
import { saved } from './kept.mjs';
import { drop, openStudio, openTab, settled, state, take, visit } from './support.mjs';

const { site, browser } = await visit();
const { page, errors } = await openStudio(browser, site.url, { seen: true });
await settled(page);
const fuzz = fileURLToPath(new URL('../../tests/fuzz/', import.meta.url));
const shared = process.env.SHIGUSA_CHARACTERS ?? fileURLToPath(new URL('../../../shared/characters/', import.meta.url));
const robots = ['unitree_ros__g1_29dof.urdf', 'icub-models__model.urdf', 'mujoco__humanoid.xml'].map((name) => shared + name).filter(existsSync);
const small = readFileSync(`${fuzz}urdf_corpus/small_robot.urdf`);
const maker = readFileSync(`${fuzz}mjcf_corpus/maker.xml`);

async function dropped(name, bytes) {
  await drop(page, name, bytes);
  await page.waitForFunction((file) => window.shigusa.document.character.spec.source === file, name, { timeout: 60_000 });
  await settled(page);
}

/** The hand ends where its goal is, and is drawn there. */
async function reaches() {
  await page.waitForFunction(() => window.shigusa.time === window.shigusa.document.result.summary.candidates[window.shigusa.chosen].duration_s);
  await page.waitForFunction(() => {
    const [hand, drawn] = [window.shigusa.hand(), window.shigusa.drawn('right_hand')];
    return Math.hypot(...hand.map((value, k) => value - drawn[k])) < 2e-3;
  });
  const [hand, { goals }] = [await page.evaluate(() => window.shigusa.hand()), await state(page)];
  assert.ok(Math.hypot(...hand.map((value, k) => value - goals[0].position_m[k])) < 2e-3, `${hand} is not ${goals[0].position_m}`);
}

test('a robot is a character as others: drawn, kept, switched, and its joints leave as CSV', { timeout: 240_000 }, async () => {
  await dropped('small_robot.urdf', small);
  await reaches();
  const csv = String(await take(page, 'csv')).split('\n')[0].split(',');
  for (const column of ['root.x [m]', 'root.qw', 'left_knee [rad]', 'right_elbow [rad]']) {
    assert.ok(csv.includes(column), `${column} is not among ${csv}`);
  }
  assert.equal(String((await take(page, 'glb')).subarray(0, 4)), 'glTF', 'its rods leave with the motion');
  const left = await state(page);

  await dropped('maker.xml', maker);
  await reaches();
  await openTab(page, 'body');
  const rows = page.locator('.characters li');
  assert.equal(await rows.count(), 3);
  assert.match(await rows.nth(1).innerText(), /small_robot\.urdf\s+1\d\d cm, \d+ kg/);
  await page.waitForFunction(() => /drawn as rods/.test(document.querySelectorAll('.characters li')[2].textContent));
  assert.deepEqual(await seriousFindings(page, '.side'), []);
  await rows.nth(1).locator('.pick-character').click();
  await page.waitForFunction(() => window.shigusa.document.character.spec.source === 'small_robot.urdf');
  await settled(page);
  const back = await state(page);
  assert.deepEqual([back.words, back.chosen, back.goals], [left.words, left.chosen, left.goals], 'as it was left');

  await saved(page);
  await page.reload();
  await settled(page);
  assert.equal((await state(page)).character, 'small_robot.urdf', 'it is kept');
  await reaches();
  assert.deepEqual(errors, []);
});

test('a file that is no robot is told of by its line, and harms nothing', { timeout: 120_000 }, async () => {
  const cases = [
    ['bomb.urdf', '<!DOCTYPE r [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;&a;">]>\n<robot name="&b;"/>', /line 1 of bomb\.urdf/],
    ['deep.urdf', '<a>'.repeat(100_000), /nested deeper than 64/],
    ['large.xml', ' '.repeat(2 ** 22 + 1), /large\.xml/],
    ['cut.urdf', small.subarray(0, 4000), /cut\.urdf/],
    ['circle.urdf', readFileSync(`${fuzz}urdf_corpus/circle.urdf`), /hangs in a circle/],
  ];
  const { character } = await state(page);
  for (const [name, bytes, told] of cases) {
    await page.evaluate(() => document.querySelector('.message .icon-button')?.click());
    await drop(page, name, bytes);
    await page.waitForFunction(() => window.shigusa.state.notice !== null && !window.shigusa.state.opening, undefined, { timeout: 30_000 });
    assert.match(await page.locator('.message').innerText(), told);
    assert.equal((await state(page)).character, character, name);
  }
  assert.deepEqual(errors, []);
});

test('robots of others reach', { skip: robots.length === 0 && 'no robots here', timeout: 240_000 }, async () => {
  for (const path of robots) {
    await dropped(path.split('/').pop(), readFileSync(path));
    assert.notEqual((await state(page)).status, 'unreachable', path);
    await reaches();
  }
  assert.deepEqual(errors, []);
});
