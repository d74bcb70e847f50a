// SPDX-License-Identifier: MIT
// What is dropped onto the page: characters, odd files, results; and links.
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { validateBytes } from 'gltf-validator';
import { endOfNode, parseGlb } from './glb.mjs';
import { ask, drag, drop, dropAll, openStudio, openTab, settled, state, take, visit } from './support.mjs';

/** The folder of characters beside the project, where there is one. */
const folder = process.env.SHIGUSA_CHARACTERS ?? fileURLToPath(new URL('../../../shared/characters/', import.meta.url));
const files = existsSync(folder) ? readdirSync(folder).sort() : [];
/** Files that no character can be read from. */
const kOdd = /IndexOutOfRange|invalid-buffer|fuzz|simple_skin|Acrobot|\.tsv$/;

const { site, browser } = await visit();
const { page, errors } = await openStudio(browser, site.url);
await settled(page);

const distance = (a, b) => Math.hypot(...a.map((value, k) => value - b[k]));

test('an odd file is told of, and the page still works', { skip: files.length === 0 && 'no characters here', timeout: 300_000 }, async () => {
  const odd = files.filter((name) => kOdd.test(name)).map((name) => [name, readFileSync(join(folder, name))]);
  const made = [['empty.glb', ''], ['letter.bvh', 'Dear reader'], ['half.json', '{"version": 1'], ['other.json', '{"a": 1}'], ['picture.png', 'x']];
  for (const [name, bytes] of [...odd, ...made]) {
    await page.evaluate(() => document.querySelector('.message .icon-button')?.click());
    await drop(page, name, Buffer.from(bytes));
    await page.waitForFunction(() => window.shigusa.state.notice !== null && !window.shigusa.state.opening, undefined, { timeout: 30_000 });
    const text = await page.locator('.message').innerText();
    assert.ok(text.includes(name), `${name}: ${text}`);
    assert.equal((await state(page)).character, 'human', name);
  }
  await page.locator('.card .pick').nth(1).click();
  await settled(page);
  assert.deepEqual(errors, []);
});

test('a character of a file leaves as GLB with its hand on the goal', { skip: !files.includes('KayKit_Knight.glb') && 'no knight here', timeout: 120_000 }, async () => {
  await drop(page, 'KayKit_Knight.glb', readFileSync(join(folder, 'KayKit_Knight.glb')));
  await page.waitForFunction(() => window.shigusa.document.character.spec.source === 'KayKit_Knight.glb');
  await settled(page);
  await openTab(page, 'take');
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('[data-format="glb"]')]);
  const glb = parseGlb(readFileSync(await download.path()));
  const { reached, unit } = await page.evaluate(() => {
    const { document: d } = window.shigusa;
    return { reached: d.result.summary.candidates[d.chosen].reached[0], unit: d.character.description.node_unit_m };
  });
  const animation = glb.json.animations.findIndex(({ name }) => name.startsWith('shigusa candidate'));
  const node = reached.gltf_node === undefined ? reached.joint : glb.json.nodes[reached.gltf_node].name;
  const world = endOfNode(glb, node, animation).map((value) => unit * value);
  assert.ok(distance(world, reached.goal_m) < 2e-3, `${world} is not ${reached.goal_m}`);
});

const kRobot = 'VRM-Addon-for-Blender__debug_robot.vrm';
test('a VRM character leaves in every format', { skip: !files.includes(kRobot) && 'no robot here', timeout: 120_000 }, async () => {
  await drop(page, kRobot, readFileSync(join(folder, kRobot)));
  await page.waitForFunction((name) => window.shigusa.document.character.spec.source === name, kRobot);
  await settled(page);
  await openTab(page, 'take');
  const begins = { glb: 'glTF', vrma: 'glTF', bvh: 'HIERARCHY', csv: 'time', svg: '<?xml', png: '\x89PNG', task: '{', result: '{' };
  for (const [format, start] of Object.entries(begins)) {
    const bytes = await take(page, format);
    assert.equal(bytes.subarray(0, start.length).toString('latin1'), start, format);
    if (start !== 'glTF') continue;
    const { issues } = await validateBytes(new Uint8Array(bytes));
    assert.deepEqual(issues.messages.filter((message) => message.severity < 2), [], format);
  }
  assert.deepEqual(errors, []);
});

test('a result that comes with other files than it describes is told of', { timeout: 120_000 }, async () => {
  await ask(page, { goals: [{ effector: 'right_hand', position_m: [-0.2, 0.8, 0.4] }] });
  const summary = JSON.parse(await take(page, 'result'));
  const csv = await take(page, 'csv');
  const digest = createHash('sha256').update(csv).digest('hex');
  for (const candidate of summary.candidates) {
    candidate.files = { csv: 'candidate-1.csv' };
    candidate.sha256 = { csv: digest };
  }
  await dropAll(page, [['candidate-1.csv', 'another'], ['summary.json', JSON.stringify(summary)]]);
  await page.waitForFunction(() => window.shigusa.state.notice?.key === 'changedFile');
  assert.match(await page.locator('.message').innerText(), /candidate-1\.csv/);
  const count = summary.candidates.length - 1;
  summary.candidates.length = count;
  await dropAll(page, [['summary.json', JSON.stringify(summary)], ['candidate-1.csv', csv], ['notes.txt', 'mine']]);
  await page.waitForFunction((n) => window.shigusa.document.result?.summary.candidates.length === n, count);
  assert.deepEqual(errors, []);
});

test('what a task says that the page has no place for is kept, and its obstacles are seen', { timeout: 120_000 }, async () => {
  const table = { name: 'table', position_m: [0, 0.4, 0.55], size_m: [1.2, 0.8, 0.5] };
  const task = {
    version: 1, character: 'human', goals: [{ effector: 'right_hand', position_m: [-0.15, 0.9, 0.55] }], obstacles: [table],
    look_at_m: [0, 1, 1], criteria: 'paper',
  };
  await drop(page, 'task.json', JSON.stringify(task));
  await page.waitForFunction(() => window.shigusa.document.goals[0].position_m[1] === 0.9);
  await settled(page);
  const now = await page.evaluate(() => window.shigusa.document);
  assert.deepEqual(now.result.summary.task.obstacles[0].position_m, table.position_m);
  assert.deepEqual(now.result.summary.task.look_at_m, task.look_at_m);
  assert.equal(now.weights.balance, 0.3);
  assert.deepEqual(Object.keys(now.result.summary.candidates[0].criteria), ['joint_range', 'balance', 'torque']);
  if (process.env.SHIGUSA_SHOTS) {
    await page.waitForTimeout(2500);
    await page.screenshot({ path: join(process.env.SHIGUSA_SHOTS, 'table.png') });
  }
  await page.keyboard.press('m');
  await page.waitForFunction(() => window.shigusa.document.goals[0].effector === 'left_hand');
  await drag(page, 'left_hand', 20, -20);
  await settled(page);
  const mirrored = await page.evaluate(() => window.shigusa.task);
  assert.deepEqual(mirrored.obstacles[0].size_m, table.size_m);
  assert.equal(mirrored.goals[0].effector, 'left_hand');
  assert.deepEqual(errors, []);
});

test('a task that asks for a front is ranked by its mixture', { timeout: 240_000 }, async () => {
  const task = { character: 'human', goals: [{ effector: 'right_hand', position_m: [-0.2, 0.9, 0.5] }], pareto: true, evaluations: 600 };
  await drop(page, 'task.json', JSON.stringify(task));
  await page.waitForFunction(() => window.shigusa.document.settings.more.pareto === true);
  await settled(page);
  const { weights, facts, told, scores } = await page.evaluate(() => {
    const { document: d, facts: all } = window.shigusa;
    const { candidates } = d.result.summary;
    return { weights: d.weights, facts: all, told: window.shigusa.task.criteria, scores: candidates.map((candidate) => candidate.score) };
  });
  assert.deepEqual(weights, facts.mixtures[facts.pareto_mixture]);
  assert.equal(told, undefined, 'the engine has it by itself');
  const shown = await page.locator('.score').evaluateAll((all) => all.map((element) => Number(element.dataset.score)));
  assert.deepEqual(shown, scores.map((score) => Number(score.toFixed(3))), 'as the engine scored them');
  assert.deepEqual(errors, []);
});
