// SPDX-License-Identifier: MIT
// Once it is told, all of the page works without the network; a newer page is offered, and one that is gone goes.
import assert from 'node:assert/strict';
import { cpSync, mkdtempSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { seriousFindings } from './axe.mjs';
import { packedByDraco, packedByMeshopt } from './packed.mjs';
import { dist, drop, launch, openStudio, openTab, serve, settled, take } from './support.mjs';

const browser = await launch();
const folder = mkdtempSync(join(tmpdir(), 'shigusa-page-'));
const sites = [];
after(async () => {
  await browser.close();
  for (const site of sites) site.close();
  rmSync(folder, { recursive: true, force: true });
});
cpSync(dist, folder, { recursive: true });

async function serveOwn() {
  const site = await serve(folder);
  sites.push(site);
  return site;
}

/** A page that has a server of its own, and is kept in the browser. */
async function openKept() {
  const site = await serveOwn();
  const opened = await openStudio(browser, site.url, { serviceWorkers: 'allow' });
  await settled(opened.page);
  await ready(opened.page);
  return { site, ...opened };
}

const ready = (page) => page.waitForFunction(() => window.shigusa?.state.offline === 'ready' && navigator.serviceWorker.controller, undefined, { timeout: 60_000 });
const line = (page) => page.locator('.offline-line').innerText();

test('offline the page opens, with every panel, every export and both languages', { timeout: 300_000 }, async () => {
  const { site, page, context, errors } = await openKept();
  assert.match(await line(page), /works without the network/);
  assert.deepEqual(await seriousFindings(page, '.stage'), []);
  const kept = await page.evaluate(async () => {
    const caches = await Promise.all((await window.caches.keys()).map((name) => window.caches.open(name)));
    return (await Promise.all(caches.map((cache) => cache.keys()))).flat().map(({ url }) => new URL(url).pathname);
  });
  const files = readdirSync(folder, { recursive: true }).filter((file) => statSync(join(folder, file)).isFile());
  const names = files.filter((file) => file !== 'offline.js').map((file) => new URL(file === 'index.html' ? './' : file, site.url).pathname);
  assert.deepEqual(kept.sort(), names.sort(), 'every file of the page');

  site.close();
  await context.setOffline(true);
  await page.reload();
  await settled(page);
  await ready(page);
  assert.equal(await line(page), '', 'it is told once');
  for (const tab of ['goals', 'adjust', 'criteria', 'body', 'plots', 'take']) {
    await openTab(page, tab);
    assert.equal(await page.locator(`#panel-${tab}`).getByRole('alert').count(), 0, tab);
  }
  const formats = await page.locator('[data-format]:not([data-format="link"]):not(:disabled)').evaluateAll((all) => all.map((button) => button.dataset.format));
  for (const format of ['bvh', 'csv', 'svg', 'png', 'glb', 'picture', 'film', 'result']) assert.ok(formats.includes(format), `${format} of ${formats}`);
  await page.locator('[data-film="size"]').selectOption('640 × 360');
  const saved = new Map();
  for (const format of formats) saved.set(format, await take(page, format));
  for (const [format, bytes] of saved) assert.ok(bytes.length > 100, `${format}: ${bytes.length} bytes`);

  const own = saved.get('glb');
  for (const [name, bytes] of [['plain.glb', own], ['meshopt.glb', await packedByMeshopt(own, 'EXT_meshopt_compression')], ['draco.glb', await packedByDraco(own)]]) {
    await drop(page, name, bytes);
    await page.waitForFunction((file) => window.shigusa.document.character.spec.source === file || window.shigusa.state.notice, name, { timeout: 60_000 });
    await settled(page);
    assert.deepEqual(await page.evaluate(() => [window.shigusa.state.notice, window.shigusa.state.undrawn]), [null, null], name);
  }
  await page.selectOption('select[aria-label]:has(option[value="ja"])', 'ja');
  await page.waitForFunction(() => document.documentElement.lang === 'ja');
  assert.match(await page.locator('#tab-take').innerText(), /保存/);
  assert.deepEqual(errors, []);
  await context.close();
});

test('a newer page is offered and taken, and one that is gone from its address goes from the browser', { timeout: 240_000 }, async () => {
  const { page, context } = await openKept();
  const worker = join(folder, 'offline.js');
  const old = readFileSync(worker, 'utf8');
  const cached = () => page.evaluate(() => window.caches.keys());
  const before = await cached();
  assert.equal(before.length, 1);
  const version = before[0].split(' ').at(-1);
  assert.ok(old.includes(version));

  writeFileSync(worker, old.replace(version, 'f00dfeedf00dfeed'));
  await page.evaluate(async () => (await navigator.serviceWorker.getRegistration()).update());
  await page.waitForFunction(() => window.shigusa.state.offline === 'newer');
  assert.match(await line(page), /newer version/);
  assert.deepEqual(await seriousFindings(page, '.stage'), []);
  const loaded = page.waitForEvent('load');
  await page.locator('.offline-line').getByRole('button', { name: 'Reload' }).click();
  await loaded;
  await settled(page);
  await ready(page);
  assert.deepEqual((await cached()).map((name) => name.split(' ').at(-1)), ['f00dfeedf00dfeed'], 'the older files are gone');

  rmSync(worker);
  await page.reload();
  await page.waitForFunction(async () => !(await navigator.serviceWorker.getRegistration()) && (await window.caches.keys()).length === 0, undefined, { polling: 200 });
  writeFileSync(worker, old);
  await context.close();
});

test('a part that cannot be fetched is told in a sentence', { timeout: 120_000 }, async () => {
  const site = await serveOwn();
  const { page, context } = await openStudio(browser, site.url);
  await settled(page);
  await openTab(page, 'take');
  await context.setOffline(true);
  for (const ask of [() => page.click('[data-format="glb"]'), () => page.selectOption('select[aria-label]:has(option[value="ja"])', 'ja')]) {
    await page.evaluate(() => document.querySelector('.message .icon-button')?.click());
    await ask();
    await page.waitForFunction(() => window.shigusa.state.notice !== null);
    assert.match(await page.locator('.message').innerText(), /^A part of the page could not be loaded\. Is the network there\?/);
  }
  assert.equal(await page.evaluate(() => window.shigusa.state.language), 'en');
  await context.close();
});
