// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { createEngine, EngineError } from '../dist/engine.js';
import { NodeWorker } from '../dist/node.js';
import { openedDoor, sleep, smallTask, starts, wasmBytes } from './support.mjs';

const wasm = await WebAssembly.compile(wasmBytes);
class CountedWorker extends NodeWorker {
  static started = 0;
  static ended = 0;

  constructor() {
    super(new URL('../dist/worker.js', import.meta.url));
    ++CountedWorker.started;
  }

  terminate() {
    ++CountedWorker.ended;
    super.terminate();
  }
}
const createWorker = () => new CountedWorker();
const engine = await createEngine({ wasm, starts, createWorker });
after(() => engine.dispose());
const human = await engine.open({ source: 'human' });
const longTask = { ...smallTask, evaluations: 500000 };
const summaryLess = ({ elapsed_ms: _elapsed, ...summary }) => summary;

test('a search in a worker is the search of the door', async () => {
  const progress = [];
  const there = await engine.generate(human, smallTask, { onProgress: (told) => void progress.push(told) });
  const door = await openedDoor();
  const result = door.generate(door.character({ source: 'human' }), smallTask);
  const here = result.read();
  assert.deepEqual(summaryLess(there.summary), summaryLess(here.summary));
  assert.deepEqual(there.candidates, here.candidates);
  assert.ok(there.engine_ms > 0);
  assert.ok(progress.length > 0);
});

test('an abort ends the search at once, and the next one works', async () => {
  const controller = new AbortController();
  const ended = CountedWorker.ended;
  let asked = 0;
  const search = engine.generate(human, longTask, {
    signal: controller.signal,
    onProgress: () => {
      asked ||= performance.now();
      controller.abort();
    },
  });
  await assert.rejects(search, { name: 'AbortError' });
  assert.ok(performance.now() - asked < 5000, 'the search alone takes minutes');
  assert.equal(CountedWorker.ended, ended + 1);
  const next = await engine.generate(human, smallTask);
  assert.equal(next.summary.status, 'reached');
});

test('a search that waits is taken out by its abort, and the one that runs goes on', async () => {
  const controller = new AbortController();
  const first = engine.generate(human, smallTask);
  const second = engine.generate(human, longTask, { signal: controller.signal });
  controller.abort();
  await assert.rejects(second, { name: 'AbortError' });
  assert.equal((await first).summary.status, 'reached');
  await assert.rejects(engine.generate(human, smallTask, { signal: AbortSignal.abort() }), { name: 'AbortError' });
});

test('of previews that wait the newest alone is answered', async () => {
  const goals = (y) => [{ effector: 'right_hand', position_m: [-0.25, y, 0.5] }];
  const previews = [0.5, 0.6, 0.7, 0.8].map((y) => engine.preview(human, { ...smallTask, goals: goals(y) }));
  const answers = await Promise.all(previews);
  assert.deepEqual(answers.map((answer) => answer !== undefined), [true, false, false, true]);
  assert.equal(answers[3].summary.candidates[0].reached[0].goal_m[1], 0.8);
});

test('a preview does not wait for a search', async () => {
  const controller = new AbortController();
  const search = engine.generate(human, longTask, { signal: controller.signal });
  search.catch(() => {});
  const preview = await engine.preview(human, { ...smallTask, evaluations: 100 });
  assert.equal(preview.summary.status, 'reached');
  controller.abort();
  await assert.rejects(search, { name: 'AbortError' });
});

test('a summary is enough to replay, mirror, restore and export', async () => {
  const { summary, candidates } = await engine.generate(human, smallTask);
  const squat = candidates[0].parameters.find((parameter) => parameter.name === 'squat_deg').value;
  const edited = await engine.replay(human, summary, 1, [`squat_deg=${squat > 40 ? 20 : 60}`]);
  assert.equal(edited.candidates.length, 1);
  const again = await engine.replay(human, summary, 1, []);
  assert.deepEqual(again.candidates[0].series, candidates[0].series);
  const restored = await engine.restore(human, summary);
  assert.deepEqual(restored.candidates.map(({ series }) => series), candidates.map(({ series }) => series));
  const mirrored = await engine.mirror(human, summary);
  assert.equal(mirrored.summary.candidates[0].reached[0].effector, 'left_hand');
  const bvh = await engine.export(human, summary, 1, 'bvh');
  assert.match(new TextDecoder().decode(bvh), /^HIERARCHY/);
  const score = await engine.scoreClip('a.bvh', bvh);
  assert.equal(typeof score, 'object');
});

test('a summary is enough to edit one action of a piece of work', async () => {
  const reach = (position_m) => ({ goals: [{ effector: 'right_hand', position_m }] });
  const { summary } = await engine.generate(human, {
    version: 2, seed: 3, evaluations: 64, candidates: 1, actions: [reach([-0.2, 1.0, 0.5]), reach([-0.3, 0.7, 0.45])],
  });
  let reports = 0;
  const again = await engine.replayWork(human, summary, 1, { again: [2], seed: 5 }, { onProgress: () => reports++ });
  assert.ok(reports > 0);
  assert.deepEqual(again.summary.candidates[0].motions[0], summary.candidates[0].motions[0]);
  assert.ok(again.summary.candidates[0].actions[1].reached[0].error_mm < 1);
});

test('a result of many candidates that is restored ends at once when it is aborted', async () => {
  const { summary } = await engine.generate(human, smallTask);
  const many = { ...summary, candidates: Array.from({ length: 1000 }, () => summary.candidates[0]) };
  const controller = new AbortController();
  const restored = engine.restore(human, many, { signal: controller.signal, onProgress: () => controller.abort() });
  const begin = performance.now();
  await assert.rejects(restored, { name: 'AbortError' });
  assert.ok(performance.now() - begin < 5000);
  const more = { ...many, candidates: [...many.candidates, summary.candidates[0]] };
  await assert.rejects(engine.restore(human, more), /1001 candidates; up to 1000/);
  const nodes = await engine.sampled(human, summary, 1, ['time', 'node_rotations'], 30);
  assert.equal(nodes.node_rotations.frames, nodes.time.frames);
});

test('failures have a code and a sentence, and do not stop the engine', async () => {
  const goals = [{ effector: 'tail', position_m: [0, 1, 0] }];
  const failure = await engine.generate(human, { ...smallTask, goals }).catch((error) => error);
  assert.ok(failure instanceof EngineError);
  assert.equal(failure.failure.code, 'not_found');
  assert.match(failure.failure.message, /tail/);
  await assert.rejects(engine.open({ source: 'dragon' }), { name: 'EngineError' });
  assert.equal((await engine.generate(human, smallTask)).summary.status, 'reached');
});

test('a file beyond all memory is refused, and its memory given back', async () => {
  const ended = CountedWorker.ended;
  await assert.rejects(engine.open({ source: 'a.bvh' }, new Uint8Array(1.2e9)),
    (error) => error.failure.code === 'out_of_memory');
  assert.equal(CountedWorker.ended, ended + 1);
  await engine.open({ source: 'human' });
});

test('repeated searches take no more memory', async () => {
  for (let k = 0; k < 3; ++k) await engine.generate(human, { ...smallTask, seed: k });
  const { search, quick } = await engine.memory();
  assert.ok(search > 1e6 && quick > 1e6);
  for (let k = 0; k < 5; ++k) await engine.generate(human, { ...smallTask, seed: k });
  assert.equal((await engine.memory()).search, search);
});

test('characters are told apart, and one that was closed can be asked for again', async () => {
  const small = await engine.open({ source: 'human', stature_m: 1.5 });
  const tall = await engine.open({ source: 'human', stature_m: 1.9 });
  assert.ok(small.description.stature_m < tall.description.stature_m);
  const first = await engine.generate(small, smallTask);
  engine.close(small);
  const second = await engine.generate(small, smallTask);
  assert.deepEqual(second.candidates, first.candidates);
  engine.close(small);
  engine.close(tall);
});

test('a task that no message can carry is refused, and the engine goes on', async () => {
  await assert.rejects(engine.generate(human, { ...smallTask, seed: () => 1 }), { name: 'DataCloneError' });
  assert.equal((await engine.generate(human, smallTask)).summary.status, 'reached');
});

test('a worker that dies fails its call, and another takes its place', async () => {
  const workers = [];
  const mortal = await createEngine({ wasm, starts, createWorker: () => workers[workers.push(new CountedWorker()) - 1] });
  const person = await mortal.open({ source: 'human' });
  const search = mortal.generate(person, longTask);
  await sleep(50);
  workers[0].onerror({ message: 'it died', preventDefault() {} });
  await assert.rejects(search, (error) => error.failure.code === 'fault');
  assert.equal((await mortal.generate(person, smallTask)).summary.status, 'reached');
  mortal.dispose();
});

test('an engine that is closed refuses what waits and what comes', async () => {
  const brief = await createEngine({ wasm, starts, createWorker });
  const person = await brief.open({ source: 'human' });
  const search = brief.generate(person, longTask);
  brief.dispose();
  await assert.rejects(search, (error) => error.failure.code === 'cancelled');
  await assert.rejects(brief.generate(person, smallTask), (error) => error.failure.code === 'cancelled');
});

test('a module that cannot be fetched is told', async () => {
  await assert.rejects(createEngine({ moduleUrl: 'data:text/plain,none', starts, createWorker }),
    (error) => error.failure.code === 'unsupported');
  await assert.rejects(createEngine({ moduleUrl: 'http://127.0.0.1:1/shigusa.wasm', starts, createWorker }),
    (error) => error.failure.code === 'io');
});

test('a page in place of the module is told', async () => {
  await assert.rejects(createEngine({ moduleUrl: 'data:text/html,<!doctype html>', starts, createWorker }),
    (error) => error.failure.code === 'io' && /a page came instead/.test(error.message));
});

test('without its start tables no engine starts, and the address that should have them is told', async () => {
  const { started, ended } = CountedWorker;
  const refused = (settings, check) => // an engine that starts all the same would keep this process alive
    assert.rejects(createEngine({ wasm, createWorker, ...settings }).then((made) => made.dispose()), check);
  // a host without the file, one that answers with its page, and one with an empty file
  for (const startsUrl of ['http://127.0.0.1:1/starts.tsv', 'data:text/html,<!doctype html>', 'data:text/plain,']) {
    await refused({ startsUrl }, ({ name, failure }) => {
      assert.deepEqual([name, failure.code], ['EngineError', 'io']);
      assert.ok(failure.message.startsWith(`cannot load ${startsUrl}: `), failure.message);
      return true;
    });
  }
  await refused({ starts: starts.subarray(0, starts.length - 5) }, ({ failure }) => failure.code === 'parse');
  assert.equal(CountedWorker.ended - ended, CountedWorker.started - started, 'no worker is left');
});

test('start tables come from their address', async () => {
  const startsUrl = `data:text/tab-separated-values;base64,${starts.toString('base64')}`;
  const fetching = await createEngine({ wasm, startsUrl, createWorker });
  const person = await fetching.open({ source: 'human' });
  const there = await fetching.generate(person, smallTask);
  const here = await engine.generate(human, smallTask);
  assert.deepEqual(summaryLess(there.summary), summaryLess(here.summary));
  fetching.dispose();
});

test('an engine finds its files and its workers in Node.js, which ends without its end', async () => {
  const own = await createEngine(); // and nobody disposes of it
  const person = await own.open({ source: 'human' });
  const there = await own.generate(person, smallTask);
  const here = await engine.generate(human, smallTask);
  assert.deepEqual(summaryLess(there.summary), summaryLess(here.summary));
});

test('a file that is not there is told', async () => {
  const none = new URL('none', import.meta.url);
  for (const settings of [{ moduleUrl: none, starts }, { wasm, startsUrl: String(none) }]) {
    await assert.rejects(createEngine({ ...settings, createWorker }),
      ({ failure }) => failure.code === 'io' && failure.message.startsWith(`cannot load ${none}: ENOENT`));
  }
});

test('a Node.js that is too old to be asked is told', async () => {
  const asked = Object.getOwnPropertyDescriptor(process, 'getBuiltinModule');
  delete process.getBuiltinModule;
  try {
    await assert.rejects(createEngine({ wasm, createWorker }),
      ({ failure }) => failure.code === 'io' && /starts\.tsv: .*Node\.js, from 20\.16 on/.test(failure.message));
    await assert.rejects(createEngine({ wasm, starts }),
      ({ failure }) => failure.code === 'unsupported' && /Node\.js has them from 20\.16 on/.test(failure.message));
  } finally {
    Object.defineProperty(process, 'getBuiltinModule', asked);
  }
});
