// SPDX-License-Identifier: MIT
// The package as it is, in Debian's Chromium under a strict content security policy: no bundler, no eval.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { test } from 'node:test';
import { smallTask } from './support.mjs';

const chromium = '/usr/bin/chromium-headless-shell';
const policy = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; connect-src 'self'; " +
  "base-uri 'none'; form-action 'none'";
const types = { js: 'text/javascript', mjs: 'text/javascript', wasm: 'application/wasm', html: 'text/html', tsv: 'text/tab-separated-values' };

const page = '<!doctype html><title>engine</title><script type="module" src="/page.js"></script>';
const script = `
import { createEngine } from '/dist/engine.js';
const tell = (key, value) => console.log(key + ' ' + JSON.stringify(value));
try {
  const begin = performance.now();
  const engine = await createEngine();
  tell('started', Math.round(performance.now() - begin));
  const human = await engine.open({ source: 'human' });
  const task = ${JSON.stringify(smallTask)};
  let reports = 0;
  const found = await engine.generate(human, task, { onProgress: () => void ++reports });
  const refused = await engine.open({ source: 'dragon' }).catch((error) => error.failure);
  const controller = new AbortController();
  const stopped = engine.generate(human, { ...task, evaluations: 500000 }, {
    signal: controller.signal, onProgress: () => controller.abort(),
  });
  const aborted = await stopped.catch((error) => error.name);
  for (let i = 0; i < 3; ++i) {
    const { engine_ms } = await engine.generate(human, { goals: task.goals, seed: 1 });
    tell('default search', Math.round(engine_ms));
  }
  const { elapsed_ms, ...summary } = found.summary;
  tell('done', { summary, reports, refused, aborted });
} catch (error) {
  tell('failed', String(error));
}`;

async function answer(request, response) {
  const path = new URL(request.url, 'http://localhost').pathname;
  const bytes = path === '/' ? page : path === '/page.js' ? script
    : /^\/dist\/[a-z/]+\.(js|mjs|wasm|tsv)$/.test(path)
      ? await readFile(new URL(`..${path}`, import.meta.url)).catch(() => null) : null;
  const ending = path === '/' ? 'html' : path.split('.').at(-1);
  response.writeHead(bytes === null ? 404 : 200, {
    'content-type': types[ending] ?? 'text/plain', 'content-security-policy': policy,
  });
  response.end(bytes);
}

test('the engine works in a page under a strict policy', {
  skip: !existsSync(chromium) && `${chromium} is not there`, timeout: 60000,
}, async (context) => {
  const { chromium: launcher } = await import('playwright-core');
  const server = createServer((request, response) => void answer(request, response));
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  const browser = await launcher.launch({ executablePath: chromium, args: ['--no-sandbox'] });
  try {
    const tab = await browser.newPage();
    const problems = [];
    tab.on('pageerror', (error) => problems.push(String(error)));
    const last = new Promise((resolve) => tab.on('console', (message) => {
      const [key] = message.text().split(' ', 1);
      const value = message.text().slice(key.length + 1);
      if (message.type() === 'error') problems.push(message.text());
      else if (key === 'done' || key === 'failed') resolve({ key, value: JSON.parse(value) });
      else context.diagnostic(message.text());
    }));
    await tab.goto(`http://127.0.0.1:${server.address().port}/`);
    const { key, value } = await last;
    assert.equal(key, 'done', String(value));
    assert.deepEqual(problems.filter((problem) => !problem.includes('favicon')), []);
    assert.equal(value.summary.status, 'reached');
    assert.ok(value.reports > 0);
    assert.equal(value.refused.code, 'parse');
    assert.equal(value.aborted, 'AbortError');
    // Node.js and Chromium have the same engine
    const { openedDoor } = await import('./support.mjs');
    const door = await openedDoor();
    const { elapsed_ms: _, ...here } = JSON.parse(
      door.generate(door.character({ source: 'human' }), smallTask).summaryText());
    assert.deepEqual(value.summary, here);
  } finally {
    await browser.close();
    server.close();
  }
});
