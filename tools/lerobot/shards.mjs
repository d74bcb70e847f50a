// SPDX-License-Identifier: MIT
// Reads the shards of a data set; docs/data.md tells what is in them.
import { createHash } from 'node:crypto';
import { readdir, readFile } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { File, ready } from 'h5wasm';

const HEAD_BYTES = 512; // of plain text, which HDF5 leaves to us
const MAX_BYTES = 256 * 2 ** 20;
const VERSION = 1;

// The paths of a folder's shards, by their numbers.
export async function shardPaths(folder) {
  const all = await readdir(folder).catch((error) => {
    throw new Error(`${folder}: cannot be read as a folder: ${error.code}`);
  });
  const names = all.filter((name) => /^shard-\d{6,}\.h5$/.test(name));
  if (names.length === 0) throw new Error(`${folder}: has no shard-000000.h5 or later ones`);
  return names.sort().map((name) => join(folder, name));
}

// A head's lines by their first words; fails where a byte of the shard is not what it was.
function checkedHead(path, bytes) {
  const end = bytes.indexOf(0);
  const text = bytes.toString('latin1', 0, Math.min(end < 0 ? HEAD_BYTES : end, HEAD_BYTES));
  const lines = text.trimEnd().split('\n');
  if (bytes.length <= HEAD_BYTES || lines[0] !== `shigusa data set, shard version ${VERSION}`) {
    throw new Error(`${path}: is no shard of version ${VERSION}: it begins with '${lines[0].slice(0, 60)}'`);
  }
  const head = Object.fromEntries(lines.map((line) => [line.split(' ')[0], line.split(' ').slice(1).join(' ')]));
  const signed = lines.slice(0, lines.findIndex((line) => line.startsWith('sha256 ')));
  const sum = createHash('sha256').update(signed.map((line) => `${line}\n`).join(''));
  if (sum.update(bytes.subarray(HEAD_BYTES)).digest('hex') !== head.sha256) {
    throw new Error(`${path}: is damaged: its bytes are not those that it was written with; make it anew`);
  }
  return head;
}

// A column of a table: one number, text or block of numbers a row.
class Column {
  constructor(dataset) {
    this.rows = dataset.shape[0];
    this.shape = dataset.shape.slice(1);
    this.width = this.shape.reduce((product, side) => product * side, 1);
    this.values = this.rows === 0 ? [] : dataset.value;
    this.words = dataset.attrs.words?.value;
  }
  // The number or text of a row; task numbers come as BigInt and are below 2^53.
  at(row) {
    const value = this.values[row];
    return typeof value === 'bigint' ? Number(value) : value;
  }
  // The numbers of a row that has many.
  block(row) {
    return this.values.subarray(row * this.width, (row + 1) * this.width);
  }
  // The word of a row's number.
  word(row) {
    return this.words[this.at(row)];
  }
}

class Shard {
  constructor(path, head, file) {
    Object.assign(this, { path, plan: head.plan, file });
  }
  // The tables of motions, one for bodies alike.
  bodies() {
    return this.file.keys().includes('motions') ? this.file.get('motions').keys().sort() : [];
  }
  has(table, column) {
    return this.file.get(table).keys().includes(column);
  }
  // The columns by their names.
  columns(table, names) {
    const group = this.file.get(table);
    return Object.fromEntries(
      names.map((name) => {
        const dataset = group.get(name);
        if (!dataset) throw new Error(`${this.path}: ${table} has no column '${name}'`);
        return [name, new Column(dataset)];
      }),
    );
  }
  // A list of names, as `joints`.
  names(table, list) {
    return this.file.get(table).attrs[list].value;
  }
}

// Opens the bytes of a file for `use`, which gets it; closes it whatever happens. They lie in memory, where no
// other file is: a stranger's may name files of this machine as places of its numbers.
let opened = 0;
async function withBytes(bytes, use) {
  const { FS } = await ready;
  const name = `${opened++}.h5`;
  FS.writeFile(name, bytes);
  try {
    const file = new File(name, 'r');
    try {
      return await use(file);
    } finally {
      file.close();
    }
  } finally {
    FS.unlink(name);
  }
}

// Gives the split of a task by its number, as the folder's index has it: `by` is person or region.
export async function splitOf(folder, plan, by) {
  const path = resolve(folder, 'index.h5');
  const merge = `make it by 'shigusa dataset merge ${folder}'`;
  const bytes = await readFile(path).catch(() => {
    throw new Error(`${path}: is not there, and has the splits; ${merge}`);
  });
  return withBytes(bytes, (file) => {
    if (file.attrs.plan_sha256?.value !== plan) {
      throw new Error(`${path}: is of another plan than the shards; ${merge}`);
    }
    const tasks = new Column(file.get('splits/task'));
    const splits = new Column(file.get(`splits/by_${by}`));
    const rows = new Map(Array.from({ length: tasks.rows }, (_, row) => [tasks.at(row), row]));
    return (task) => {
      if (!rows.has(task)) throw new Error(`${path}: has no task ${task}; ${merge}`);
      return splits.word(rows.get(task));
    };
  });
}

// Opens a shard for `use`, which gets it; closes it whatever happens.
export async function withShard(path, use) {
  const bytes = await readFile(path);
  if (bytes.length > MAX_BYTES) throw new Error(`${path}: has ${bytes.length} bytes; a shard has at most ${MAX_BYTES}`);
  const head = checkedHead(path, bytes);
  return withBytes(bytes, (file) => use(new Shard(path, head, file)));
}
