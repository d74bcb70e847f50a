// SPDX-License-Identifier: MIT
// What the page loads, and when.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { seriousFindings } from './axe.mjs';
import { openStudio, settled, visit } from './support.mjs';
import { weights } from './weight.mjs';

const { site, browser } = await visit();

const kMost = 322_000; // bytes gzipped, without the engine

test('all that an English page loads without being asked weighs 322 kB at most, gzipped, without the engine', async () => {
  const { page } = await openStudio(browser, site.url, { cards: true });
  await settled(page);
  const files = await weights(page);
  const names = files.map(([name]) => name).join();
  for (const part of ['index.html', 'index-', 'page-', 'later-', 'worker-', 'mannequin-', '.css']) assert.ok(names.includes(part), `${part} in ${names}`);
  const sum = files.reduce((total, [, bytes]) => total + bytes, 0);
  assert.ok(sum <= kMost, `${sum} bytes of ${names}`);
});

test('an engine whose start tables cannot be fetched, or are none, does not start, and the page says so', async () => {
  for (const answer of [(route) => route.abort(), (route) => route.fulfill({ body: '<!doctype html>' })]) {
    const { page, context } = await openStudio(browser, 'about:blank');
    await context.route('**/starts-*.tsv', answer);
    await page.goto(site.url);
    await page.getByRole('alert').waitFor();
    assert.match(await page.getByRole('alert').innerText(), /The engine did not start\. A part of the page could not be loaded/);
    assert.equal(await page.evaluate(() => window.shigusa), undefined);
    await context.close();
  }
});

test('panels that are seldom wanted at once come after the first motions', async () => {
  const { page } = await openStudio(browser, site.url);
  await settled(page);
  assert.equal(await page.locator('#panel-plots > *').count(), 0);
  await page.waitForFunction(() => performance.getEntriesByType('resource').some(({ name }) => /\/later-/.test(name)));
  await page.click('#tab-plots');
  await page.waitForSelector('#panel-plots svg');
  assert.equal(await page.getAttribute('#panel-plots', 'role'), 'tabpanel');
  assert.equal(await page.locator('[role="tabpanel"]:visible').count(), 1);
});

test('a panel that cannot be fetched says so, and is there once it can', async () => {
  const { page, context } = await openStudio(browser, site.url);
  await context.route('**/taking-*.js', (route) => route.abort());
  await settled(page);
  await page.click('#tab-take');
  const panel = page.locator('#panel-take');
  await panel.getByRole('alert').waitFor();
  assert.match(await panel.innerText(), /could not be loaded/);
  assert.deepEqual(await seriousFindings(page, '.side'), []);
  await context.unroute('**/taking-*.js');
  await panel.getByRole('button', { name: 'Try again' }).click();
  await page.waitForSelector('#panel-take [data-format="glb"]');
  assert.equal(await panel.getByRole('alert').count(), 0);
});

test('what makes films is fetched when one is asked for, and told of where it cannot be', async () => {
  const { page, context } = await openStudio(browser, site.url);
  await context.route('**/film-*.js', (route) => route.abort());
  await settled(page);
  await page.click('#tab-take');
  await page.click('[data-format="film"]');
  await page.waitForFunction(() => window.shigusa.state.notice?.key === 'partFailed');
  assert.equal(await page.locator('[data-format="film"]').isEnabled(), true);
});
