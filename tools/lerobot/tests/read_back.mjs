// SPDX-License-Identifier: MIT
// read_back.mjs SHARDS LEROBOT [BY]: reads a LeRobot data set by DuckDB, sets it beside the shards as
// h5wasm reads them, and prints a line for each promise that is broken, or at the end the counts. BY is
// what its splits are by, person or region; without it there is train alone.
import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { DuckDBInstance } from '@duckdb/node-api';
import { File, ready } from 'h5wasm/node';

const [shards, folder, by] = process.argv.slice(2);
const info = JSON.parse(await readFile(join(folder, 'meta/info.json'), 'utf8'));
const stats = JSON.parse(await readFile(join(folder, 'meta/stats.json'), 'utf8'));
const connection = await (await DuckDBInstance.create()).connect();
const rows = async (sql) => (await connection.runAndReadAll(sql)).getRowObjectsJson();
const of = (below) => `read_parquet('${join(folder, below)}')`;
const frames = await rows(`SELECT * FROM ${of('data/*/*.parquet')} ORDER BY index`);
const episodes = await rows(`SELECT * FROM ${of('meta/episodes/*/*.parquet')} ORDER BY episode_index`);
const tasks = await rows(`SELECT * FROM ${of('meta/tasks.parquet')} ORDER BY task_index`);

const failures = new Set();
const expect = (holds, text) => {
  if (!holds) failures.add(text);
};
const near = (a, b, most) => Math.abs(a - b) <= most;
const same = (a, b) => a.length === b.length && a.every((value, i) => value === b[i]);

// The counts, shapes and paths of info.json are those of the files.
expect(info.codebase_version === 'v3.0', 'the version is not v3.0');
expect(info.total_frames === frames.length, `${info.total_frames} frames are told, ${frames.length} are there`);
expect(info.total_episodes === episodes.length, 'total_episodes is not the number of episodes');
expect(info.total_tasks === tasks.length, 'total_tasks is not the number of tasks');
expect(same(Object.keys(frames[0]), Object.keys(info.features)), 'features are not the columns');
for (const [name, { shape, names }] of Object.entries(info.features)) {
  const width = Array.isArray(frames[0][name]) ? frames[0][name].length : 1;
  expect(shape.length === 1 && shape[0] === width, `${name} has not the shape that is told`);
  expect(names === null || names.length === width, `${name} has not as many names as numbers`);
}
const ends = Object.values(info.splits).map((range) => range.split(':').map(Number));
expect(ends[0][0] === 0 && ends.at(-1)[1] === episodes.length, 'the splits do not take all episodes');
expect(ends.every(([first], k) => k === 0 || first === ends[k - 1][1]), 'the splits leave a gap');
await ready;
if (by) {
  const index = new File(join(shards, 'index.h5'), 'r');
  const column = index.get(`splits/by_${by}`);
  const words = column.attrs.words.value;
  const splits = new Map([...index.get('splits/task').value].map((task, row) => [`${task}`, words[column.value[row]]]));
  Object.keys(info.splits).forEach((name, k) => {
    const own = episodes.slice(...ends[k]).every((one) => splits.get(`${one['shigusa/task']}`) === name);
    expect(own, `the split ${name} has others' motions`);
  });
  index.close();
} else {
  expect(same(Object.keys(info.splits), ['train']), 'there are other splits than train');
}
const pathOf = (chunk, file) =>
  info.data_path
    .replace('{chunk_index:03d}', String(chunk).padStart(3, '0'))
    .replace('{file_index:03d}', String(file).padStart(3, '0'));
const files = (await readdir(folder, { recursive: true })).filter((name) => /^data\/.*parquet$/.test(name)).sort();
const told = new Set(episodes.map((one) => pathOf(one['data/chunk_index'], one['data/file_index'])));
expect(same(files, [...told].sort()), 'the data files are not those that the episodes name');

// pandas takes the sentence as the index, by which LeRobot looks tasks up.
const metadata = await rows(
  `SELECT decode(key) AS key, decode(value) AS value FROM parquet_kv_metadata('${join(folder, 'meta/tasks.parquet')}')`,
);
const pandas = JSON.parse(metadata.find(({ key }) => key === 'pandas')?.value ?? '{}');
expect(same(pandas.index_columns ?? [], ['task']), "the tasks' index for pandas is not 'task'");
expect(same(pandas.columns.map(({ name }) => name), Object.keys(tasks[0])), 'pandas is told of other columns');

// Motions of the shards by task and rank, of the table that the data set is of.
const motions = new Map();
let joints;
for (const name of (await readdir(shards)).filter((file) => /^shard-.*\.h5$/.test(file)).sort()) {
  const file = new File(join(shards, name), 'r');
  if (file.get('motions').keys().includes(info.robot_type)) {
    const table = file.get(`motions/${info.robot_type}`);
    const column = (key) => (table.keys().includes(key) ? table.get(key) : null);
    joints = table.attrs.joints.value;
    const goals = { task: file.get('goals/task').value, at: file.get('goals/position_m').value };
    const [task, rank, duration, angles, torques] = ['task', 'rank', 'duration_s', 'angles', 'torques'].map(
      (key) => column(key)?.value,
    );
    const size = 61 * joints.length;
    task.forEach((number, row) => {
      const goal = goals.task.indexOf(number);
      motions.set(`${number} ${rank[row]}`, {
        duration: duration[row],
        angles: angles.slice(row * size, (row + 1) * size),
        torques: torques?.slice(row * size, (row + 1) * size),
        goal: goals.at.slice(3 * goal, 3 * goal + 3),
      });
    });
  }
  file.close();
}
expect(same(info.features['observation.state'].names, joints), "the states are not those of the shards' joints");

// A series at a time, by another formula than the converter's.
function at(series, time, duration) {
  const step = duration / 60;
  const before = Math.min(59, Math.max(0, Math.floor(time / step)));
  const after = (time - before * step) / step;
  return joints.map(
    (_, i) => (1 - after) * series[before * joints.length + i] + after * series[(before + 1) * joints.length + i],
  );
}
const closeTo = (numbers, others) => numbers.every((value, i) => near(value, others[i], 1e-5 + 1e-6 * Math.abs(value)));

episodes.forEach((episode, number) => {
  const first = Number(episode.dataset_from_index);
  const own = frames.slice(first, Number(episode.dataset_to_index));
  const motion = motions.get(`${episode['shigusa/task']} ${episode['shigusa/rank']}`);
  if (!motion) return expect(false, `episode ${number}: no motion of the shards`);
  expect(Number(episode.length) === own.length, `episode ${number} has another length`);
  expect(Number(episode.episode_index) === number, `episode ${number} has another number`);
  const late = (own.length - 1) / info.fps - motion.duration;
  expect(late >= -1e-6 && late < 1 / info.fps, `episode ${number} ends ${late} s after its motion`);
  const width = joints.length;
  const state = (frame) => frame['observation.state'];
  expect(same(state(own[0]), [...motion.angles.subarray(0, width)]), `episode ${number} begins otherwise`);
  expect(same(state(own.at(-1)), [...motion.angles.subarray(60 * width)]), `episode ${number} ends otherwise`);
  own.forEach((frame, k) => {
    expect(near(frame.timestamp, k / info.fps, 1e-6), `episode ${number}: a timestamp is off`);
    expect(Number(frame.index) === first + k && Number(frame.frame_index) === k, `episode ${number}: an index is off`);
    expect(Number(frame.episode_index) === number, `episode ${number}: a frame is of another`);
    expect(frame['next.done'] === (k === own.length - 1), `episode ${number}: done in another frame`);
    expect(same(frame.action, state(own[Math.min(k + 1, own.length - 1)])), `episode ${number}: an action is off`);
    expect(tasks[Number(frame.task_index)].task === episode.tasks[0], `episode ${number}: another task's sentence`);
    const time = Math.min(k / info.fps, motion.duration);
    expect(closeTo(state(frame), at(motion.angles, time, motion.duration)), `episode ${number}: a state is off`);
    if (motion.torques) {
      const torques = at(motion.torques, time, motion.duration);
      expect(closeTo(frame['observation.torque'], torques), `episode ${number}: a torque is off`);
    }
  });
  const words = [...motion.goal].map((value) => value.toFixed(2).replace(/^-0\.00$/, '0.00')).join(', ');
  expect(episode.tasks[0].startsWith(`reach (${words}) m with the `), `episode ${number}: '${episode.tasks[0]}'`);
  const names = info.features['observation.environment_state'].names;
  const environment = own[0]['observation.environment_state'];
  const asked = names.findIndex((name, i) => name.endsWith('.asked') && environment[i] === 1);
  const goal = asked < 0 ? names.findIndex((name) => name.endsWith('.x_m')) : asked + 1;
  const given = environment.slice(goal, goal + 3);
  expect(same(given, [...Float32Array.from(motion.goal)]), `episode ${number}: another goal`);
});

// The statistics are those that DuckDB computes of the files.
for (const name of ['observation.state', 'action', 'timestamp']) {
  const numbers = info.features[name].shape[0] === 1 ? `["${name}"]` : `"${name}"`;
  const found = await rows(
    `SELECT min(x) AS min, max(x) AS max, avg(x) AS mean, stddev_pop(x) AS std, quantile_cont(x, 0.1) AS q10 FROM (
       SELECT unnest(${numbers})::DOUBLE AS x, generate_subscripts(${numbers}, 1) AS i FROM ${of('data/*/*.parquet')})
     GROUP BY i ORDER BY i`,
  );
  for (const key of ['min', 'max', 'mean', 'std', 'q10']) {
    const off = found.some((row, i) => !near(row[key], stats[name][key][i], 1e-9 + 1e-7 * Math.abs(row[key])));
    expect(!off, `stats.json: ${key} of ${name} is off`);
  }
  expect(stats[name].count[0] === frames.length, `stats.json: another count of ${name}`);
  const own = episodes[0][`stats/${name}/max`][0];
  const most = frames.slice(0, Number(episodes[0].length)).map((frame) => [frame[name]].flat()[0]);
  expect(near(own, Math.max(...most), 1e-9), `the first episode's statistics of ${name} are off`);
}

for (const failure of failures) console.log(failure);
if (failures.size === 0) console.log(episodes.length, frames.length, tasks.length, files.length, joints.join(' '));
process.exitCode = failures.size > 0 ? 1 : 0;
