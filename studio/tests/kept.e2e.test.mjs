// SPDX-License-Identifier: MIT
// Links and results carry the choice, every edit and the picture.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { test } from 'node:test';
import { deflateRawSync, inflateRawSync } from 'node:zlib';
import { kept, work } from './kept.mjs';
import { drop, dropAll, openStudio, openTab, settled, state, take, visit } from './support.mjs';

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

const { site, browser } = await visit();

const kBegin = `${site.url}#work=1.`;
const packed = (text) => kBegin + deflateRawSync(text).toString('base64url');
const unpacked = (link) => JSON.parse(inflateRawSync(Buffer.from(link.slice(kBegin.length), 'base64url')));

async function copyLink(page) {
  await openTab(page, 'take');
  await page.click('[data-format="link"]');
  await page.waitForFunction(() => window.shigusa.state.notice?.key === 'linkCopied');
  return page.evaluate(() => navigator.clipboard.readText());
}

const open = () => openStudio(browser, site.url, { viewport: { width: 920, height: 420 }, permissions: ['clipboard-read', 'clipboard-write'] });

test('a link brings back the choice, the edits, the marks and the picture', { timeout: 180_000 }, async () => {
  const { page, context, errors } = await open();
  await settled(page);
  await work(page);
  const link = await copyLink(page);
  const before = await kept(page);
  assert.ok(link.startsWith(kBegin), link.slice(0, 80));
  assert.ok(link.length < 12_000, `${link.length} letters`);

  const other = await context.newPage();
  other.on('pageerror', (error) => errors.push(String(error)));
  await other.goto(link);
  await settled(other);
  assert.equal(await kept(other), before);
  assert.equal((await state(other)).edits, 1);
  assert.equal((await state(other)).compared !== null, true);

  // the search's values are marked, and come back
  await other.click('#tab-adjust');
  assert.equal(await other.locator('.card.chosen em').innerText(), 'edited');
  await other.getByRole('button', { name: 'Reset' }).click();
  assert.equal((await state(other)).edits, 0);
  const values = () => {
    const { document: d } = window.shigusa;
    return { found: d.result.candidates[d.chosen].parameters.find(({ name }) => name === 'squat_deg').value, shown: Number(document.querySelector('[data-parameter="squat_deg"]').closest('.slider').querySelector('.number').value) };
  };
  const { found, shown } = await other.evaluate(values);
  assert.equal(shown, Math.round(found));
  await other.keyboard.press('Control+z');
  assert.equal((await state(other)).edits, 1);
  assert.deepEqual(errors, []);
  await context.close();
});

test('a result that is dropped back brings the same, mirrored and edited again too', { timeout: 180_000 }, async () => {
  const { page, context, errors } = await open();
  await settled(page);
  await work(page);
  await page.keyboard.press('m');
  await page.waitForFunction(() => window.shigusa.document.goals[0].effector === 'left_hand');
  const assigned = () => page.evaluate(() => Object.values(window.shigusa.document.edits).map((edit) => Object.keys(edit.assignments)));
  assert.deepEqual(await assigned(), [[]], 'the mirrored edit is where the next one begins');
  const mirrored = await take(page, 'result');
  const first = await kept(page);
  await page.click('#tab-adjust');
  await page.locator('[data-parameter="squat_deg"]').press('ArrowRight');
  await page.waitForFunction(() => Object.values(window.shigusa.document.edits)[0].assignments.squat_deg !== undefined);
  const edited = await take(page, 'result');
  const second = await kept(page);
  assert.notEqual(first, second);

  const { candidates, studio } = JSON.parse(edited);
  assert.deepEqual(Object.keys(studio.edits), ['2']);
  assert.notDeepEqual(candidates[2].parameters, studio.edits[2].found.parameters, 'others read the edited motion');

  await context.close();
  for (const [bytes, before] of [[mirrored, first], [edited, second]]) {
    const there = await open();
    await settled(there.page);
    await drop(there.page, 'result.json', bytes);
    await there.page.waitForFunction(() => window.shigusa.document.goals[0].effector === 'left_hand');
    await settled(there.page);
    assert.equal(await kept(there.page), before);
    errors.push(...there.errors);
    await there.context.close();
  }
  assert.deepEqual(errors, []);
});

test('a search that was going on begins again', { timeout: 180_000 }, async () => {
  const { page, context, errors } = await open();
  await settled(page);
  const task = { goals: [{ effector: 'right_hand', position_m: [0.2, 0.6, 0.5] }], character: 'human', evaluations: 1_000_000 };
  await drop(page, 'task.json', JSON.stringify(task));
  await page.waitForFunction(() => window.shigusa.state.search?.fraction > 0 && window.shigusa.document.settings.evaluations === 1_000_000);
  const link = await copyLink(page);
  const other = await context.newPage();
  await other.goto(link);
  await other.waitForFunction(() => window.shigusa?.state.search?.fraction > 0 && window.shigusa.document?.goals[0].position_m[0] === 0.2, undefined, { timeout: 60_000 });
  assert.deepEqual(errors, []);
  await context.close();
});

// what the page itself refuses of a link: work.test.mjs
test('a damaged link, and one that the engine refuses, is told of, and the page opens as usual', { timeout: 300_000 }, async () => {
  const { page, context, errors } = await open();
  await settled(page);
  const link = await copyLink(page);
  const good = unpacked(link);
  const with_ = (change) => packed(JSON.stringify({ ...good, ...change }));
  // what is there already stays
  const before = await kept(page);
  const bad = {
    cut: link.slice(0, link.length / 2),
    task: `${site.url}#task=%%%`,
    character: with_({ character: { spec: { source: 'nobody' } } }),
    'goals and motions': with_({ found: undefined, task: { goals: [{ effector: 'right_hand', position_m: 'here' }] } }),
    motions: with_({ found: { ...good.found, candidates: [{ parameters: { weights: 1 } }] } }),
    assignment: with_({ edits: { 0: { assignments: { nothing: '3' } } } }),
  };
  for (const [name, address] of Object.entries(bad)) {
    await page.evaluate((hash) => {
      document.querySelector('.message .icon-button')?.click();
      location.hash = hash;
    }, new URL(address).hash);
    await page.waitForFunction(() => window.shigusa.state.notice?.kind === 'failure' || window.shigusa.state.notice?.key === 'badLink');
    await settled(page);
    const text = await page.locator('.message').innerText();
    assert.match(text, /link/i, `${name}: ${text}`);
    assert.equal(await kept(page), before, name);
  }
  // where nothing is there yet, the page opens as usual
  await page.goto('about:blank');
  await page.goto(bad.motions);
  await settled(page);
  assert.match(await page.locator('.message').innerText(), /link/i);
  const { character, status } = await state(page);
  assert.deepEqual([character, status], ['human', 'reached']);
  // a task that the engine refuses gives way to the one of the motions
  await page.goto('about:blank');
  await page.goto(with_({ task: { ...good.task, goals: [{ effector: 'right_hand', position_m: [0, 'up', 0] }] } }));
  await settled(page);
  assert.deepEqual((await state(page)).goals, good.task.goals);
  assert.deepEqual(errors, []);
  await context.close();
});

test('a work that is too much for a link is offered as a file', { timeout: 120_000 }, async () => {
  const { page, context, errors } = await open();
  await settled(page);
  const most = await page.evaluate(() => window.shigusa.facts.ranges.obstacles[1]);
  let seed = 1;
  const letters = () => Array.from({ length: 1000 }, () => String.fromCharCode(97 + ((seed = (seed * 16807) % 2147483647) % 26))).join('');
  const obstacles = Array.from({ length: most }, (_, k) => ({ name: letters(), position_m: [0.1 * k, 0.1, -3], size_m: [0.1, 0.1, 0.1] }));
  const task = { character: 'human', goals: [{ effector: 'right_hand', position_m: [-0.15, 0.9, 0.45] }], obstacles };
  await drop(page, 'task.json', JSON.stringify(task));
  await page.waitForFunction(() => window.shigusa.document.goals[0].position_m[1] === 0.9);
  await settled(page);
  await openTab(page, 'take');
  await page.click('[data-format="link"]');
  await page.waitForFunction(() => window.shigusa.state.notice?.key === 'largeLink');
  assert.match(await page.locator('.message').innerText(), /Save the result/);
  const [download] = await Promise.all([page.waitForEvent('download'), page.locator('#panel-take').getByRole('button', { name: 'Result' }).last().click()]);
  assert.match(download.suggestedFilename(), /result\.json$/);
  assert.deepEqual(errors, []);
  await context.close();
});

test('a character is named in a link, and its file asked for', { timeout: 300_000 }, async () => {
  const { page, context, errors } = await open();
  await settled(page);
  const bvh = await take(page, 'bvh');
  const ofFile = (where) => where.waitForFunction(() => window.shigusa.document?.character.bytes !== undefined);
  await drop(page, 'walker.bvh', bvh);
  await ofFile(page);
  await settled(page);
  await work(page);
  const result = await take(page, 'result');
  const link = await copyLink(page);
  const before = await kept(page);
  const { character, found } = unpacked(link);
  assert.equal(character.spec.source, 'walker.bvh');
  assert.match(character.sha256, /^[0-9a-f]{64}$/);
  await context.close();

  // elsewhere a body of its measures moves until the file comes
  const there = await openStudio(browser, link, { viewport: { width: 920, height: 420 }, bypassCSP: true, permissions: ['clipboard-read', 'clipboard-write'] });
  const { page: other } = there;
  await settled(other);
  const banner = other.locator('.wanted');
  assert.match(await banner.innerText(), /walker\.bvh/);
  assert.equal(await kept(other), before);
  assert.equal(await other.evaluate(() => window.shigusa.document.character.bytes), undefined);
  await other.addScriptTag({ content: axe });
  const serious = await other.evaluate(async () => (await window.axe.run()).violations.filter((v) => ['serious', 'critical'].includes(v.impact)).map((v) => v.id));
  assert.deepEqual(serious, []);
  await other.locator('.wanted input').setInputFiles({ name: 'walker.bvh', mimeType: 'text/plain', buffer: Buffer.concat([bvh, Buffer.from('\n')]) });
  await other.waitForFunction(() => window.shigusa.state.notice?.key === 'unknownWanted');
  assert.equal(await kept(other), before);
  // a link made meanwhile names it too, and what is done meanwhile goes along
  await other.keyboard.press('Digit2');
  const changed = await kept(other);
  assert.notEqual(changed, before);
  const again = unpacked(await copyLink(other));
  assert.deepEqual(again.character, character);
  await dropAll(other, [['another name.bvh', bvh]]);
  await ofFile(other);
  await settled(other);
  assert.equal(await kept(other), changed);
  assert.equal(await banner.isVisible(), false);

  // a work that has no measures yet waits for the file, where the browser keeps none
  const elsewhere = await openStudio(browser, packed(JSON.stringify({ ...unpacked(link), found: undefined, chosen: 0, compared: null, edits: {} })));
  await settled(elsewhere.page);
  assert.equal((await state(elsewhere.page)).character, 'human');
  assert.match(await elsewhere.page.locator('.wanted').innerText(), /to go on/);
  await drop(elsewhere.page, 'walker.bvh', bvh);
  await ofFile(elsewhere.page);
  await settled(elsewhere.page);
  assert.equal(JSON.stringify((await state(elsewhere.page)).goals), JSON.stringify(found.task.goals));
  await elsewhere.context.close();

  // with a result the file may come at once
  const { page: third, context: fresh, errors: more } = await open();
  await settled(third);
  await dropAll(third, [['result.json', result], ['walker.bvh', bvh]]);
  await ofFile(third);
  await settled(third);
  assert.equal(await kept(third), before);
  assert.equal(await third.locator('.wanted').isVisible(), false);
  assert.deepEqual([...errors, ...there.errors, ...elsewhere.errors, ...more], []);
  await there.context.close();
  await fresh.close();
});
