// SPDX-License-Identifier: MIT
// Writes a LeRobot v3 data set, episode after episode.
import { mkdir, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { ARRAY, BIGINT, BOOLEAN, DOUBLE, FLOAT, LIST, VARCHAR, arrayValue, listValue } from '@duckdb/node-api';
import { connect, ParquetFile, quantilesOf } from './parquet.mjs';
import { merged, statisticsOf } from './statistics.mjs';

const FILES_A_FOLDER = 1000;
const KINDS = {
  float32: { type: FLOAT, bytes: 4, value: (number) => number },
  int64: { type: BIGINT, bytes: 8, value: (number) => BigInt(number) },
  bool: { type: BOOLEAN, bytes: 1, value: (number) => number !== 0 },
};
const STATISTICS = ['min', 'max', 'mean', 'std'];
const QUANTILES = { q01: 0.01, q10: 0.1, q50: 0.5, q90: 0.9, q99: 0.99 };
const EPISODE_COLUMNS = [
  ['episode_index', BIGINT],
  ['tasks', LIST(VARCHAR)],
  ['length', BIGINT],
  ['data/chunk_index', BIGINT],
  ['data/file_index', BIGINT],
  ['dataset_from_index', BIGINT],
  ['dataset_to_index', BIGINT],
  ['meta/episodes/chunk_index', BIGINT],
  ['meta/episodes/file_index', BIGINT],
];
// Where an episode comes from, which LeRobot leaves alone.
const SOURCE_COLUMNS = [
  ['shigusa/task', BIGINT],
  ['shigusa/rank', BIGINT],
  ['shigusa/person', BIGINT],
  ['shigusa/verdict', VARCHAR],
];

const padded = (number) => String(number).padStart(3, '0');
const pathOf = ({ chunk, file }) => `chunk-${padded(chunk)}/file-${padded(file)}.parquet`;
const columnType = ({ dtype, width }) => (width === 1 ? KINDS[dtype].type : ARRAY(KINDS[dtype].type, width));
const rowBytes = (features) => features.reduce((sum, { dtype, width }) => sum + KINDS[dtype].bytes * width, 0);

// Parquet files below one folder, a new one where the last would become too large.
class FileSeries {
  #open = null;
  place = { chunk: 0, file: 0 };
  constructor(connection, folder, columns, mostRows) {
    Object.assign(this, { connection, folder, columns, mostRows });
  }
  // Makes sure that so many rows come into one file.
  async room(rows) {
    if (this.#open && this.#open.rows + rows > this.mostRows) {
      await this.end();
      const full = this.place.file === FILES_A_FOLDER - 1;
      this.place = full ? { chunk: this.place.chunk + 1, file: 0 } : { ...this.place, file: this.place.file + 1 };
    }
    this.#open ??= await ParquetFile.create(this.connection, this.columns);
  }
  add(values) {
    this.#open.add(values);
  }
  async end() {
    await this.#open?.write(join(this.folder, pathOf(this.place)));
    this.#open = null;
  }
}

// What pandas needs to know that a column is the table's index.
function pandasIndex(index, columns) {
  return JSON.stringify({
    index_columns: [index],
    column_indexes: [],
    columns: columns.map(([name, kind]) => ({
      name,
      field_name: name,
      pandas_type: kind === 'object' ? 'unicode' : kind,
      numpy_type: kind,
      metadata: null,
    })),
    creator: { library: 'shigusa', version: '1' },
    pandas_version: '1.5.3',
  });
}

export class LeRobotWriter {
  #tasks = new Map(); // text → number
  #statistics = {};
  episodes = 0;
  frames = 0;

  // features: [{ name, dtype, width, names }], in the order of the columns.
  static async create(folder, features, { fileBytes }) {
    const writer = new LeRobotWriter();
    const connection = await connect();
    const statistics = features.flatMap(({ name, width }) => [
      ...STATISTICS.map((one) => [`stats/${name}/${one}`, ARRAY(DOUBLE, width)]),
      [`stats/${name}/count`, LIST(BIGINT)],
    ]);
    const series = (below, columns, bytes) =>
      new FileSeries(connection, join(folder, below), columns, Math.floor(fileBytes / bytes));
    const columns = features.map((feature) => [feature.name, columnType(feature)]);
    const numbers = features.reduce((sum, { width }) => sum + 8 * STATISTICS.length * width, 0);
    return Object.assign(writer, {
      folder,
      features,
      connection,
      data: series('data', columns, rowBytes(features)),
      meta: series('meta/episodes', [...EPISODE_COLUMNS, ...SOURCE_COLUMNS, ...statistics], numbers),
    });
  }

  get tasks() {
    return this.#tasks.size;
  }

  // columns: numbers (rows × width) of the features that are an episode's own; the others count.
  async add(columns, { rows, task, source }) {
    if (!this.#tasks.has(task)) this.#tasks.set(task, this.#tasks.size);
    const every = (value) => Array.from({ length: rows }, (_, k) => value(k));
    const all = {
      ...columns,
      frame_index: every((k) => k),
      episode_index: every(() => this.episodes),
      index: every((k) => this.frames + k),
      task_index: every(() => this.#tasks.get(task)),
      'next.done': every((k) => (k === rows - 1 ? 1 : 0)),
    };
    await this.data.room(rows);
    for (let row = 0; row < rows; ++row) {
      this.data.add(
        this.features.map(({ name, dtype, width }) =>
          width === 1
            ? KINDS[dtype].value(all[name][row])
            : arrayValue(all[name].subarray(row * width, (row + 1) * width)),
        ),
      );
    }
    await this.#addEpisode(all, rows, task, source);
    ++this.episodes;
    this.frames += rows;
  }

  async #addEpisode(all, rows, task, source) {
    await this.meta.room(1);
    const numbers = [
      this.data.place.chunk,
      this.data.place.file,
      this.frames,
      this.frames + rows,
      this.meta.place.chunk,
      this.meta.place.file,
    ];
    const statistics = this.features.flatMap(({ name, width }) => {
      const own = statisticsOf(all[name], width);
      this.#statistics[name] = merged(this.#statistics[name], own);
      return [...STATISTICS.map((one) => arrayValue(own[one])), listValue([BigInt(own.count)])];
    });
    this.meta.add([
      BigInt(this.episodes),
      listValue([task]),
      BigInt(rows),
      ...numbers.map(BigInt),
      BigInt(source.task),
      BigInt(source.rank),
      BigInt(source.person),
      source.verdict,
      ...statistics,
    ]);
  }

  // Writes all that is not there yet but the cards; then `info` and `statistics` are whole.
  async finish() {
    await this.data.end();
    await this.meta.end();
    const tasks = await ParquetFile.create(this.connection, [
      ['task_index', BIGINT],
      ['task', VARCHAR],
    ]);
    for (const [task, number] of this.#tasks) tasks.add([BigInt(number), task]);
    const pandas = pandasIndex('task', [
      ['task_index', 'int64'],
      ['task', 'object'],
    ]);
    await tasks.write(join(this.folder, 'meta/tasks.parquet'), { pandas });
    await this.#writeJson('meta/stats.json', await this.#allStatistics());
  }

  async #allStatistics() {
    const all = {};
    const files = join(this.folder, 'data/*/*.parquet');
    for (const feature of this.features) {
      const { count, ...own } = this.#statistics[feature.name];
      all[feature.name] = { ...own, count: [count] };
      if (feature.dtype !== 'float32') continue;
      const shares = Object.values(QUANTILES);
      const numbers = await quantilesOf(this.connection, files, feature, shares, { rows: this.frames });
      Object.keys(QUANTILES).forEach((name, k) => {
        all[feature.name][name] = numbers[k];
      });
    }
    return all;
  }

  // splits: { train: [first episode, the one after the last], … }
  async writeInfo({ body, fps, fileMegabytes, splits }) {
    const features = this.features.map(({ name, dtype, width, names }) => [name, { dtype, shape: [width], names }]);
    await this.#writeJson('meta/info.json', {
      codebase_version: 'v3.0',
      robot_type: body,
      total_episodes: this.episodes,
      total_frames: this.frames,
      total_tasks: this.tasks,
      chunks_size: FILES_A_FOLDER,
      data_files_size_in_mb: fileMegabytes,
      video_files_size_in_mb: 200,
      fps,
      splits: Object.fromEntries(splits.map(({ name, first, last }) => [name, `${first}:${last}`])),
      data_path: 'data/chunk-{chunk_index:03d}/file-{file_index:03d}.parquet',
      video_path: null,
      features: Object.fromEntries(features),
    });
  }

  async #writeJson(name, value) {
    await mkdir(join(this.folder, 'meta'), { recursive: true });
    await writeFile(join(this.folder, name), `${JSON.stringify(value, null, 4)}\n`);
  }
}
