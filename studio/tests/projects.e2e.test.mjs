// SPDX-License-Identifier: MIT
// Named projects: begun, opened, renamed, duplicated, deleted and brought back; the last change is never lost.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { seriousFindings } from './axe.mjs';
import { kept, records, saved, work } from './kept.mjs';
import { drawn, drop, eventually, openStudio, openTab, settled, state, take, visit } from './support.mjs';

const { site, browser } = await visit();

const open = (options = {}) => openStudio(browser, site.url, { viewport: { width: 920, height: 520 }, ...options });
const isShown = (page) => page.evaluate(() => document.getElementById('project-menu').matches(':popover-open'));
async function menu(page) {
  if (!(await isShown(page))) await page.click('.project-opener');
}
const row = (page, name) => page.locator('.projects li').filter({ has: page.locator('b').getByText(name, { exact: true }) });
const listed = (page, wanted) => page.waitForFunction((all) => [...document.querySelectorAll('.projects b')].map((b) => b.textContent).sort().join() === all, wanted.join());
/** Opens the list until the project on the table has its picture there: the small pictures come one by one. */
async function pictured(page) {
  await eventually(async () => {
    await page.keyboard.press('Escape');
    await menu(page);
    await drawn(page);
    return page.locator('.projects [aria-pressed="true"] img').count();
  }, (count) => count === 1, 'the project has its picture');
}
async function rename(page, from, to) {
  await row(page, from).getByRole('button', { name: `Rename “${from}”` }).click();
  await page.locator('.naming input').fill(to);
  await page.keyboard.press('Enter');
  await row(page, to).waitFor();
}

test('projects are named, begun, opened again as they were, duplicated, deleted and brought back', { timeout: 300_000 }, async () => {
  const { page, context, errors } = await open({ seen: true });
  await settled(page);
  await menu(page);
  await listed(page, ['Untitled']); // it is filled after it has opened
  assert.equal((await records(page, 'projects')).length, 0);
  await page.keyboard.press('Escape');
  await work(page);
  await saved(page);
  await pictured(page);
  await rename(page, 'Untitled', 'Low shelf');
  await saved(page);
  const first = await kept(page);
  assert.equal(await page.locator('.saving span').innerText(), 'Low shelf');

  await page.click('[data-project="new"]');
  await page.waitForFunction(() => window.shigusa.state.project === 'Untitled');
  await settled(page);
  assert.equal((await state(page)).canUndo, false, 'undo stays within a project');
  await page.keyboard.press('Escape');
  await page.keyboard.press('Digit2');
  await saved(page);
  const second = await kept(page);
  await pictured(page);
  await rename(page, 'Untitled', 'Second');
  assert.deepEqual(await seriousFindings(page, '#project-menu'), []);

  await row(page, 'Low shelf').locator('.pick-character').click();
  await page.waitForFunction(() => window.shigusa.state.project === 'Low shelf' && !window.shigusa.state.search);
  assert.equal(await isShown(page), false);
  assert.equal(await kept(page), first);
  await menu(page);
  await row(page, 'Low shelf').getByRole('button', { name: 'Duplicate “Low shelf”' }).click();
  await listed(page, ['Low shelf', 'Low shelf (copy)', 'Second']);
  for (const project of await records(page, 'projects')) assert.match(project.picture, /^data:image\/png;base64,.{500,}/, project.name);

  // the one on the table makes room for another one
  await row(page, 'Low shelf').getByRole('button', { name: 'Delete “Low shelf”' }).click();
  await listed(page, ['Low shelf (copy)', 'Second']);
  assert.equal((await records(page, 'works')).length, 2);
  assert.notEqual(await page.evaluate(() => window.shigusa.state.project), 'Low shelf');
  await page.click('[data-project="undo"]');
  await page.waitForFunction(() => window.shigusa.state.project === 'Low shelf' && !window.shigusa.state.search);
  await listed(page, ['Low shelf', 'Low shelf (copy)', 'Second']);
  assert.equal(await kept(page), first);
  await row(page, 'Second').locator('.pick-character').click();
  await page.waitForFunction(() => window.shigusa.state.project === 'Second' && !window.shigusa.state.search);
  assert.equal(await kept(page), second);

  // with the last one, an empty one that is not kept
  await menu(page);
  for (const name of ['Low shelf', 'Low shelf (copy)', 'Second']) {
    await row(page, name).getByRole('button', { name: `Delete “${name}”` }).click();
    await row(page, name).waitFor({ state: 'detached' });
  }
  await listed(page, ['Untitled']);
  for (const store of ['projects', 'works']) assert.equal((await records(page, store)).length, 0, store);
  assert.deepEqual(errors, []);
  await context.close();
});

test('a project that another tab has is neither renamed nor deleted', { timeout: 240_000 }, async () => {
  const { page, context, errors } = await open();
  await settled(page);
  await page.keyboard.press('Digit2');
  await saved(page);
  const other = await context.newPage();
  other.on('pageerror', (error) => errors.push(String(error)));
  await other.goto(site.url);
  await settled(other);
  await other.keyboard.press('Digit3');
  await saved(other);
  await menu(other);
  await listed(other, ['Untitled', 'Untitled (copy)']);
  await row(other, 'Untitled').getByRole('button', { name: 'Delete “Untitled”' }).click();
  await other.locator('.said', { hasText: 'open in another tab' }).waitFor();
  await rename(other, 'Untitled (copy)', 'Mine');
  await saved(other);
  await row(other, 'Untitled').getByRole('button', { name: 'Rename “Untitled”' }).click();
  await other.locator('.naming input').fill('Yours');
  await other.keyboard.press('Enter');
  await other.locator('.said', { hasText: 'open in another tab' }).waitFor();
  assert.deepEqual((await records(page, 'projects')).map(({ name }) => name).sort(), ['Mine', 'Untitled']);
  await page.keyboard.press('Digit1');
  await saved(page);
  assert.equal((await records(page, 'projects')).length, 2, 'the first tab goes on with its own');
  assert.deepEqual(errors, []);
  await context.close();
});

test('files that no project uses are removed, and come back with their project', { timeout: 240_000 }, async () => {
  const { page, context, errors } = await open();
  await settled(page);
  const bvh = await take(page, 'bvh');
  await drop(page, 'walker.bvh', bvh);
  await page.waitForFunction(() => window.shigusa.document.character.bytes !== undefined);
  await settled(page);
  await saved(page);
  await menu(page);
  await row(page, 'Untitled').getByRole('button', { name: 'Duplicate “Untitled”' }).click();
  await listed(page, ['Untitled', 'Untitled (copy)']);
  assert.equal((await records(page, 'files')).length, 1);
  await row(page, 'Untitled (copy)').getByRole('button', { name: 'Delete “Untitled (copy)”' }).click();
  await listed(page, ['Untitled']);
  assert.equal((await records(page, 'files')).length, 1, 'the other one uses it');
  await row(page, 'Untitled').getByRole('button', { name: 'Delete “Untitled”' }).click();
  await page.locator('.said', { hasText: /freed \d+\.\d MB/ }).waitFor();
  assert.equal((await records(page, 'files')).length, 0);
  await page.click('[data-project="undo"]');
  await page.waitForFunction(() => window.shigusa.document.character.bytes !== undefined && window.shigusa.state.project === 'Untitled');
  assert.equal((await records(page, 'files')).length, 1);
  // a project that has another character now
  await page.keyboard.press('Escape');
  await openTab(page, 'body');
  await page.locator('.pick-character:not([data-project], [data-entry])').filter({ hasNotText: 'walker.bvh' }).last().click();
  await page.waitForFunction(() => window.shigusa.document.character.bytes === undefined);
  await saved(page);
  await page.reload();
  await settled(page);
  await menu(page);
  await page.locator('#project-menu', { hasText: 'Files of characters that no project uses were removed' }).waitFor();
  assert.equal((await records(page, 'files')).length, 0);
  assert.deepEqual(errors, []);
  await context.close();
});

test('a change right before a reload or a crash is there again, though the database had no time', { timeout: 240_000 }, async () => {
  const { page, context, errors } = await open();
  await settled(page);
  await page.keyboard.press('Digit2');
  await saved(page);
  const before = JSON.parse(await kept(page)).chosen;
  // the database takes nothing any more
  await page.evaluate(() => {
    IDBObjectStore.prototype.put = () => {
      throw new DOMException('too late', 'AbortError');
    };
  });
  await page.keyboard.press('Digit1');
  const changed = await kept(page);
  assert.notEqual(JSON.parse(changed).chosen, before);
  page.on('dialog', (dialog) => void dialog.accept());
  await page.reload();
  await settled(page);
  assert.equal(await kept(page), changed);
  await saved(page);
  assert.equal(await page.evaluate(() => Object.keys(localStorage).filter((key) => key.includes('journal')).length), 0, 'what is kept is noted no more');

  await page.keyboard.press('Digit3');
  const last = await kept(page);
  const session = await context.newCDPSession(page);
  session.send('Page.crash').catch(() => undefined);
  await page.waitForEvent('crash');
  const again = await context.newPage();
  await again.goto(site.url);
  await settled(again);
  assert.equal(await kept(again), last);
  await saved(again);
  assert.equal((await records(again, 'projects')).length, 1);
  assert.deepEqual(errors, []);
  await context.close();
});

test('on a phone all of the top bar is at hand', { timeout: 240_000 }, async () => {
  const { page, context, errors } = await open({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await settled(page);
  const fits = () => page.evaluate(() => {
    const { scrollWidth, clientWidth } = document.querySelector('.topbar');
    return scrollWidth <= clientWidth && [...document.querySelectorAll('.topbar button, .topbar select')]
      .filter((item) => item.checkVisibility()).every((item) => item.getBoundingClientRect().right <= innerWidth && item.getBoundingClientRect().height >= 39.5);
  });
  assert.ok(await fits());
  await page.locator('.page-opener').tap();
  assert.ok(await fits());
  await page.locator('.page-menu select').last().selectOption('ja');
  await page.waitForFunction(() => document.documentElement.lang === 'ja');
  await page.locator('.project-opener').tap();
  await page.locator('.naming').waitFor({ state: 'detached' });
  assert.ok(await fits());
  await page.getByRole('button', { name: '「Untitled」の名前を変える' }).tap();
  await page.locator('.naming input').fill('とても長い名前のプロジェクトとても長い名前のプロジェクト');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => window.shigusa.state.project.startsWith('とても'));
  assert.ok(await fits());
  assert.deepEqual(await seriousFindings(page, '.topbar'), []);
  assert.deepEqual(errors, []);
  await context.close();
});
