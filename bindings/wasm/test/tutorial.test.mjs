// SPDX-License-Identifier: MIT
// The page of docs/tutorials/in_the_browser.md, as a reader types it, in Debian's Chromium.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { test } from 'node:test';

const chromium = '/usr/bin/chromium-headless-shell';
const types = { js: 'text/javascript', mjs: 'text/javascript', wasm: 'application/wasm', html: 'text/html' };

/** The text of each block of the tutorial that has a title, by that. */
async function tutorialFiles() {
  const text = await readFile(new URL('../../../docs/tutorials/in_the_browser.md', import.meta.url), 'utf8');
  return new Map([...text.matchAll(/^```\w+ title="([^"]+)"\n(.*?)^```$/gms)].map(([, name, block]) => [name, block]));
}

async function answer(files, request, response) {
  const path = new URL(request.url, 'http://localhost').pathname.slice(1) || 'index.html';
  const packed = /^engine\/([a-z_/]+\.(?:js|mjs|wasm|tsv))$/.exec(path);
  const bytes = packed === null ? files.get(path)
    : await readFile(new URL(`../dist/${packed[1]}`, import.meta.url)).catch(() => undefined);
  response.writeHead(bytes === undefined ? 404 : 200, { 'content-type': types[path.split('.').at(-1)] ?? 'text/plain' });
  response.end(bytes);
}

/** Serves these files, and the package as the folder `engine`. */
async function serve(files) {
  const server = createServer((request, response) => void answer(files, request, response));
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  return server;
}

test('the tutorial’s page shows a motion, and another one when its slider moves', {
  skip: !existsSync(chromium) && `${chromium} is not there`, timeout: 60000,
}, async () => {
  const { chromium: launcher } = await import('playwright-core');
  const server = await serve(await tutorialFiles());
  const browser = await launcher.launch({ executablePath: chromium, args: ['--no-sandbox'] });
  try {
    const tab = await browser.newPage();
    const problems = [];
    tab.on('pageerror', (error) => problems.push(String(error)));
    await tab.goto(`http://127.0.0.1:${server.address().port}/`);
    const lowest = () => tab.evaluate(() => document.querySelector('#view path')?.getBBox().y);
    await tab.waitForFunction(() => /^\w+: /.test(document.querySelector('#said').textContent));
    // the head comes down as the person reaches for the low place that the page begins with
    await tab.waitForFunction(() => (document.querySelector('#view path')?.getBBox().y ?? -200) > -145);
    assert.match(await tab.textContent('#said'), /^possible: (half squat|upright, leaning, knees bent)/);
    await tab.fill('#height', '1.9');
    await tab.waitForFunction(() => document.querySelector('#said').textContent.includes('upright'));
    // the raised hand is above the head
    await tab.waitForFunction(() => document.querySelector('#view path').getBBox().y < -185);
    assert.ok(await lowest() < -185);
    assert.deepEqual(problems, []);
  } finally {
    await browser.close();
    server.close();
  }
});
