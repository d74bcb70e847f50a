// SPDX-License-Identifier: MIT
// Writes Parquet files by DuckDB. One thread keeps rows, and so bytes, in one order.
import { mkdir } from 'node:fs/promises';
import { dirname } from 'node:path';
import { DuckDBDataChunk, DuckDBInstance } from '@duckdb/node-api';

const CHUNK_ROWS = 2048; // the most that DuckDB takes at once

const text = (value) => `'${value.replaceAll("'", "''")}'`;
const name = (value) => `"${value.replaceAll('"', '""')}"`;

export async function connect() {
  const database = await DuckDBInstance.create(':memory:', { threads: '1' });
  return database.connect();
}

let tables = 0;

// Rows that become one file.
export class ParquetFile {
  #connection;
  #table;
  #appender;
  #types;
  #waiting;

  // columns: [[name, type of DuckDB], …]
  static async create(connection, columns) {
    const file = new ParquetFile();
    const list = columns.map(([column, type]) => `${name(column)} ${type}`);
    file.#connection = connection;
    file.#table = `made_${++tables}`;
    await connection.run(`CREATE TEMP TABLE ${file.#table} (${list.join(', ')})`);
    file.#appender = await connection.createAppender(file.#table);
    file.#types = columns.map(([, type]) => type);
    file.#waiting = columns.map(() => []);
    file.rows = 0;
    return file;
  }

  // A value for each column.
  add(values) {
    values.forEach((value, i) => this.#waiting[i].push(value));
    ++this.rows;
    if (this.#waiting[0].length === CHUNK_ROWS) this.#append();
  }

  #append() {
    if (this.#waiting[0].length === 0) return;
    const chunk = DuckDBDataChunk.create(this.#types);
    chunk.setColumns(this.#waiting);
    this.#appender.appendDataChunk(chunk);
    this.#waiting.forEach((column) => {
      column.length = 0;
    });
  }

  // metadata: texts by their keys, for the file's end.
  async write(path, metadata = {}) {
    this.#append();
    this.#appender.closeSync();
    await mkdir(dirname(path), { recursive: true });
    const pairs = Object.entries(metadata).map(([key, value]) => `${key}: ${text(value)}`);
    const keys = pairs.length > 0 ? `, KV_METADATA {${pairs.join(', ')}}` : '';
    await this.#connection.run(`COPY ${this.#table} TO ${text(path)} (FORMAT parquet, COMPRESSION zstd${keys})`);
    await this.#connection.run(`DROP TABLE ${this.#table}`);
  }
}

// Shares of a feature's numbers below which a share of them is, over at most `most` of the rows.
export async function quantilesOf(connection, files, feature, shares, { rows, most = 1_000_000 }) {
  const list = feature.width === 1 ? `[${name(feature.name)}]` : name(feature.name);
  const reader = await connection.runAndReadAll(
    `SELECT quantile_cont(number, [${shares.join(', ')}]) FROM (
       SELECT unnest(numbers)::DOUBLE AS number, generate_subscripts(numbers, 1) AS place FROM (
         SELECT ${list} AS numbers FROM read_parquet(${text(files)}) WHERE "index" % ${Math.ceil(rows / most)} = 0))
     GROUP BY place ORDER BY place`,
  );
  const columns = reader.getRowsJson().map(([values]) => values);
  return shares.map((_, k) => columns.map((values) => values[k]));
}
