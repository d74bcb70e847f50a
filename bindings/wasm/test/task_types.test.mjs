// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

const at = (path) => new URL(`../../../${path}`, import.meta.url).pathname;

test('types of tasks are those of the schema (else: scripts/make_schema)', () => {
  const made = execFileSync(process.execPath, [at('bindings/wasm/task_types.mjs'), at('docs/task.schema.json')], { encoding: 'utf8' });
  assert.equal(readFileSync(at('bindings/wasm/src/task_types.ts'), 'utf8'), made);
});
