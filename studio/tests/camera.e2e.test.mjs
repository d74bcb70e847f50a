// SPDX-License-Identifier: MIT
// From where the scene is seen, through which lens, and beside which ruler.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { drag, drawn, openStudio, openTab, settled, state, visit } from './support.mjs';

const { site, browser } = await visit();

/** Fewer pixels are drawn sooner. */
const kSmall = { viewport: { width: 940, height: 520 } };
const { page, errors } = await openStudio(browser, site.url, { ...kSmall, seen: true });
await settled(page);

async function atStart() {
  await page.locator('.scrub').evaluate((range) => {
    range.value = '0';
    range.dispatchEvent(new Event('input'));
  });
  await drawn(page);
}

/** From the target to the camera: the way, of length 1, and how far, m. */
async function seenFrom(view = page) {
  const { position_m: p, target_m: q } = await view.evaluate(() => window.shigusa.look());
  const way = p.map((x, k) => x - q[k]);
  const far = Math.hypot(...way);
  return { way: way.map((x) => x / far), far, target: q };
}

/** Where handles are in the page, px, and in the world, m, of the posture that motions begin with. */
const handles = () => page.evaluate(() => {
  const { document: d, handle } = window.shigusa;
  const place = (effector) => d.goals.find((goal) => goal.effector === effector)?.position_m
    ?? d.character.description.places.find((p) => p.effector === effector).start_m;
  return Object.fromEntries(['right_hand', 'left_hand', 'head', 'left_foot'].map((effector) => [effector, { px: handle(effector), m: place(effector) }]));
});

/** Pixels a metre between two handles, along the picture's width or height. */
const scale = (a, b, axis, metres) => Math.abs((a.px[axis] - b.px[axis]) / (a.m[metres] - b.m[metres]));

test('the camera looks from the usual sides by keys and buttons, goes to what is selected, and comes back', { timeout: 180_000 }, async () => {
  const first = await page.evaluate(() => window.shigusa.look());
  const expectWay = async (expected, name) => {
    const { way } = await seenFrom();
    assert.ok(way.every((x, k) => Math.abs(x - expected[k]) < 1e-3), `${name}: seen from ${way}`);
  };
  await page.keyboard.press('v');
  await expectWay([0, 0, 1], 'front');
  await page.keyboard.press('Shift+Numpad3');
  await expectWay([-1, 0, 0], 'side of the right hand');
  await page.keyboard.press('v');
  await expectWay([0, 1, 0], 'top');
  await page.keyboard.press('Shift+V');
  await expectWay([-1, 0, 0], 'side, backwards');
  await page.click('.view-opener');
  await page.click('[data-side="front"]');
  await expectWay([0, 0, 1], 'front, by the menu');
  const { far } = await seenFrom();
  await page.click('[data-view="approach"]');
  const near = await seenFrom();
  assert.ok(near.far < 0.7 * far, `${near.far} m away, before ${far} m`);
  const goal = (await state(page)).goals[0].position_m;
  assert.ok(Math.hypot(...near.target.map((x, k) => x - goal[k])) < 0.6, `it looks at ${near.target}`);
  const [x] = (await handles()).right_hand.px;
  const box = await page.locator('canvas.view').boundingBox();
  assert.ok(x > box.x && x < box.x + box.width, 'the goal is in the picture');
  await page.keyboard.press('Escape');
  await page.keyboard.press('o');
  assert.equal(await page.evaluate(() => window.shigusa.state.view.orthographic), true);
  await page.keyboard.press('Home');
  const { view } = await page.evaluate(() => window.shigusa.state);
  assert.equal(view.orthographic, false);
  const last = await page.evaluate(() => window.shigusa.look());
  for (const key of ['position_m', 'target_m']) {
    assert.ok(last[key].every((value, k) => Math.abs(value - first[key][k]) < 0.05), `${key}: ${last[key]}, at first ${first[key]}`);
  }
  assert.deepEqual(errors, []);
});

test('a side that is asked for before the figure is there is seen once it is', { timeout: 120_000 }, async () => {
  const { page: late, context } = await openStudio(browser, 'about:blank', kSmall);
  let bring;
  const asked = new Promise((done) => (bring = done));
  await late.route('**/mannequin*.bin', async (route) => {
    await asked;
    await route.continue();
  });
  await late.goto(site.url);
  await late.waitForFunction(() => window.shigusa?.document?.result);
  assert.equal(await late.evaluate(() => window.shigusa.framed), false);
  await late.keyboard.press('Shift+Numpad1');
  bring();
  await settled(late);
  const { way } = await seenFrom(late);
  assert.ok([0, 0, 1].every((x, k) => Math.abs(x - way[k]) < 1e-3), `seen from ${way}`);
  await context.close();
});

test('without perspective what is near is no larger, and a dragged goal follows the pointer', { timeout: 240_000 }, async () => {
  await page.keyboard.press('Shift+Numpad1');
  await atStart();
  const seen = await handles();
  // the goal is half a metre nearer than the body
  const perspective = scale(seen.right_hand, seen.head, 1, 1) / scale(seen.left_foot, seen.head, 1, 1);
  assert.ok(Math.abs(perspective - 1) > 0.03, `with perspective ${perspective}`);
  await page.keyboard.press('o');
  await drawn(page);
  const flat = await handles();
  const across = scale(flat.left_hand, flat.right_hand, 0, 0);
  for (const [name, pixels] of [['hand to head', scale(flat.right_hand, flat.head, 1, 1)], ['foot to head', scale(flat.left_foot, flat.head, 1, 1)]]) {
    assert.ok(Math.abs(pixels / across - 1) < 0.01, `${name}: ${pixels} px/m, across ${across}`);
  }
  const before = (await state(page)).goals[0].position_m;
  await drag(page, 'right_hand', -30, -40);
  await settled(page);
  const after = (await state(page)).goals[0].position_m;
  assert.ok(Math.abs(after[0] - before[0] + 30 / across) < 0.01, `sideways by ${after[0] - before[0]} m`);
  assert.ok(Math.abs(after[1] - before[1] - 40 / across) < 0.01, `up by ${after[1] - before[1]} m`);
  assert.ok(Math.abs(after[2] - before[2]) < 1e-3, 'not ahead');
  await page.keyboard.press('Home');
  assert.deepEqual(errors, []);
});

test('the ruler is as high as the body, and its last number says so', { timeout: 240_000 }, async () => {
  assert.equal(await page.evaluate(() => window.shigusa.ruler), null);
  await page.keyboard.press('u');
  for (const stature of [1.741, 1.5]) {
    if (stature !== 1.741) {
      await openTab(page, 'body');
      await page.locator('#panel-body input[type="number"]').first().fill(String(100 * stature));
      await page.locator('#panel-body input[type="number"]').first().press('Enter');
      await page.waitForFunction((m) => window.shigusa.document.character.description.stature_m === m, stature, { timeout: 30_000 });
    }
    await page.waitForFunction((m) => Math.abs((window.shigusa.ruler?.height_m ?? 0) - m) < 1e-3, stature, { timeout: 30_000 });
    const { texts } = await page.evaluate(() => window.shigusa.ruler);
    assert.deepEqual(texts, stature === 1.5 ? ['50', '100', '150 cm'] : ['50', '100', '150', '174 cm']);
  }
  assert.deepEqual(errors, []);
});

test('a longer lens stands farther away and shows the body as large', { timeout: 180_000 }, async () => {
  await atStart();
  await page.keyboard.press('Shift+Numpad1');
  await drawn(page);
  const height = async () => {
    const { head, left_foot: foot } = await handles();
    return foot.px[1] - head.px[1];
  };
  const [tall, { far }] = [await height(), await seenFrom()];
  await page.click('.view-opener');
  await page.locator('[data-view="focal_mm"]').fill('120');
  await page.keyboard.press('Escape');
  await drawn(page);
  const later = await seenFrom();
  assert.ok(Math.abs(later.far / far - 120 / 42) < 0.01, `${later.far} m away, before ${far} m`);
  assert.ok(Math.abs((await height()) / tall - 1) < 0.06, `${await height()} px high, before ${tall} px`);
  assert.deepEqual(errors, []);
});
