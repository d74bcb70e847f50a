// SPDX-License-Identifier: MIT
// Numbers are dragged, and lengths are in centimetres or inches.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { seriousFindings } from './axe.mjs';
import { linkTo, openStudio, settled, visit } from './support.mjs';

const { site, browser } = await visit();

const task = { evaluations: 64, goals: [{ effector: 'right_hand', position_m: [-0.25, 1.1, 0.4] }] };
const goal = (page) => page.evaluate(() => window.shigusa.document.goals[0]);
const near = (a, b) => assert.ok(Math.abs(a - b) < 1e-9, `${a} in place of ${b}`);

/** Where to take hold of a number: in the middle of an element. */
async function grip(page, selector) {
  const { x, y, width, height } = await page.locator(selector).boundingBox();
  return [x + width / 2, y + height / 2];
}

/** Presses and moves to the side, and leaves it held. */
async function pull(page, selector, pixels) {
  const [x, y] = await grip(page, selector);
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let k = 1; k <= 4; ++k) await page.mouse.move(x + (pixels * k) / 4, y);
}

test('a number is dragged by its field and by its name, finer with Shift, back with Escape, as one step', { timeout: 240_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, linkTo(site, task));
  await settled(page);
  const field = '[data-key="right_hand up"]';
  const name = `label:has(> ${field}) > span`;

  await pull(page, field, 40);
  await page.waitForFunction(() => window.shigusa.state.preview !== null);
  near((await goal(page)).position_m[1], 1.1);
  assert.equal(await page.locator(field).inputValue(), '120.0', 'the field says where the hand would be');
  await page.mouse.up();
  await settled(page);
  near((await goal(page)).position_m[1], 1.2);

  await page.keyboard.down('Shift');
  await pull(page, name, 40);
  await page.mouse.up();
  await page.keyboard.up('Shift');
  await settled(page);
  near((await goal(page)).position_m[1], 1.21);

  await pull(page, name, -80);
  await page.waitForFunction(() => window.shigusa.state.preview !== null);
  await page.keyboard.press('Escape');
  await page.mouse.up();
  await settled(page);
  near((await goal(page)).position_m[1], 1.21);
  assert.equal(await page.locator(field).inputValue(), '121.0');
  assert.equal(await page.evaluate(() => window.shigusa.state.notice), null, 'Escape stopped the drag, and nothing else');

  // two steps
  await page.keyboard.press('Control+z');
  await settled(page);
  near((await goal(page)).position_m[1], 1.2);
  await page.keyboard.press('Control+z');
  await settled(page);
  near((await goal(page)).position_m[1], 1.1);
  assert.ok(await page.locator('[aria-label="Undo"]').isDisabled());

  // a press is no drag: it brings the focus, and keys change the number
  await page.click(field);
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('Enter');
  await settled(page);
  near((await goal(page)).position_m[1], 1.11);
  assert.deepEqual(errors, []);
  await context.close();
});

test('in inches lengths are shown and typed, and the document keeps metres', { timeout: 240_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, linkTo(site, task));
  await settled(page);
  await page.click('.view-opener');
  await page.locator('[data-view="lengths"]').selectOption('in');
  const field = page.locator('[data-key="right_hand up"]');
  assert.equal(await field.inputValue(), (1.1 / 0.0254).toFixed(2));
  await page.keyboard.press('Escape');
  assert.match(await page.locator('#panel-goals').innerText(), /in in from|, in in /);
  await field.fill('40');
  await field.press('Enter');
  await settled(page);
  near((await goal(page)).position_m[1], 1.016);

  await field.fill('100');
  await field.press('Enter');
  await settled(page);
  assert.match(await page.locator('.message').innerText(), /ends \d+\.\d in short/);

  await page.click('#tab-body');
  const stature = page.locator('[data-key="stature"]');
  await stature.fill('70');
  await stature.press('Enter');
  await page.waitForFunction(() => window.shigusa.document.character.description.stature_m === 1.778);
  await settled(page);
  assert.match(await page.locator('#panel-body .fields').filter({ has: stature }).innerText(), /5 ft 10 in/);
  await page.keyboard.press('u');
  await page.waitForFunction(() => window.shigusa.ruler !== null);
  assert.deepEqual(await page.evaluate(() => window.shigusa.ruler.texts), ['12', '24', '36', '48', '60', '5 ft 10 in']);
  assert.deepEqual(await seriousFindings(page), []);

  // it is kept in the browser
  await page.waitForFunction(() => window.shigusa.state.saving === 'saved');
  await page.reload();
  await settled(page);
  assert.equal(await page.locator('[data-key="stature"]').inputValue(), '70');
  assert.deepEqual(errors, []);
  await context.close();
});
