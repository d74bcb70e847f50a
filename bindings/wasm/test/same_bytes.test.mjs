// SPDX-License-Identifier: MIT
// The same task and seed give the same bytes here as from the native program, whose path is in SHIGUSA_BINARY.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { access, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { after, test } from 'node:test';
import { openedDoor } from './support.mjs';

const binary = process.env.SHIGUSA_BINARY;
const folder = await mkdtemp(join(tmpdir(), 'shigusa-'));
after(() => rm(folder, { recursive: true }));

const door = await openedDoor();
const evaluations = 1000;
const atTheFeet = [{ effector: 'right_hand', position_m: [-0.05, 0.1, 0.3] }];
const lowFrontLeft = [{ effector: 'right_hand', position_m: [0.25, 0.55, 0.5] }];

const tasks = {
  half_body: { character: 'half_body', preset: 'paper', goals: lowFrontLeft },
  full_body: { character: 'full_body', preset: 'paper', goals: lowFrontLeft },
  default_criteria: { character: 'half_body', preset: 'paper', criteria: 'default', goals: atTheFeet },
  flat: { character: 'human', preset: 'flat', goals: atTheFeet },
  layers: { character: 'full_body', preset: 'layers', goals: lowFrontLeft },
  human: { character: 'full_body', preset: 'human', goals: lowFrontLeft },
};

const tests = fileURLToPath(new URL('../../../tests/fuzz', import.meta.url));
const shared = fileURLToPath(new URL('../../../../shared/characters', import.meta.url));
const robots = [
  join(tests, 'urdf_corpus/small_robot.urdf'),
  join(tests, 'mjcf_corpus/maker.xml'),
  join(shared, 'unitree_ros__g1_29dof.urdf'),
  join(shared, 'icub-models__model.urdf'),
  join(shared, 'example-robot-data__romeo.urdf'),
  join(shared, 'example-robot-data__simple_humanoid.urdf'),
  join(shared, 'human-gazebo__humanSubject01_66dof.urdf'),
  join(shared, 'mujoco__humanoid.xml'),
  join(shared, 'dm_control__humanoid_CMU.xml'),
];

/** A summary without what tells how it was computed, and where its files are. */
function comparable(text) {
  const summary = JSON.parse(text);
  for (const key of ['elapsed_ms', 'threads', 'simd', 'character_file']) delete summary[key];
  JSON.stringify(summary, (key, value) => {
    // a limb library on disk would spare the search of its cells
    if (value !== null && typeof value === 'object') delete value.cells_searched;
    return value;
  });
  for (const candidate of summary.candidates) {
    for (const key of ['files', 'sha256', 'fps', 'file_frames', 'read_back']) delete candidate[key];
  }
  return summary;
}

/** Runs a task in both, and compares summaries and files; with `bytes` it is for the robot of a file of that name. */
async function compare(name, task, formats, bytes) {
  const text = JSON.stringify({ version: 1, ...task, seed: 1, evaluations });
  const file = join(folder, `${name}.json`);
  const out = join(folder, `${name}.out`);
  await writeFile(file, text);
  const ran = spawnSync(binary, ['reach', file, ...(bytes ? ['--character', name] : []), '--out', out, '--formats', formats.join(',')], {
    cwd: folder, encoding: 'utf8', env: { ...process.env, SHIGUSA_CACHE: join(folder, 'cache') },
  });
  assert.ok([0, 3].includes(ran.status), ran.stderr); // 3: no motion that the body could make

  const begin = performance.now();
  const character = bytes ? door.character({ source: name }, bytes) : null;
  const result = door.generate(character, text);
  console.log(`# ${name}: ${Math.round(performance.now() - begin)} ms here, native ` +
    `${Math.round(JSON.parse(await readFile(join(out, 'summary.json'), 'utf8')).elapsed_ms)} ms`);
  const native = comparable(await readFile(join(out, 'summary.json'), 'utf8'));
  const here = comparable(result.summaryText());
  // the text tells numbers by their shortest digits, so equal values are equal bits
  assert.deepEqual(here, native);
  for (let candidate = 1; candidate <= result.candidates; ++candidate) {
    for (const format of formats) {
      const written = await readFile(join(out, `candidate-${candidate}.${format}`));
      assert.ok(written.equals(result.export(candidate, format)), `candidate-${candidate}.${format} differs`);
    }
  }
  result.free();
  character?.free();
}

const skip = binary === undefined && 'no SHIGUSA_BINARY';
for (const [name, task] of Object.entries(tasks)) {
  test(`${name} has the bytes of the native program`, { skip }, () => compare(name, task, ['bvh', 'csv']));
}

for (const path of robots) {
  const name = basename(path);
  const there = await access(path).then(() => true, () => false);
  test(`the robot ${name} has the bytes of the native program`, { skip: skip || (!there && 'not here') }, async () => {
    const bytes = await readFile(path);
    await writeFile(join(folder, name), bytes);
    const task = { preset: 'flat', goals: [{ effector: 'right_hand', position_m: [-0.2, 0.5, 0.3] }] };
    await compare(name, task, ['csv'], bytes);
  });
}
