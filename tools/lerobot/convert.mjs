// SPDX-License-Identifier: MIT
// Makes a LeRobot data set of a folder of shards: once through them for what there is, and once
// for each split for the motions. Only one shard is in memory at a time.
import { chmod, mkdtemp, readdir, readFile, rename, rm, writeFile } from 'node:fs/promises';
import { dirname, join, resolve } from 'node:path';
import { card } from './card.mjs';
import { Environment } from './environment.mjs';
import { frameTimes, nextFrames, resampled } from './frames.mjs';
import { shardPaths, splitOf, withShard } from './shards.mjs';
import { sentence, tasksOf } from './tasks.mjs';
import { LeRobotWriter } from './writer.mjs';

// Of an index, in the order that a data set has them.
const SPLITS = ['train', 'validation', 'test'];

// What there is in the shards: the plan's digest, and of each body its joints, series and tasks.
async function survey(paths) {
  const found = { plan: null, bodies: new Map() };
  for (const path of paths) {
    await withShard(path, (shard) => {
      found.plan ??= shard.plan;
      if (shard.plan !== found.plan) {
        throw new Error(`${path}: is of another plan than the shards before it: ${shard.plan}, not ${found.plan}`);
      }
      const tasks = tasksOf(shard);
      for (const name of shard.bodies()) {
        const table = `motions/${name}`;
        const body = found.bodies.get(name) ?? {
          joints: shard.names(table, 'joints'),
          torques: shard.has(table, 'torques'),
          angles: shard.has(table, 'angles'),
          environment: new Environment(),
          motions: 0,
        };
        const numbers = shard.columns(table, ['task']).task;
        body.motions += numbers.rows;
        new Set(numbers.values).forEach((number) => body.environment.add(tasks.get(Number(number))));
        found.bodies.set(name, body);
      }
    });
  }
  return found;
}

function chosenBody(bodies, asked) {
  const list = [...bodies].map(([name, { motions }]) => `${name} (${motions} motions)`).join(', ');
  if (bodies.size === 0) throw new Error('the shards have no motions');
  if (asked === undefined && bodies.size > 1) {
    throw new Error(`a LeRobot data set is of one body, and the shards have ${bodies.size}; --body takes one: ${list}`);
  }
  const name = asked ?? [...bodies.keys()][0];
  const body = bodies.get(name);
  if (!body) throw new Error(`--body is '${name}'; the shards have ${list}`);
  if (!body.angles) throw new Error(`${name} has no angles: the plan's series must have them`);
  return { name, ...body };
}

function featuresOf(body) {
  const numbers = (name, names) => ({ name, dtype: 'float32', width: names.length, names });
  const one = (name, dtype) => ({ name, dtype, width: 1, names: null });
  const environment = body.environment.names();
  return [
    numbers('observation.state', body.joints),
    numbers('action', body.joints),
    ...(body.torques ? [numbers('observation.torque', body.joints)] : []),
    ...(environment.length > 0 ? [numbers('observation.environment_state', environment)] : []),
    one('timestamp', 'float32'),
    ...['frame_index', 'episode_index', 'index', 'task_index'].map((name) => one(name, 'int64')),
    one('next.done', 'bool'),
  ];
}

// The numbers of a motion that are its own.
function episodeColumns(body, motion, times) {
  const width = body.joints.length;
  const state = resampled(motion.angles, width, motion.duration, times);
  const columns = { 'observation.state': state, action: nextFrames(state, width), timestamp: Float32Array.from(times) };
  if (body.torques) {
    columns['observation.torque'] = resampled(motion.torques, width, motion.duration, times);
  }
  const environment = body.environment.values(motion.task);
  columns['observation.environment_state'] = Float32Array.from(times.flatMap(() => environment));
  return columns;
}

// Adds the motions of a shard that `takes` a task; `left` counts those that are not wanted at all.
async function addShard(shard, body, { writer, settings, takes, left }) {
  const table = `motions/${body.name}`;
  if (!shard.bodies().includes(body.name)) return;
  const tasks = tasksOf(shard);
  const series = ['angles', ...(body.torques ? ['torques'] : [])];
  const columns = shard.columns(table, ['task', 'rank', 'verdict', 'duration_s', ...series]);
  for (let row = 0; row < columns.task.rows; ++row) {
    const number = columns.task.at(row);
    const task = tasks.get(number);
    const verdict = columns.verdict.word(row);
    if (!takes(number)) continue;
    if (!task.reached) ++left.unreached;
    else if (!settings.verdicts.includes(verdict)) ++left.verdict;
    else {
      const duration = columns.duration_s.at(row);
      const times = frameTimes(duration, settings.fps);
      const motion = { task, duration };
      for (const name of series) motion[name] = columns[name].block(row);
      const source = { task: number, rank: columns.rank.at(row), person: task.person, verdict };
      await writer.add(episodeColumns(body, motion, times), { rows: times.length, task: sentence(task), source });
    }
  }
}

// `split` gives that of a task.
async function addAll(paths, body, split, writer, settings) {
  const left = { unreached: 0, verdict: 0 };
  const splits = [];
  for (const name of settings.split ? SPLITS : SPLITS.slice(0, 1)) {
    const first = writer.episodes;
    const takes = (task) => split(task) === name;
    for (const path of paths) {
      await withShard(path, (shard) => addShard(shard, body, { writer, settings, takes, left }));
    }
    if (writer.episodes > first) splits.push({ name, first, last: writer.episodes });
  }
  if (writer.episodes === 0) {
    const verdicts = settings.verdicts.join(', ');
    throw new Error(
      `no motion is left: ${left.unreached} do not reach their goals, and ${left.verdict} are none of ${verdicts}`,
    );
  }
  return { splits, left };
}

async function refuseUsed(out) {
  const there = await readdir(out).catch((error) => (error.code === 'ENOENT' ? [] : Promise.reject(error)));
  if (there.length > 0) throw new Error(`${out}: is there and not empty; give a new folder`);
}

// What a person called the data set, where its folder has the plan.
async function nameAndLicence(folder) {
  const text = await readFile(join(folder, 'plan.json'), 'utf8').catch(() => '{}');
  const { name, licence } = JSON.parse(text);
  return { name, licence };
}

// settings: fps, split, body, verdicts, fileMegabytes. Gives the counts of what was written; the
// folder `out` is there whole or not at all.
export async function convert(folder, out, settings) {
  await refuseUsed(out);
  const paths = await shardPaths(folder);
  const { plan, bodies } = await survey(paths);
  const body = chosenBody(bodies, settings.body);
  const split = settings.split ? await splitOf(folder, plan, settings.split) : () => SPLITS[0];
  const part = await mkdtemp(join(dirname(resolve(out)), '.lerobot-part-'));
  try {
    const fileBytes = settings.fileMegabytes * 2 ** 20;
    const writer = await LeRobotWriter.create(part, featuresOf(body), { fileBytes });
    const { splits, left } = await addAll(paths, body, split, writer, settings);
    await writer.finish();
    await writer.writeInfo({ body: body.name, fps: settings.fps, fileMegabytes: settings.fileMegabytes, splits });
    const made = { body: body.name, plan, shards: paths.length, splits, left, writer, settings };
    await writeFile(join(part, 'README.md'), card({ ...made, ...(await nameAndLicence(folder)) }));
    await chmod(part, 0o777 & ~process.umask()); // mkdtemp makes it its owner's alone
    await rename(part, resolve(out));
    return made;
  } catch (error) {
    await rm(part, { recursive: true, force: true });
    throw error;
  }
}
