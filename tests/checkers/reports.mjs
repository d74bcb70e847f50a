// SPDX-License-Identifier: MIT
// reports.mjs MANIFEST EXPECTED PROGRAM FOLDER: see scripts/check_reports. An entry of EXPECTED is
//   row: kind and file of the manifest's row, as "9 no masses: robot.urdf"
//   run: the arguments, with {file} for the row's file and {reports} for its folder; a list is run one after the other
//   exit: the last one's exit code, 0 unless told
//   err, out, not_err: regular expressions that the last one's output has, or has not
//   json: {"path.to.value": [low, high]} of what the last one prints
//   file: [name, regular expression] of a file that it writes into its folder
//   fails: why what is to be is not yet so
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';

const [manifest, expected, program, folder] = process.argv.slice(2);
const reports = dirname(resolve(manifest));
const [head, ...lines] = readFileSync(manifest, 'utf8').trimEnd().split('\n').map((line) => line.split('\t'));
if (head?.[0] !== 'kind' || lines.length === 0) throw new Error(`${manifest} has no rows of kinds`);
const entries = JSON.parse(readFileSync(expected, 'utf8'));

const valueAt = (json, path) => path.split('.').reduce((value, key) => value?.[key], json);

/** What is not as it is to be, of one entry; '' where all is. */
function wrongIn(entry) {
  const cwd = mkdtempSync(join(folder, 'run-'));
  const file = join(reports, entry.row.slice(entry.row.indexOf(': ') + 2));
  let last;
  for (const run of [entry.run].flat()) {
    const words = run.split(' ').map((word) => word.replaceAll('{file}', file).replaceAll('{reports}', reports));
    last = spawnSync(program, words, { cwd, encoding: 'utf8', timeout: 120_000 });
  }
  const told = `${last.stderr.slice(0, 400)}`;
  if (last.status !== (entry.exit ?? 0)) return `exit code ${last.status ?? last.signal}: ${told}`;
  if (entry.err && !new RegExp(entry.err).test(last.stderr)) return `no /${entry.err}/ in: ${told}`;
  if (entry.not_err && new RegExp(entry.not_err).test(last.stderr)) return `/${entry.not_err}/ in: ${told}`;
  if (entry.out && !new RegExp(entry.out).test(last.stdout)) return `no /${entry.out}/ in: ${last.stdout.slice(0, 400)}`;
  if (entry.file && !new RegExp(entry.file[1], 'm').test(readFileSync(join(cwd, entry.file[0]), 'utf8'))) return `no /${entry.file[1]}/ in ${entry.file[0]}`;
  const json = entry.json ? JSON.parse(last.stdout) : {};
  for (const [path, [low, high]] of Object.entries(entry.json ?? {})) {
    const value = valueAt(json, path);
    if (!(value >= low && value <= high)) return `${path} is ${value}, and is to be ${low} to ${high}`;
  }
  return '';
}

let failures = 0;
const fail = (text) => {
  ++failures;
  console.error(`check_reports: ${text}`);
};
// a row stands as often as it has entries, at least
const count = (list, row) => list.filter((one) => one === row).length;
const rows = lines.map(([kind, file]) => `${kind}: ${file}`);
for (const row of new Set(rows)) {
  const has = count(entries.map((entry) => entry.row), row);
  if (has < count(rows, row)) fail(`${row}: ${has} entries for ${count(rows, row)} rows`);
}
for (const { row } of entries) if (!rows.includes(row)) fail(`${row}: the manifest has no such row`);
let failing = 0;
for (const entry of entries) {
  if (!rows.includes(entry.row)) continue;
  let wrong;
  try {
    wrong = wrongIn(entry);
  } catch (error) {
    wrong = String(error);
  }
  if (entry.fails) ++failing;
  if (entry.fails && wrong === '') fail(`${entry.row}: is as it is to be; take "fails" away`);
  if (!entry.fails && wrong !== '') fail(`${entry.row}: ${[entry.run].flat().at(-1)}: ${wrong}`);
}
console.log(`check_reports: ${rows.length} rows, ${entries.length} entries, ${failing} expected to fail, ${failures} failures`);
process.exit(failures > 0 || entries.length === 0 ? 1 : 0);
