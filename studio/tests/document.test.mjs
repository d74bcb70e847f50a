// SPDX-License-Identifier: MIT
// What becomes of a document by steps, hands that move alike, snapping and tasks, and what is said of its motions: without a browser.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { documentOf, sources } from './source.mjs';

const page = await sources(
  'state/history', 'state/places', 'state/symmetry', 'state/snapping', 'state/task', 'state/verdict', 'i18n/verdict_words', 'i18n/motion_words',
);
const near = (a, b) => assert.ok(Math.abs(a - b) < 1e-9, `${a} in place of ${b}`);

const right = { effector: 'right_hand', position_m: [-0.25, 1, 0.45], axis: { axis: 'palm', direction: 'left' } };

test('steps are undone and done again, those of one run as one, sixty at most', () => {
  const history = new page.History(0);
  for (let k = 1; k <= 20; ++k) history.push(k);
  for (let k = 19; k >= 0; --k) assert.equal(history.undo(), k);
  assert.ok(!history.canUndo && history.canRedo);
  assert.equal(history.undo(), 0, 'there is nothing before');
  for (let k = 1; k <= 20; ++k) assert.equal(history.redo(), k);
  for (const value of [21, 22, 23]) history.push(value, 'slider');
  assert.equal(history.undo(), 20);
  for (const value of [21, 22]) history.push(value, 'slider');
  history.endRun();
  history.push(23, 'slider');
  assert.equal(history.undo(), 22);
  history.push(30);
  assert.ok(!history.canRedo, 'another step takes what was undone');
  history.amend(31);
  assert.equal(history.undo(), 22);
  assert.equal(history.redo(), 31);
  for (let k = 100; k < 200; ++k) history.push(k);
  assert.equal(history.all().length, 61);
});

test('a step that is taken back is as if it had not been', () => {
  const history = new page.History('a');
  history.push('b');
  history.undo();
  history.push('c', 'drag');
  assert.ok(!history.takeBack('other'));
  assert.ok(history.takeBack('drag'));
  assert.equal(history.value, 'a');
  assert.equal(history.redo(), 'b');
});

test('the other hand’s goal is the mirror image, what it holds stays', () => {
  const turned = { ...right, rotation_xyzw: [0.1, 0.2, 0.3, 0.9], tolerance_m: [0.1, 0.2, 0.3] };
  const before = documentOf([right, { effector: 'left_hand', position_m: [0.3, 1, 0.4], load_kg: 2 }]);
  const after = page.madeSymmetric(before, page.withGoal(before, turned));
  assert.deepEqual(after.goals[1], {
    effector: 'left_hand', position_m: [0.25, 1, 0.45], rotation_xyzw: [0.1, -0.2, -0.3, 0.9], axis: { axis: 'palm', direction: 'right' }, tolerance_m: [0.1, 0.2, 0.3], load_kg: 2,
  });
  const back = page.madeSymmetric(after, page.moved(after, 'left_hand', [0.1, 1.2, 0.5]));
  assert.deepEqual(back.goals[0].position_m, [-0.1, 1.2, 0.5]);
  assert.deepEqual(page.withMirrorImage(documentOf([right]), 'right_hand').goals.map(({ effector }) => effector), ['right_hand', 'left_hand']);
  const both = page.moved(page.moved(before, 'right_hand', [-0.5, 1, 0.4]), 'left_hand', [0.1, 1, 0.4]);
  assert.equal(page.madeSymmetric(before, both), both, 'where both have changed, all stays');
});

test('places snap to faces, tops, the floor and the other hand', () => {
  const table = { name: 'table', position_m: [-0.4, 0.7, 0.6], size_m: [0.8, 0.04, 0.6] };
  const box = { name: 'box', position_m: [0.6, 0.19, 0.3], size_m: [0.3, 0.3, 0.3] };
  const document = documentOf([{ effector: 'right_hand', position_m: [-0.3, 1, 0.5] }, { effector: 'left_hand', position_m: [0.2, 1.2, 0.4] }], [table, box]);
  const snap = (name, place, ray) => page.snapOf(document, name, new page.Vector3(...place), ray);
  assert.equal(snap('right_hand', [-0.3, 1, 0.5]), null, 'what is far does not attract');
  const onTable = snap('right_hand', [-0.3, 0.75, 0.5]);
  assert.equal(onTable.to, '@thing 0');
  near(onTable.place.y, 0.72 + 0.02 + 0.012);
  const struck = snap('right_hand', [-0.3, 1, 0.5], { origin: new page.Vector3(-0.3, 2, 0.5), direction: new page.Vector3(0, -1, 0) });
  near(struck.place.y, 0.752);
  assert.equal(snap('@thing 1', [0.6, 0.19, 0.3]).to, 'floor');
  near(snap('@thing 1', [0.6, 0.19, 0.3]).place.y, 0.15);
  near(snap('@thing 1', [-0.4, 0.9, 0.6]).place.y, 0.87);
  const beside = snap('right_hand', [0.17, 1.21, 0.4]);
  assert.equal(beside.to, 'left_hand');
  near(beside.place.x, 0.2 - 0.04);
});

test('a task has what differs from the default alone, and of another preset no settings of the search before', () => {
  const facts = { default_preset: 'flat', presets: [], criteria: [], mixtures: [] };
  const document = { ...documentOf([right]), settings: { preset: 'flat', seed: 3, evaluations: null, duration_s: 1.5, more: { search: 'cma_es', criteria: {}, pareto: true } } };
  assert.deepEqual(page.taskOf(facts, document), { search: 'cma_es', pareto: true, version: 1, goals: [right], preset: 'flat', seed: 3, duration_s: 1.5, criteria: {} });
  assert.deepEqual(page.withPreset(document.settings, 'human').more, { criteria: {} });
  assert.equal(page.taskOfLink('#other'), null);
  assert.deepEqual(page.taskOfLink(`#task=${Buffer.from('{"goals":[]}').toString('base64url')}`), { goals: [] });
  for (const bad of ['#task=%%%', `#task=${btoa('{}')}`, `#task=${btoa('null')}`, `#task=${btoa('{')}`]) assert.throws(() => page.taskOfLink(bad), SyntaxError, bad);
});

const series = (columns, ...rows) => ({ columns, frames: rows.length, values: Float64Array.from(rows.flat()) });
const candidate = (summary, mass = [0, 1, 0]) => ({
  summary: { verdict: 'possible', reasons: [], reached: [{ effector: 'right_hand', error_mm: 0.2 }], ...summary },
  series: { time: series(1, [0], [1]), centre_of_mass: series(3, [0, 1, 0], mass) },
});
const falls = { verdict: 'impossible', support: { centre_of_mass: { least_mm: -200, time_s: 1 } }, reasons: [{ kind: 'strength', joint: 'right_knee.flexion', share: 1.27, verdict: 'impossible' }, { kind: 'pressure', outside_mm: 310, verdict: 'impossible' }] };

test('a verdict is told by its worst reason, a fall by its side, a miss by what is left', () => {
  const document = documentOf([right]);
  const words = (of) => page.verdictWords(document, of);
  assert.equal(words(candidate({})), 'can be done');
  for (const [mass, side] of [[[0, 1, 0.5], /would fall forward/], [[0, 1, -0.4], /would fall backward/], [[0.5, 1, 0], /to the left/], [[-0.5, 1, 0], /to the right/]]) {
    assert.match(words(candidate(falls, mass)), side);
  }
  assert.equal(words(candidate({ ...falls, reasons: falls.reasons.slice(0, 1) })), 'not possible: right knee at 127 % of its strength');
  assert.equal(words(candidate({ verdict: 'strains', reasons: [{ kind: 'strength', joint: 'lower_back.flexion', share: 1.02, verdict: 'strains' }] })), 'hard to do: lower back at 102 % of its strength');
  const short = candidate({ reached: [{ effector: 'right_hand', error_mm: 41 }] });
  assert.equal(words(short), '4.1 cm short');
  assert.match(words(candidate({ ...falls, reached: [{ effector: 'right_hand', error_mm: 41 }] }, [0, 1, 0.5])), /^4\.1 cm short · not possible: would fall forward/);
  assert.equal(words(candidate({ reached: [{ effector: 'right_hand', error_mm: 0, rotation_error_deg: 31.7 }] })), '32° from its rotation');
  assert.deepEqual([candidate(falls), candidate({ verdict: 'strains' }), short].map((each) => page.verdictMark(each)), ['not possible', 'hard to do', '4.1 cm short']);
  assert.equal(page.fallOf(documentOf([{ effector: 'left_foot', position_m: [0, 0.1, 0.3] }]), candidate(falls, [0, 1, 0.5])), 'fallsOver');
});

test('scores have words beside the best, and fewer motions are told of by their number', () => {
  assert.deepEqual([0.1, 0.105, 0.14, 0.3, 0.6].map((score) => page.scoreWords(score, 0.1)), ['best', 'about as good', 'a little worse', 'worse', 'much worse']);
  const values = [{ number: 2, text: '2' }, { number: 5, text: '5' }, '154 score over 0.6 worse'];
  assert.match(page.fewerWords({ key: 'fewer_kept', text: '…', values }), /^2 of 5 motions/);
});
