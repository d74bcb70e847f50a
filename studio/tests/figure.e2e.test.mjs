// SPDX-License-Identifier: MIT
// The built-in mannequin: made the same each time, as tall as the body it is drawn for, with hands that open and close.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { makeFile } from '../figure/make.mjs';
import { parseGlb } from './glb.mjs';
import { drop, openStudio, settled, take, visit } from './support.mjs';

const { site, browser } = await visit();

test('the mannequin is what its script makes, and small', { timeout: 240_000 }, () => {
  const kept = readFileSync(new URL('../src/view/mannequin.bin', import.meta.url));
  assert.ok(kept.length <= 400_000, `${kept.length} bytes`);
  assert.ok(makeFile().equals(kept), 'npm run figure makes another file');
});

const figureAt = async (page, share) => {
  await page.locator('.scrub').evaluate((range, value) => {
    range.value = String(value * 1000);
    range.dispatchEvent(new Event('input'));
  }, share);
  const duration = await page.evaluate(() => window.shigusa.document.result.summary.candidates[window.shigusa.chosen].duration_s);
  await page.waitForFunction((time) => Math.abs(window.shigusa.time - time) < 0.01, share * duration);
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  return page.evaluate(() => window.shigusa.figure());
};

async function open(page, character) {
  await page.evaluate(() => (window.before = window.shigusa.document.character.id));
  await drop(page, 'task.json', Buffer.from(JSON.stringify({ character, goals: [{ effector: 'right_hand', position_m: [-0.2, 1, 0.35] }] })));
  await page.waitForFunction(() => window.shigusa.document.character.id !== window.before, undefined, { timeout: 60_000 });
  await settled(page);
}

test('the mannequin stands on the floor as tall as its body, whatever sex and mass', { timeout: 240_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url);
  await settled(page);
  for (const character of [
    { source: 'human', sex: 'female', stature_m: 1.5 }, { source: 'human', stature_m: 1.95, mass_kg: 130 }, { source: 'full_body' }, { source: 'half_body' },
  ]) {
    await open(page, character);
    const stature = await page.evaluate(() => window.shigusa.document.character.description.stature_m);
    const { low, high, closed } = await figureAt(page, 0);
    const name = JSON.stringify(character);
    assert.ok(Math.abs(low) < 0.006 * stature, `${name}: its soles are at ${low}`);
    assert.ok(Math.abs(high - stature) < 0.015 * stature, `${name}: its head ends at ${high}`);
    assert.deepEqual(closed, { left: 0, right: 0 }, `${name}: at rest its hands are relaxed`);
  }
  assert.deepEqual(errors, []);
  await context.close();
});

test('the hand that reaches opens on the way and closes at the end', { timeout: 120_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url);
  await settled(page);
  const way = await figureAt(page, 0.6);
  assert.ok(way.closed.right < -0.5, `open by ${way.closed.right}`);
  assert.equal(way.closed.left, 0);
  const end = await figureAt(page, 1);
  assert.ok(end.closed.right > 0.3, `closed by ${end.closed.right}`);
  assert.equal(end.closed.left, 0);
  assert.deepEqual(errors, []);
  await context.close();
});

test('a GLB of a built-in body has the skin with its paint, and fingers that move', { timeout: 120_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url);
  await settled(page);
  const { json } = parseGlb(await take(page, 'glb'));
  const [primitive] = json.meshes.flatMap(({ primitives }) => primitives);
  for (const attribute of ['POSITION', 'NORMAL', 'TEXCOORD_0', 'JOINTS_0', 'WEIGHTS_0']) assert.ok(attribute in primitive.attributes, attribute);
  assert.ok(json.materials[primitive.material].pbrMetallicRoughness.baseColorTexture);
  const turned = new Set(json.animations[0].channels.filter(({ target }) => target.path === 'rotation').map(({ target }) => json.nodes[target.node].name));
  for (const name of ['right_index_proximal', 'left_thumb_distal', 'right_lower_arm_half', 'right_hand']) assert.ok(turned.has(name), name);
  const [skin] = json.skins;
  assert.equal(new Set(skin.joints).size, skin.joints.length, 'each joint once');
  assert.deepEqual(errors, []);
  await context.close();
});
