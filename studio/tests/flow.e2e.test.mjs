// SPDX-License-Identifier: MIT
// What a person does first: drag, choose, adjust, take away.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { validateBytes } from 'gltf-validator';
import { endOfNode, parseGlb } from './glb.mjs';
import { drag, openStudio, settled, slide, state, take, visit } from './support.mjs';

const { site, browser } = await visit();

const distance = (a, b) => Math.hypot(...a.map((value, k) => value - b[k]));

test('a person reaches on opening, and a sentence says what to drag', async () => {
  const { page, context, errors } = await openStudio(browser, site.url, { reducedMotion: 'no-preference' });
  await settled(page);
  const now = await state(page);
  assert.ok(now.candidates >= 3, `${now.candidates} motions`);
  assert.equal(now.status, 'reached');
  const [ours, engines] = await page.evaluate(() => {
    const { weights, result } = window.shigusa.document;
    return [weights, Object.fromEntries(Object.entries(result.summary.task.criteria).map(([name, { weight }]) => [name, weight]))];
  });
  assert.deepEqual(ours, engines, "the page's weights are the engine's own");
  assert.ok(now.playing);
  assert.match(await page.locator('.hint').innerText(), /Drag the orange ball/);
  assert.deepEqual(errors, []);
  await context.close();
});

test('drag, choose the third, move a slider, export: the hand stays on its goal', async () => {
  const { page, context, errors } = await openStudio(browser, site.url, { seen: true });
  await settled(page);
  const before = await state(page);
  const { time, duration } = await page.evaluate(() => ({ time: window.shigusa.time, duration: window.shigusa.document.result.candidates[0].summary.duration_s }));
  assert.deepEqual([before.playing, time], [false, duration], 'who wants little to move sees the end');
  assert.ok(await page.locator('.hint').isVisible());
  await drag(page, 'right_hand', -40, -60, { hold: 60, followed: true });
  assert.ok(!(await page.locator('.hint').isVisible()), 'who has dragged needs no hint');
  assert.ok((await page.evaluate(() => window.shigusa.timings.dragToPose.length)) > 0, 'the body followed the drag');
  await settled(page);
  const dragged = await state(page);
  assert.ok(distance(before.goals[0].position_m, dragged.goals[0].position_m) > 0.05);
  assert.ok(dragged.candidates >= 3, `${dragged.candidates} motions`);
  assert.equal(dragged.words.length, dragged.candidates, 'each has its word');

  await page.locator('.card .pick').nth(2).click();
  const third = await page.evaluate(() => window.shigusa.chosen);
  assert.equal(await page.locator('.card').nth(2).getAttribute('class'), 'card chosen');

  await page.click('#tab-adjust');
  const posture = () => page.evaluate(() => window.shigusa.document.edits[window.shigusa.chosen]?.generated.candidates[0].summary.final_posture.knee_flexion_deg);
  for (const share of [0.2, 0.5]) {
    const seen = await page.evaluate(() => window.shigusa.timings.sliderToMotion.length);
    await slide(page, '[data-parameter="squat_deg"]', share);
    await page.waitForFunction((n) => window.shigusa.timings.sliderToMotion.length > n, seen);
    const goal = (await state(page)).goals[0].position_m;
    const hand = await page.evaluate(() => window.shigusa.hand());
    assert.ok(distance(goal, hand) < 1e-3, `the hand is ${distance(goal, hand)} m off`);
  }
  assert.ok((await posture()) > 20, 'the slider bends the knees');
  assert.equal(await page.evaluate(() => window.shigusa.chosen), third);

  const bytes = await take(page, 'glb');
  const { issues } = await validateBytes(new Uint8Array(bytes));
  assert.deepEqual(issues.messages.filter((message) => message.severity < 2), [], 'no errors and no warnings');
  const glb = parseGlb(bytes);
  const end = endOfNode(glb, 'right_hand_grip');
  const { goals } = await state(page);
  assert.ok(distance(end, goals[0].position_m) < 1e-3, `exported hand at ${end}, goal ${goals[0].position_m}`);
  assert.deepEqual(errors, []);
  await context.close();
});

test('trunk first: the leg contraction bends the knees, and the hand stays on its goal', { timeout: 120_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url);
  await settled(page);
  await page.locator('select').filter({ hasText: 'trunk first' }).selectOption('human');
  await settled(page);
  await drag(page, 'right_hand', -20, 30);
  await settled(page);
  const { candidates } = await state(page);
  assert.ok(candidates >= 1, `${candidates} candidates`);
  await page.locator('.card .pick').nth(candidates - 1).click();
  await page.click('#tab-adjust');
  const knees = () => page.evaluate(() => {
    const { document: d, chosen } = window.shigusa;
    return (d.edits[chosen]?.generated.candidates[0] ?? d.result.candidates[chosen]).summary.final_posture.knee_flexion_deg;
  });
  const bent = [];
  for (const share of [0.1, 0.5, 0.9]) {
    const seen = await page.evaluate(() => window.shigusa.timings.sliderToMotion.length);
    await slide(page, '[data-parameter="legs.contraction"]', share);
    await page.waitForFunction((n) => window.shigusa.timings.sliderToMotion.length > n, seen);
    bent.push(await knees());
    const goal = (await state(page)).goals[0].position_m;
    const hand = await page.evaluate(() => window.shigusa.hand());
    assert.ok(distance(goal, hand) < 1e-3, `the hand is ${distance(goal, hand)} m off`);
  }
  assert.ok(Math.max(...bent) > Math.min(...bent) + 20, `knees at ${bent.map(Math.round)}°`);
  const glb = parseGlb(await take(page, 'glb'));
  const { goals } = await state(page);
  const end = endOfNode(glb, 'right_hand_grip');
  assert.ok(distance(end, goals[0].position_m) < 1e-3, `exported hand at ${end}, goal ${goals[0].position_m}`);
  assert.deepEqual(errors, []);
  await context.close();
});
