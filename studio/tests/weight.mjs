// SPDX-License-Identifier: MIT
// What a page has loaded of the built files, gzipped, without the engine and its start tables.
import { readdirSync, readFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { dist } from './support.mjs';

/** Waits for what comes once the page rests. Returns [name, bytes] of each file. */
export async function weights(page) {
  await page.waitForFunction(() => performance.getEntriesByType('resource').some(({ name }) => name.includes('/later-')));
  const asked = await page.evaluate(() => performance.getEntriesByType('resource').map(({ name }) => new URL(name).pathname));
  const names = new Set(['index.html', ...asked.map((path) => basename(path))]);
  const files = readdirSync(dist, { recursive: true }).filter((name) => names.has(basename(name)) && !/\.(wasm|tsv)$/.test(name));
  return files.map((name) => [name, gzipSync(readFileSync(join(dist, name)), { level: 9 }).length]);
}
