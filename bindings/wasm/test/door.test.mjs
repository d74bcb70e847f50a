// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { EngineError, openDoor } from '../dist/door.js';
import { openedDoor, smallTask, starts, wasmBytes } from './support.mjs';

const door = await openedDoor();
const human = door.character({ source: 'human' });

/** The failure of what `work` throws. */
function failureOf(work) {
  try {
    work();
  } catch (error) {
    assert.ok(error instanceof EngineError, String(error));
    return error.failure;
  }
  assert.fail('nothing was refused');
}

const near = (a, b, tolerance) => assert.ok(Math.abs(a - b) <= tolerance, `${a} and ${b}`);

test('a door finds the files beside it', async () => {
  const [given, found] = await Promise.all([openedDoor(), openDoor()]);
  assert.deepEqual(found.facts(), given.facts());
});

test('the engine tells its tables', () => {
  const facts = door.facts();
  const names = facts.criteria.map(({ name }) => name);
  for (const weights of Object.values(facts.mixtures)) assert.deepEqual(Object.keys(weights), names);
  for (const { mixture } of facts.presets) assert.ok(mixture in facts.mixtures, mixture);
  assert.ok(facts.pareto_mixture in facts.mixtures);
  assert.ok(facts.presets.some(({ name }) => name === facts.default_preset));
  const written = new Set(facts.formats.filter((format) => format.written).map(({ name }) => name));
  assert.ok(written.has('svg') && !written.has('png') && !written.has('pdf'), 'the library draws SVG alone');
  assert.deepEqual(facts.formats.filter((format) => format.robot).map(({ name }) => name), ['urdf', 'mjcf']);
  const [, heaviest] = facts.ranges.load_kg;
  const task = (load_kg) => ({ ...smallTask, goals: [{ ...smallTask.goals[0], load_kg }], evaluations: 8 });
  assert.equal(failureOf(() => door.generate(human, task(heaviest + 1))).code, 'parse');
});

test('a character tells its joints, places and nodes', () => {
  const said = human.describe();
  assert.equal(said.joints.length, said.dof);
  assert.ok(said.places.some((place) => place.effector === 'right_hand'));
  assert.ok(said.nodes.length > 15);
  for (const [i, node] of said.nodes.entries()) assert.ok(node.parent < i, node.name);
  assert.ok(said.support_polygon.length >= 3);
  assert.deepEqual(said.feet.map(({ effector }) => effector).sort(), ['left_foot', 'right_foot']);
  for (const { sole_m, floor_m, least_m } of said.feet) assert.ok(Math.abs(Math.min(...sole_m.map(([, y]) => y)) + least_m - floor_m) < 1e-9);
});

test('a task with cost tells what its motions cost the body', () => {
  const asked = { ...smallTask, candidates: 2, goals: [{ ...smallTask.goals[0], load_kg: 8 }] };
  const plain = door.generate(human, asked);
  assert.equal(plain.read().candidates[0].summary.cost, undefined);
  const told = door.generate(human, { ...asked, cost: true, ergonomics: { coupling: 'poor' } });
  const { candidates } = told.read();
  assert.ok(candidates.length > 0);
  for (const { summary: { cost } } of candidates) {
    assert.ok(cost.reba.worst >= 1 && cost.reba.worst <= 15 && cost.reba.parts.coupling.worst === 2);
    assert.ok(cost.rula.worst >= cost.rula.mean);
    assert.ok(cost.low_back.compression_n > 300 && cost.low_back.moment_nm > 0);
    assert.equal(cost.ergonomics.coupling, 'poor');
    assert.ok(cost.strengths.every(({ able }) => able >= 0 && able <= 1));
    assert.deepEqual(cost.niosh, []);
  }
  for (const one of [plain, told]) one.free();
});

test('a piece of work tells its actions and the ways of its things', () => {
  const result = door.generate(human, {
    version: 2, seed: 3, evaluations: 64, candidates: 1,
    things: { cup: { shape: 'cylinder', size_m: [0.08, 0.1, 0.08], mass_kg: 0.3, position_m: [-0.3, 1.0, 0.35] } },
    actions: [{ grasp: 'cup' }, { place: 'cup', position_m: [-0.1, 1.1, 0.4] }],
  });
  const { summary, candidates: [first] } = result.read();
  assert.equal(summary.status, 'reached');
  assert.deepEqual(first.summary.actions.map(({ kind }) => kind), ['grasp', 'place']);
  assert.equal(first.summary.actions[0].end_s, first.summary.actions[1].start_s);
  assert.ok(first.summary.actions[1].placed.error_mm <= 1);
  const { frames, columns, values } = first.series.things;
  assert.equal(columns, 7);
  for (const [k, at] of [-0.3, 1.0, 0.35].entries()) near(values[k], at, 1e-9);
  for (const [k, at] of [-0.1, 1.1, 0.4].entries()) near(values[(frames - 1) * columns + k], at, 1e-3);
  const again = door.restore(human, summary);
  assert.deepEqual(again.series(1, 'things').values, values);
  for (const one of [result, again]) one.free();
});

test('one action of a piece of work is edited, and one is searched anew', () => {
  const reach = (position_m) => ({ goals: [{ effector: 'right_hand', position_m }] });
  const result = door.generate(human, {
    version: 2, seed: 3, evaluations: 64, candidates: 1,
    actions: [reach([-0.2, 1.0, 0.5]), { wait_s: 0.2 }, reach([-0.3, 0.7, 0.45])],
  });
  const squat = (of, action) => of.actionParameters(1, action).find(({ name }) => name === 'squat_deg').value;
  const edited = result.replayWork(1, { action: 3, set: ['squat_deg=55'] });
  near(squat(edited, 3), 55, 1e-9);
  assert.equal(squat(edited, 1), squat(result, 1));
  assert.deepEqual(edited.actionParameters(1, 2), []);
  assert.ok(edited.read().candidates[0].summary.actions[2].reached[0].error_mm < 1);
  const reports = [];
  const again = result.replayWork(1, { keep: [1, 2], seed: 5 }, (progress) => { reports.push(progress.evaluations); });
  assert.ok(reports.length > 0);
  const { summary } = again.read();
  assert.equal(summary.task.seed, 5);
  assert.equal(squat(again, 1), squat(result, 1));
  assert.match(failureOf(() => result.replayWork(1, { again: [4] })).message, /no action 4; the task has 3/);
  for (const one of [result, edited, again]) one.free();
});

test('stature is as it was asked for', () => {
  const small = door.character({ source: 'human', stature_m: 1.5 });
  near(small.describe().stature_m, 1.5, 1e-9);
  small.free();
});

test('a search gives candidates that reach, with all of their series', () => {
  const result = door.generate(human, smallTask);
  const { summary, candidates } = result.read();
  assert.equal(summary.status, 'reached');
  assert.equal(candidates.length, result.candidates);
  assert.ok(candidates.length >= 2);
  const { nodes, joints } = human.describe();
  for (const { summary: told, series, parameters } of candidates) {
    assert.ok(told.reached[0].error_mm < 1);
    for (const table of Object.values(series)) {
      assert.equal(table.frames, told.frames);
      assert.equal(table.values.length, table.frames * table.columns);
      assert.ok(table.values.every(Number.isFinite));
    }
    assert.equal(series.angles.columns, joints.length);
    assert.equal(series.torques.columns, joints.length);
    assert.equal(series.node_translations.columns, 3 * nodes.length);
    assert.equal(series.node_rotations.columns, 4 * nodes.length);
    near(series.time.values.at(-1), told.duration_s, 0.02);
    const hand = series.effectors.values.slice(-3);
    for (const [i, x] of smallTask.goals[0].position_m.entries()) near(hand[i], x, 1e-3);
    assert.ok(parameters.length > 0);
    for (const parameter of parameters) {
      assert.ok(parameter.low <= parameter.value && parameter.value <= parameter.high, parameter.name);
    }
  }
  result.free();
});

test('a search tells how far it is', () => {
  const told = [];
  door.generate(human, smallTask, (progress) => void told.push(progress)).free();
  assert.ok(told.length > 1);
  assert.ok(told.every(({ fraction }, i) => fraction >= (told[i - 1]?.fraction ?? 0) && fraction <= 1));
  assert.ok(told.at(-1).evaluations > told[0].evaluations);
  assert.ok(Number.isFinite(told.at(-1).best_score));
});

test('a search that is stopped gives the best so far, or nothing', () => {
  const long = { ...smallTask, evaluations: 200000 };
  const begin = performance.now();
  let calls = 0;
  const result = door.generate(human, long, () => ++calls > 5);
  assert.ok(JSON.parse(result.summaryText()).evaluations < 100000);
  assert.ok(performance.now() - begin < 20000);
  result.free();
});

test('what a watch throws comes out of the search', () => {
  assert.throws(() => door.generate(human, smallTask, () => {
    throw new RangeError('enough');
  }), RangeError);
});

test('a goal out of reach is no failure', () => {
  const goals = [{ effector: 'right_hand', position_m: [-0.25, 2.6, 1.5] }];
  const result = door.generate(human, { ...smallTask, goals });
  const { summary } = result.read();
  assert.equal(summary.status, 'unreachable');
  assert.ok(summary.remaining_mm > 100);
  result.free();
});

test('what is refused has a code and a sentence', () => {
  assert.equal(failureOf(() => door.character({ source: 'dragon' })).code, 'parse');
  const parse = failureOf(() => door.generate(human, '{"goals": ['));
  assert.equal(parse.code, 'parse');
  assert.match(parse.message, /task/);
  const goals = [{ effector: 'tail', position_m: [0, 1, 0] }];
  const effector = failureOf(() => door.generate(human, { ...smallTask, goals }));
  assert.equal(effector.code, 'not_found');
  assert.match(effector.message, /tail/);
  const bytes = new TextEncoder().encode('HIERARCHY\nROOT');
  assert.equal(failureOf(() => door.character({ source: 'a.bvh' }, bytes)).code, 'parse');
  const result = door.generate(human, smallTask);
  assert.equal(failureOf(() => result.export(1, 'png')).code, 'unsupported');
  assert.equal(failureOf(() => result.export(99, 'bvh')).code, 'invalid_argument');
  assert.equal(failureOf(() => result.replay(1, ['squat_deg=much'])).code, 'invalid_argument');
  result.free();
});

test('a refusal tells its sentence and values, for pages of other languages', () => {
  const goals = [{ effector: 'left_foot', position_m: [0.1, 0.02, 0.3] }];
  const { message, reason } = failureOf(() => door.generate(human, { ...smallTask, preset: 'flat', goals }));
  assert.equal(reason.place, 'goal of left_foot');
  assert.equal(`${reason.place}: ${reason.message.text}`, message);
  assert.equal(reason.message.key, 'sole_below_floor');
  const [height, below, least] = reason.message.values;
  assert.deepEqual(height, { text: '0.020', number: 0.02, unit: 'm' });
  assert.equal(below.unit, 'mm');
  near(least.number, 0.02 + below.number / 1000, 1e-3);
  // its English text is the sentence of the facts with these values
  let hole = 0;
  const { text } = door.facts().messages.find(({ key }) => key === reason.message.key);
  assert.equal(text.replaceAll(/\{[^{}]*\}/g, () => reason.message.values[hole++].text), reason.message.text);
  // a value may be a sentence
  const bytes = new TextEncoder().encode(JSON.stringify({ asset: { version: '2.0' }, nodes: [{ name: 'a' }] }));
  const lone = failureOf(() => door.character({ source: 'lone.gltf' }, bytes)).reason.message;
  const sentences = (said) => (said.key === undefined ? [] : [said.key, ...said.values.flatMap(sentences)]);
  assert.ok(sentences(lone).includes('no_skeleton') && sentences(lone).includes('one_node'), sentences(lone).join());
});

test('what is no robot, or a bomb of one, is refused by name', () => {
  const refused = (source, text, message) => {
    const failure = failureOf(() => door.character({ source }, new TextEncoder().encode(text)));
    assert.ok(['parse', 'invalid_argument'].includes(failure.code), failure.code);
    assert.match(failure.message, message);
  };
  refused('a.urdf', '<robot name="a"><link name="base"/></robot>', /no humanoid robot/);
  refused('a.urdf', '<!DOCTYPE r [<!ENTITY a "b"><!ENTITY c "&a;&a;">]><robot name="&c;"/>', /^line 1 of a.urdf: a document type with definitions/);
  refused('a.urdf', '<a>'.repeat(100000), /nested deeper than 64 elements/);
  refused('a.xml', '<a>'.repeat(40000), /nested deeper than 100 elements/);
  refused('a.urdf', `<robot name="a">${'<a/>'.repeat(200000)}</robot>`, /more than 200000 tags/);
  refused('a.urdf', ' '.repeat(2 ** 24 + 1), /are allowed/);
  refused('a.xml', ' '.repeat(2 ** 22 + 1), /are allowed/);
});

test('a result is restored from its JSON, bit for bit', () => {
  const result = door.generate(human, smallTask);
  const again = door.restore(human, result.summaryText());
  for (const name of ['angles', 'torques', 'node_rotations']) {
    assert.deepEqual(again.series(1, name), result.series(1, name));
  }
  assert.deepEqual(again.export(1, 'bvh'), result.export(1, 'bvh'));
  // also from what JavaScript made of the text
  const third = door.restore(human, JSON.parse(result.summaryText()));
  assert.deepEqual(third.series(1, 'angles'), result.series(1, 'angles'));
  for (const one of [third, again, result]) one.free();
});

test('a replay changes what it is told to and still reaches', () => {
  const result = door.generate(human, smallTask);
  const squat = result.parameters(1).find((parameter) => parameter.name === 'squat_deg');
  assert.ok(squat);
  const edited = result.replay(1, [`squat_deg=${squat.value > 40 ? 20 : 60}`]);
  assert.equal(edited.candidates, 1);
  const { summary, series } = edited.read().candidates[0];
  assert.ok(summary.reached[0].error_mm < 1);
  assert.notDeepEqual(series.angles, result.series(1, 'angles'));
  edited.free();
  result.free();
});

test('in the mirror the other hand reaches', () => {
  const result = door.generate(human, smallTask);
  const mirrored = result.mirror();
  const [reached] = mirrored.read().candidates[0].summary.reached;
  assert.equal(reached.effector, 'left_hand');
  near(reached.goal_m[0], -smallTask.goals[0].position_m[0], 1e-9);
  mirrored.free();
  result.free();
});

test('candidates leave as BVH, CSV and SVG', () => {
  const result = door.generate(human, smallTask);
  const text = (format) => new TextDecoder().decode(result.export(1, format));
  assert.match(text('bvh'), /^HIERARCHY/);
  assert.match(text('csv'), /^time/);
  const svg = text('svg');
  assert.match(svg, /^<\?xml[^]*<svg[^]*<\/svg>\n$/);
  result.free();
});

test('files and series have the rate that is asked for', () => {
  const result = door.generate(human, smallTask);
  const text = (options) => new TextDecoder().decode(result.export(1, 'bvh', options));
  assert.match(text({ fps: 24 }), /Frame Time: 0\.041666666666666664/);
  assert.equal(text({}), text({ fps: 60 }));
  assert.equal(failureOf(() => result.export(1, 'bvh', { fps: 0 })).code, 'parse');
  const time = result.sampled(1, 'time', 24);
  const turns = result.sampled(1, 'node_rotations', 24);
  const own = result.series(1, 'node_rotations');
  assert.equal(time.values[12], 12 / 24);
  assert.equal(turns.frames, time.frames);
  assert.equal(turns.columns, own.columns);
  assert.deepEqual(turns.values.slice(-turns.columns), own.values.slice(-own.columns));
  assert.equal(result.sampled(1, 'torques', 24).frames, time.frames);
  const torques = result.table(1, 'torques', { fps: 24 });
  assert.deepEqual(torques.values, result.sampled(1, 'torques', 24).values);
  assert.deepEqual(torques.names, human.describe().joints.map(({ name }) => name));
  assert.equal(torques.unit, 'N m');
  const nodes = result.table(1, 'node_rotations', { place: 'file' });
  assert.deepEqual(nodes.shape, [nodes.frames, nodes.names.length, 4]);
  assert.deepEqual(nodes.values, result.series(1, 'node_rotations').values); // a built-in body has no file
  result.free();
});

test('a result that is restored can be stopped', () => {
  const result = door.generate(human, smallTask);
  const failure = failureOf(() => door.restore(human, result.summaryText(), ({ evaluations }) => evaluations === 1));
  assert.equal(failure.code, 'cancelled');
  assert.match(failure.message, /stopped after 1/);
  assert.throws(() => door.restore(human, result.summaryText(), () => { throw new RangeError('enough'); }), RangeError);
  result.free();
});

test('a motion that left as BVH is read as a character and scored', () => {
  const result = door.generate(human, smallTask);
  const bvh = result.export(1, 'bvh');
  const person = door.character({ source: 'person.bvh' }, bvh);
  near(person.describe().stature_m, human.describe().stature_m, 0.05);
  person.free();
  const score = door.scoreClip('person.bvh', bvh);
  near(score.follows.worst_mm, 0, 0.01);
  assert.ok(score.score > 0 && Object.keys(score.criteria).length > 3);
  result.free();
});

test('a text without start tables is refused', async () => {
  const text = starts.toString();
  const table = text.slice(text.indexOf('table\t'));
  const row = table.indexOf('\n', table.indexOf('\n') + 1);
  const broken = {
    'no text': '',
    'remarks alone': '# Start tables',
    'a page': '<!doctype html><title>404</title>',
    'a row without its table': table.slice(table.indexOf('\n') + 1),
    'a row with a digit too few': table.slice(0, row - 1),
    'a digit that is none': `${table.slice(0, row - 1)}?`,
  };
  for (const [name, bytes] of Object.entries(broken)) {
    await assert.rejects(openDoor(wasmBytes, new TextEncoder().encode(bytes)),
      (error) => error instanceof EngineError && error.failure.code === 'parse' && /starts\.tsv/.test(error.message), name);
  }
  assert.ok(await openDoor(wasmBytes, new TextEncoder().encode(table.slice(0, row))));
});

test('what was freed is told, and may be freed again', () => {
  const own = door.character({ source: 'human' });
  const result = door.generate(own, { ...smallTask, evaluations: 8 });
  own[Symbol.dispose]();
  assert.ok(result.read().candidates.length > 0, 'a result keeps what it needs');
  for (const owned of [own, result]) {
    owned.free();
    owned.free();
  }
  for (const call of [() => own.describe(), () => door.generate(own, smallTask), () => result.read(), () => result.candidates]) {
    const { code, message } = failureOf(call);
    assert.equal(code, 'invalid_argument');
    assert.match(message, /this (character|result) was freed/);
  }
});

test('memory is given back', () => {
  const round = () => {
    const person = door.character({ source: 'human' });
    const result = door.generate(person, { ...smallTask, evaluations: 100 });
    result.read();
    result.export(1, 'svg');
    result.free();
    person.free();
  };
  const bytes = () => round() ?? door.memoryBytes;
  bytes();
  const before = bytes();
  for (let i = 0; i < 30; ++i) round();
  assert.equal(bytes(), before);
});

test('angles of anybody are scored', () => {
  const found = door.generate(human, smallTask);
  const { values, columns } = found.series(1, 'angles');
  const [, second] = found.series(1, 'time').values;
  const rows = Array.from({ length: values.length / columns }, (_, k) => [...values.slice(k * columns, (k + 1) * columns)]);
  const given = door.resultOfAngles(human, rows, 1 / second);
  const [own, again] = [found, given].map((result) => result.read().summary.candidates[0]);
  assert.equal(again.verdict, own.verdict);
  near(again.duration_s, own.duration_s, 1e-9);
  assert.throws(() => door.resultOfAngles(human, [[1, 2], [3]], 60), RangeError);
  assert.equal(failureOf(() => door.resultOfAngles(human, [[1, 2], [3, 4]], 60)).code, 'invalid_argument');
  for (const one of [found, given]) one.free();
});

test('nodes of a host are a person', () => {
  // of the built-in skeleton, whose nodes stand in their parents as described
  const nodes = human.describe().nodes.map(({ name, parent, offset, rotation }) => ({ name, parent, translation: offset, rotation }));
  const rig = door.characterOfNodes({ source: 'rig.glb' }, nodes);
  const result = door.generate(rig, smallTask);
  assert.ok(result.read().summary.candidates.length > 0);
  assert.match(failureOf(() => door.characterOfNodes({ source: 'rig.glb' }, [])).message, /1 to 2048/);
  assert.equal(failureOf(() => door.characterOfNodes({ source: 'human' }, nodes)).code, 'invalid_argument');
  for (const one of [result, rig]) one.free();
});
