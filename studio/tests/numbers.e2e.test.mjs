// SPDX-License-Identifier: MIT
// Numbers are dragged, and lengths are in centimetres or inches.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { seriousFindings } from './axe.mjs';
import { answered, linkTo, openStudio, openTab, settled, visit } from './support.mjs';

const { site, browser } = await visit();

const task = { evaluations: 64, goals: [{ effector: 'right_hand', position_m: [-0.25, 1.1, 0.4] }] };
const goal = (page) => page.evaluate(() => window.shigusa.document.goals[0]);
const near = (a, b) => assert.ok(Math.abs(a - b) < 1e-9, `${a} in place of ${b}`);

/** Where to take hold of a number: in the middle of an element. */
async function grip(page, selector) {
  await page.locator(selector).scrollIntoViewIfNeeded();
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

  await openTab(page, 'body');
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

test('the numbers of sliders are dragged like all others, within their limits, a step for each drag', { timeout: 240_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, linkTo(site, task));
  await settled(page);
  const undo = page.locator('[aria-label="Undo"]');
  const number = (name) => `.slider:has([data-${name}]) .number`;
  const value = (name) => page.evaluate((parameter) => {
    const { document: d, chosen } = window.shigusa;
    return (d.edits[chosen]?.generated.candidates[0] ?? d.result.candidates[chosen]).parameters.find(({ name: own }) => own === parameter).value;
  }, name);
  const edits = () => page.evaluate(() => Object.keys(window.shigusa.document.edits).length);

  // Adjust: the hand follows, Escape leaves no step
  await page.click('#tab-adjust');
  const lean = await value('lean_deg');
  const field = number('parameter="lean_deg"');
  await pull(page, field, 40);
  await page.waitForFunction(() => Object.keys(window.shigusa.document.edits).length === 1);
  await page.keyboard.press('Escape');
  await page.mouse.up();
  await answered(page); // what was on its way does not come later
  assert.equal(await edits(), 0);
  assert.ok(await undo.isDisabled());
  near(await value('lean_deg'), lean);
  assert.equal(await page.locator(field).inputValue(), String(Math.round(lean)));

  await page.keyboard.down('Alt');
  await pull(page, `.row:has([data-parameter="lean_deg"]) .row-name`, 400);
  await page.mouse.up();
  await page.keyboard.up('Alt');
  const most = Number(await page.locator(field).getAttribute('max'));
  await page.waitForFunction((limit) => window.shigusa.document.edits[window.shigusa.chosen]?.assignments.lean_deg === String(limit), most);
  await answered(page);
  await page.keyboard.press('Control+z');
  await page.waitForFunction(() => Object.keys(window.shigusa.document.edits).length === 0);
  assert.ok(await undo.isDisabled());

  // a weight of the inverse kinematics goes by shares: fifteen twentieths more, e^0.75
  await page.evaluate(() => document.querySelectorAll('#panel-adjust details').forEach((details) => (details.open = true)));
  const name = 'right_shoulder.flexion.weight';
  const weight = Number((await value(name)).toPrecision(3));
  const way = weight > 1 ? -60 : 60;
  await pull(page, number(`parameter="${name}"`), way);
  await page.mouse.up();
  await page.waitForFunction(() => Object.keys(window.shigusa.document.edits).length === 1);
  await page.waitForFunction(([parameter, expected]) => Math.abs(Math.log(Number(window.shigusa.document.edits[window.shigusa.chosen].assignments[parameter]) / expected)) < 0.03, [name, weight * Math.exp(way / 80)]);
  await answered(page); // nothing of it comes between the next steps

  // Criteria
  await page.click('#tab-criteria');
  const torque = () => page.evaluate(() => window.shigusa.document.weights.torque);
  const before = await torque();
  const down = before >= 0.5;
  await pull(page, number('criterion="torque"'), down ? -80 : 80);
  await page.mouse.up();
  near(await torque(), before + (down ? -0.2 : 0.2));
  await pull(page, number('criterion="torque"'), 40);
  await page.keyboard.press('Escape');
  await page.mouse.up();
  near(await torque(), before + (down ? -0.2 : 0.2));
  await page.keyboard.press('Control+z');
  near(await torque(), before);

  // timing
  await page.click('#tab-adjust');
  await pull(page, number('parameter="ease"'), 80);
  await page.waitForFunction(() => window.shigusa.state.preview !== null);
  await page.keyboard.press('Escape');
  await page.mouse.up();
  await answered(page);
  assert.deepEqual(await page.evaluate(() => [window.shigusa.state.preview, window.shigusa.task.ease]), [null, undefined]);
  assert.equal(await page.locator(number('parameter="ease"')).inputValue(), '0');
  await pull(page, number('parameter="ease"'), 80);
  await page.mouse.up();
  await page.waitForFunction(() => window.shigusa.task.ease === 0.2);
  await settled(page);

  // a locked parameter is not dragged
  await page.locator('.row:has([data-parameter="right_shoulder.flexion.weight"]) .lock').click();
  await page.waitForFunction(() => document.querySelector('.slider:has([data-parameter="right_shoulder.flexion.weight"]) .number').disabled);
  const locked = await page.evaluate(() => JSON.stringify(window.shigusa.document.edits[window.shigusa.chosen].assignments));
  await pull(page, `.row:has([data-parameter="right_shoulder.flexion.weight"]) .row-name`, 40);
  await page.mouse.up();
  await answered(page);
  assert.equal(await page.evaluate(() => JSON.stringify(window.shigusa.document.edits[window.shigusa.chosen].assignments)), locked);

  // measures and the duration, within their limits
  await openTab(page, 'body');
  await page.keyboard.down('Alt');
  await pull(page, '[data-key="stature"]', 600);
  await page.mouse.up();
  await page.keyboard.up('Alt');
  await page.waitForFunction(() => window.shigusa.document.character.description.stature_m === window.shigusa.facts.ranges.stature_m[1]);
  await settled(page);
  assert.deepEqual(errors, []);
  await context.close();
});

test('a finger drags a number to the side, and scrolls by a drag upwards', { timeout: 240_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, linkTo(site, task), { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await settled(page);
  await page.locator('#tab-adjust').tap();
  const session = await context.newCDPSession(page);
  const finger = async (selector, dx, dy) => {
      const [x, y] = await grip(page, selector);
    const points = (k) => [{ x: x + (dx * k) / 8, y: y + (dy * k) / 8 }];
    await session.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: points(0) });
    for (let k = 1; k <= 8; ++k) await session.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: points(k) });
    await session.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
  };
  const scrolled = () => page.evaluate(() => [...document.querySelectorAll('*')].reduce((sum, element) => sum + element.scrollTop, 0));
  const field = '.slider:has([data-parameter="squat_deg"]) .number';
  const before = Number(await page.locator(field).inputValue());

  const top = await scrolled();
  await finger(field, 6, 0);
  await answered(page);
  assert.equal(Number(await page.locator(field).inputValue()), before, 'a press that trembles is none');
  await page.evaluate(() => document.activeElement.blur());
  await finger(field, 120, 0);
  await page.waitForFunction(() => Object.keys(window.shigusa.document.edits).length === 1);
  await answered(page); // the field says what is shown
  const after = Number(await page.locator(field).inputValue());
  assert.ok(after >= before + 15, `${before}° became ${after}°`);
  assert.equal(await scrolled(), top, 'nothing scrolled');

  await finger('.slider:has([data-parameter="lean_deg"]) .number', 0, -200);
  await page.waitForFunction((from) => [...document.querySelectorAll('*')].reduce((sum, element) => sum + element.scrollTop, 0) > from + 40, top);
  assert.equal(await page.evaluate(() => window.shigusa.document.edits[window.shigusa.chosen].assignments.lean_deg), undefined);
  assert.deepEqual(errors, []);
  await context.close();
});

test('two sliders that move at once both count', { timeout: 120_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url);
  await settled(page);
  await openTab(page, 'adjust');
  await page.evaluate(() => {
    for (const name of ['lean_deg', 'squat_deg']) {
      const range = document.querySelector(`[data-parameter="${name}"]`);
      range.value = String(Number(range.value) + 0.1 * (Number(range.max) - Number(range.min)));
      range.dispatchEvent(new Event('input', { bubbles: true }));
      range.dispatchEvent(new Event('change', { bubbles: true }));
    }
  });
  await page.waitForFunction(() => {
    const { document: d } = window.shigusa;
    const { assignments = {} } = d.edits[d.chosen] ?? {};
    return 'lean_deg' in assignments && 'squat_deg' in assignments;
  }, undefined, { timeout: 60_000 });
  assert.deepEqual(errors, []);
  await context.close();
});
