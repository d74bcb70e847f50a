// SPDX-License-Identifier: MIT
// The built page on a server of its own, and a browser to look at it.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';
import { after } from 'node:test';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';

/** The built page: this tree's, or another one to be tested. */
export const dist = process.env.SHIGUSA_STUDIO_DIST ?? fileURLToPath(new URL('../dist/', import.meta.url));
/** Not the root: the page works from any folder of any host. */
const kFolder = '/some/where/';

const types = {
  '.html': 'text/html; charset=utf-8', '.js': 'text/javascript', '.css': 'text/css', '.svg': 'image/svg+xml', '.wasm': 'application/wasm',
  '.tsv': 'text/tab-separated-values',
};

async function answer(folder, request, response) {
  const path = decodeURIComponent(new URL(request.url, 'http://localhost').pathname);
  const inside = path.startsWith(kFolder) ? normalize(path.slice(kFolder.length) || 'index.html') : '..';
  try {
    if (inside.startsWith('..')) throw new Error('outside');
    const bytes = await readFile(join(folder, inside));
    // as `shigusa studio` has it
    const cache = inside.startsWith('assets/') ? 'max-age=31536000, immutable' : 'no-cache';
    response.writeHead(200, { 'content-type': types[extname(inside)] ?? 'application/octet-stream', 'cache-control': cache }).end(bytes);
  } catch {
    response.writeHead(404).end();
  }
}

export async function serve(folder = dist) {
  const server = createServer((request, response) => void answer(folder, request, response));
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  return { url: `http://127.0.0.1:${server.address().port}${kFolder}`, close: () => {
    server.close();
    server.closeAllConnections();
  } };
}

const kBrowser = { executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium-headless-shell', args: ['--no-sandbox'] };
/** What a short visit does without: smooth edges, which take a third of the time of a picture that is drawn by software, and code that is made faster before it has run for long, which takes a fifth of all. */
const kQuick = ['--webgl-antialiasing-mode=none', '--js-flags=--wasm-tiering-budget=26000000 --no-maglev --interrupt-budget=20000000'];

/** `full`: with all that a person's browser does. */
export function launch({ full = false } = {}) {
  return chromium.launch({ ...kBrowser, args: [...kBrowser.args, ...(full ? [] : kQuick)] });
}

/** A browser with a profile in a folder, as a person has: what it fetched and compiled stays. */
export function launchAtHome(folder) {
  return chromium.launchPersistentContext(folder, { ...kBrowser, viewport: { width: 1280, height: 720 }, reducedMotion: 'reduce' });
}

/** A server and a browser for the tests of a file, which end after them. */
export async function visit() {
  const site = await serve();
  const browser = await launch();
  after(async () => {
    await browser.close();
    site.close();
  });
  return { site, browser };
}

/** Adds what the console complains of; what the software renderer of test machines and what drives the browser say is no error of the page. */
export function hear(page, errors) {
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type()) && !/GPU stall due to ReadPixels|GroupMarkerNotSet|blocked by Playwright/.test(message.text())) errors.push(message.text());
  });
}

/** Leaves the graphics card without work: a processor that draws takes most of a test's time. */
function drawNothing() {
  const { prototype } = WebGL2RenderingContext;
  for (const name of ['clear', 'compileShader', 'drawArrays', 'drawElements', 'generateMipmap', 'linkProgram', 'texImage2D', 'texStorage2D', 'texSubImage2D', 'useProgram']) prototype[name] = () => undefined;
}

/** A page that is open, with motions that do not play unasked, as drawing by software takes all of a machine; `errors` gets what the console complains of. `cards`: as at a first visit, with the cards to begin with. `seen`: its view and its small pictures are drawn. Without the service worker, which each context would have fetch all files. */
export async function openStudio(browser, url, { cards = false, seen = false, ...options } = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 720 }, acceptDownloads: true, reducedMotion: 'reduce', serviceWorkers: 'block', ...options });
  if (!seen) await context.addInitScript(drawNothing);
  if (!cards) {
    await context.addInitScript(() => {
      // an empty page has no storage
      if (location.protocol !== 'about:') localStorage.setItem('shigusa.start', 'closed');
    });
  }
  const page = await context.newPage();
  const errors = [];
  hear(page, errors);
  page.on('pageerror', (error) => errors.push(String(error)));
  page.on('request', (request) => {
    if (!request.url().startsWith(url.split('/').slice(0, 3).join('/')) && !/^(data|blob):/.test(request.url())) errors.push(`fetched ${request.url()}`);
  });
  await page.goto(url);
  return { page, context, errors };
}

/** The address at which the page opens a task. */
export function linkTo(site, task) {
  return `${site.url}#task=${Buffer.from(JSON.stringify(task)).toString('base64url')}`;
}

/** Opens a task in a page that is open, as its link does; sooner than the page anew. Back once its motions are there. */
export async function ask(page, task) {
  await page.evaluate((hash) => {
    window.before = window.shigusa.document;
    history.replaceState(null, '', location.pathname); // the same one may come again
    location.hash = hash;
  }, new URL(linkTo({ url: 'http://a/' }, task)).hash);
  await page.waitForFunction(() => window.shigusa.document !== window.before);
  await settled(page);
}

/** Waits until motions are found and drawn. */
export async function settled(page) {
  await page.waitForFunction(() => {
    const { state } = window.shigusa ?? {};
    return state && state.document?.result && !state.search && !state.dragging && !state.opening && !state.preview && window.shigusa.framed;
  }, undefined, { timeout: 60_000 });
  await drawn(page);
}

/** Two pictures later what was asked for is drawn, and the camera is where it stays. */
export const drawn = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

/** Waits until the engine has answered all that it was asked for quickly, such as a slider's motions; a search must not be going on. */
export const answered = (page) => page.evaluate(() => window.shigusa.memory());

/** Reads until a check, a pattern or a function, finds what was read good; where it never does, says what was read last. */
export async function eventually(read, check, about = '') {
  const isGood = check instanceof RegExp ? (value) => check.test(value) : check;
  for (const end = Date.now() + 30_000; ;) {
    const value = await read();
    if (isGood(value)) return value;
    if (Date.now() > end) assert.fail(`${about || check}: ${JSON.stringify(value)}`);
    await new Promise((done) => setTimeout(done, 50));
  }
}

/** Where a handle is in the page once it rests there: what has no goal goes along while the motion plays. */
export async function handleOf(page, effector) {
  await page.waitForFunction((name) => {
    const { document: d, state: s } = window.shigusa;
    return name.startsWith('@') || d.goals.some((goal) => goal.effector === name) || !s.playing;
  }, effector);
  await drawn(page);
  return page.evaluate((name) => window.shigusa.handle(name), effector);
}

/** Drags a handle from where it is by so many pixels; `followed`: lets go once the body has followed. */
export async function drag(page, effector, dx, dy, { hold = 0, steps = 2, followed = false } = {}) {
  const [x, y] = await handleOf(page, effector);
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let k = 1; k <= steps; ++k) {
    await page.mouse.move(x + (dx * k) / steps, y + (dy * k) / steps);
    if (hold > 0) await page.waitForTimeout(hold);
  }
  if (followed) await page.waitForFunction(() => window.shigusa.state.preview !== null);
  await page.mouse.up();
}

/** As a browser does when a person lets a file go over the page. */
export function drop(page, name, bytes) {
  return dropAll(page, [[name, bytes]]);
}

/** Several at once, each with its name. */
export async function dropAll(page, files) {
  const coded = files.map(([file, bytes]) => ({ file, base64: Buffer.from(bytes).toString('base64') }));
  const data = await page.evaluateHandle((all) => {
    const transfer = new DataTransfer();
    for (const { file, base64 } of all) {
      transfer.items.add(new File([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))], file));
    }
    return transfer;
  }, coded);
  await page.dispatchEvent('body', 'drop', { dataTransfer: data });
}

/** Opens a tab; panels that come late are there then. */
export async function openTab(page, name) {
  await page.click(`#tab-${name}`);
  await page.locator(`#panel-${name} > *`).first().waitFor({ state: 'attached' });
}

/** The bytes of what the tab Save gives in a format. */
export async function take(page, format) {
  await openTab(page, 'take');
  const [download] = await Promise.all([page.waitForEvent('download'), page.click(`[data-format="${format}"]`)]);
  return readFile(await download.path());
}

/** Sets a slider as a hand does: input events on the way, a change at the end. Back when the motion is played for the last one. */
export async function slide(page, selector, share) {
  await page.locator(selector).evaluate((range, value) => {
    range.dispatchEvent(new PointerEvent('pointerdown', { bubbles: true }));
    const from = Number(range.value);
    for (let k = 1; k <= 5; ++k) {
      range.value = String(from + ((value * Number(range.max) - from) * k) / 5);
      range.dispatchEvent(new Event('input', { bubbles: true }));
    }
    range.dispatchEvent(new Event('change', { bubbles: true }));
  }, share);
  await answered(page);
}

export const state = (page) => page.evaluate(() => {
  const { document: d, state: s, chosen, words } = window.shigusa;
  return {
    chosen, words, goals: d.goals, candidates: d.result.candidates.length, status: d.result.summary.status, edits: Object.keys(d.edits).length,
    fixed: d.fixed, notice: s.notice, playing: s.playing, compared: d.compared, character: d.character.description.name, canUndo: s.canUndo,
    search: s.search, language: s.language,
  };
});
