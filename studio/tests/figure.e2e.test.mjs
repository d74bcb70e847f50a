// SPDX-License-Identifier: MIT
// The built-in mannequin: made the same each time, as tall as the body it is drawn for, with hands that open and close.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { inflateRawSync } from 'node:zlib';
import { makeFile } from '../../research/mannequin/make.mjs';
import { parseGlb, valuesOf } from './glb.mjs';
import { ask, drawn, drop, openStudio, settled, take, visit } from './support.mjs';

const { site, browser } = await visit();
const { page, errors } = await openStudio(browser, site.url, { seen: true });
await settled(page);

const kReach = { goals: [{ effector: 'right_hand', position_m: [-0.2, 1, 0.35] }] };

test('the mannequin is what its script makes, and small', { timeout: 240_000 }, () => {
  const kept = readFileSync(new URL('../../data/mannequin.bin', import.meta.url));
  assert.ok(kept.length <= 64_000, `${kept.length} bytes`);
  assert.ok(makeFile().equals(inflateRawSync(kept)), 'research/mannequin/make.mjs makes another file');
});

const figureAt = async (share) => {
  await page.locator('.scrub').evaluate((range, value) => {
    range.value = String(value * 1000);
    range.dispatchEvent(new Event('input'));
  }, share);
  const duration = await page.evaluate(() => window.shigusa.document.result.summary.candidates[window.shigusa.chosen].duration_s);
  await page.waitForFunction((time) => Math.abs(window.shigusa.time - time) < 0.01, share * duration);
  await drawn(page);
  return page.evaluate(() => window.shigusa.figure());
};

async function open(character) {
  await page.evaluate(() => (window.before = window.shigusa.document.character.id));
  await drop(page, 'task.json', Buffer.from(JSON.stringify({ ...kReach, character })));
  await page.waitForFunction(() => window.shigusa.document.character.id !== window.before, undefined, { timeout: 60_000 });
  await settled(page);
}

test('the mannequin stands on the floor as tall as its body, whatever sex and mass', { timeout: 240_000 }, async () => {
  for (const character of [
    { source: 'human', sex: 'female', stature_m: 1.5 }, { source: 'human', stature_m: 1.95, mass_kg: 130 }, { source: 'full_body' }, { source: 'half_body' },
  ]) {
    await open(character);
    const stature = await page.evaluate(() => window.shigusa.document.character.description.stature_m);
    const { low, high, closed } = await figureAt(0);
    const name = JSON.stringify(character);
    assert.ok(Math.abs(low) < 0.006 * stature, `${name}: its soles are at ${low}`);
    assert.ok(Math.abs(high - stature) < 0.015 * stature, `${name}: its head ends at ${high}`);
    assert.deepEqual(closed, { left: 0, right: 0 }, `${name}: at rest its hands are relaxed`);
  }
  assert.deepEqual(errors, []);
});

test('the hand that reaches opens on the way and closes at the end', { timeout: 120_000 }, async () => {
  await ask(page, kReach);
  const way = await figureAt(0.6);
  assert.ok(way.closed.right < -0.5, `open by ${way.closed.right}`);
  assert.equal(way.closed.left, 0);
  const end = await figureAt(1);
  assert.ok(end.closed.right > 0.3, `closed by ${end.closed.right}`);
  assert.equal(end.closed.left, 0);
  assert.deepEqual(errors, []);
});

test('a GLB of a built-in body has the skin with its paint, and fingers that move', { timeout: 120_000 }, async () => {
  await ask(page, kReach);
  const glb = parseGlb(await take(page, 'glb'));
  const { json } = glb;
  const [primitive] = json.meshes.flatMap(({ primitives }) => primitives);
  for (const attribute of ['POSITION', 'NORMAL', 'TEXCOORD_0', 'JOINTS_0', 'WEIGHTS_0']) assert.ok(attribute in primitive.attributes, attribute);
  assert.ok(json.materials[primitive.material].pbrMetallicRoughness.baseColorTexture);
  const turned = new Set(json.animations[0].channels.filter(({ target }) => target.path === 'rotation').map(({ target }) => json.nodes[target.node].name));
  for (const name of ['right_index_proximal', 'left_thumb_distal', 'right_lower_arm_half', 'right_hand']) assert.ok(turned.has(name), name);
  const places = valuesOf(glb, primitive.attributes.POSITION);
  const corners = valuesOf(glb, primitive.indices).flat();
  let volume = 0;
  for (let t = 0; t < corners.length; t += 3) {
    const [p, q, r] = [0, 1, 2].map((k) => places[corners[t + k]]);
    volume += (p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) + p[2] * (q[0] * r[1] - q[1] * r[0])) / 6;
  }
  assert.ok(volume > 0.055 && volume < 0.085, `the skin holds ${volume} m³, and a person of 73 kg some 0.07`);
  for (const weights of valuesOf(glb, primitive.attributes.WEIGHTS_0)) assert.ok(Math.abs(weights.reduce((sum, one) => sum + one) - 1) < 1e-6);
  const [skin] = json.skins;
  assert.equal(new Set(skin.joints).size, skin.joints.length, 'each joint once');
  assert.deepEqual(errors, []);
});
