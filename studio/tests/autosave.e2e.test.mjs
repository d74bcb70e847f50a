// SPDX-License-Identifier: MIT
// Work is kept in the browser: through reloads, closed tabs and crashes, beside another tab, and without room.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { deflateRawSync } from 'node:zlib';
import { kept, records, saved, work } from './kept.mjs';
import { drop, hear, openStudio, openTab, settled, slide, state, take, visit } from './support.mjs';

const { site, browser } = await visit();

/** Small, so that drawing by software takes little of a machine. */
const open = (url = site.url) => openStudio(browser, url, { viewport: { width: 920, height: 420 } });
const ofFile = (page) => page.waitForFunction(() => window.shigusa.document?.character.bytes !== undefined);
const noticed = (page, key) => page.waitForFunction((name) => window.shigusa.state.notice?.key === name, key);

/** Another page of the same browser. */
async function another(context, errors, url = site.url) {
  const page = await context.newPage();
  page.on('pageerror', (error) => errors.push(String(error)));
  hear(page, errors);
  await page.goto(url);
  await settled(page);
  return page;
}

test('a page that nobody has worked on keeps nothing', { timeout: 120_000 }, async () => {
  const { page, context, errors } = await open();
  await settled(page);
  await openTab(page, 'plots');
  assert.equal(await page.locator('.saving').innerText(), '');
  assert.equal((await records(page, 'projects')).length, 0);
  await page.reload();
  await settled(page);
  assert.equal(await page.evaluate(() => window.shigusa.state.tab), 'goals');
  assert.deepEqual(errors, []);
  await context.close();
});

test('reloads, closed tabs and a crash lose nothing, a file\'s character neither', { timeout: 300_000 }, async () => {
  const { page, context, errors } = await open();
  await settled(page);
  const bvh = await take(page, 'bvh');
  await work(page);
  await page.locator('.saving[data-saving="unsaved"], .saving[data-saving="saved"]').waitFor();
  await saved(page);
  assert.equal(await page.locator('.saving').innerText(), 'Untitled\nSaved');
  const first = await kept(page);
  await page.reload();
  await settled(page);
  assert.equal(await kept(page), first);
  await page.close();

  const second = await another(context, errors);
  assert.equal(await kept(second), first);
  // a search, and a character with its file
  await drop(second, 'walker.bvh', bvh);
  await ofFile(second);
  await settled(second);
  await second.keyboard.press('Digit2');
  await saved(second);
  const changed = await kept(second);
  await second.reload();
  await settled(second);
  assert.equal(await kept(second), changed);
  assert.ok(await second.evaluate(() => window.shigusa.document.character.bytes.length > 0));
  assert.equal((await records(second, 'files')).length, 1);

  await second.keyboard.press('Digit3');
  await saved(second);
  const last = await kept(second);
  const session = await context.newCDPSession(second);
  session.send('Page.crash').catch(() => undefined);
  await second.waitForEvent('crash');
  const third = await another(context, errors);
  assert.equal(await kept(third), last);
  assert.equal((await records(third, 'projects')).length, 1);
  assert.deepEqual(errors, []);
  await context.close();
});

test('a second tab is told and goes on with a copy', { timeout: 240_000 }, async () => {
  const { page, context, errors } = await open();
  await settled(page);
  await work(page);
  await saved(page);
  const first = await kept(page);
  const other = await another(context, errors);
  await noticed(other, 'openElsewhere');
  assert.match(await other.locator('.message').innerText(), /“Untitled” is open in another tab.*“Untitled \(copy\)”/);
  assert.equal(await kept(other), first);
  await other.keyboard.press('Digit2');
  await saved(other);
  const second = await kept(other);
  await page.keyboard.press('Digit1');
  await saved(page);
  const third = await kept(page);
  for (const [tab, before] of [[other, second], [page, third]]) {
    await tab.reload();
    await settled(tab);
    assert.equal(await kept(tab), before);
    assert.equal((await state(tab)).notice, null);
  }
  assert.equal((await records(page, 'projects')).length, 2);
  assert.deepEqual(errors, []);
  await context.close();
});

test('a link leaves the address once its work is kept', { timeout: 240_000 }, async () => {
  const { page, context, errors } = await open();
  await settled(page);
  await page.keyboard.press('Digit2');
  await saved(page);
  const own = await kept(page);
  const { work: of } = (await records(page, 'works'))[0];
  const link = `${site.url}#work=1.${deflateRawSync(JSON.stringify({ ...of, chosen: 0, compared: 1 })).toString('base64url')}`;
  await page.evaluate((hash) => {
    location.hash = hash;
  }, new URL(link).hash);
  await page.waitForFunction(() => location.hash === '' && window.shigusa.document.compared === 1);
  await slide(page, '[data-parameter="squat_deg"]', 0.3);
  await page.waitForFunction(() => Object.keys(window.shigusa.document.edits).length === 1);
  const linked = await kept(page);
  await page.reload();
  await settled(page);
  assert.equal(await kept(page), linked, 'edits after the link are there');
  // what was on the table before has its own place
  const works = await records(page, 'works');
  assert.equal(works.length, 2);
  assert.ok(works.some((one) => one.work.chosen === JSON.parse(own).chosen && one.work.compared === null));
  assert.deepEqual(errors, []);
  await context.close();
});

/** A page whose database refuses stores that `isFull` names. */
async function withoutRoom(full) {
  const opened = await open('about:blank');
  await opened.page.addInitScript((names) => {
    const put = Object.getOwnPropertyDescriptor(IDBObjectStore.prototype, 'put').value;
    IDBObjectStore.prototype.put = function (...all) {
      if (names.includes(this.name)) throw new DOMException('no room', 'QuotaExceededError');
      return Reflect.apply(put, this, all);
    };
  }, full);
  await opened.page.goto(site.url);
  await settled(opened.page);
  return opened;
}

test('without room for a character\'s file all else is kept', { timeout: 240_000 }, async () => {
  const { page, context, errors } = await withoutRoom(['files']);
  const bvh = await take(page, 'bvh');
  await drop(page, 'walker.bvh', bvh);
  await ofFile(page);
  await settled(page);
  await noticed(page, 'fileTooLarge');
  assert.match(await page.locator('.message').innerText(), /no room for walker\.bvh/);
  await page.keyboard.press('Digit2');
  await page.locator('.saving[data-saving="incomplete"]').waitFor();
  const before = await kept(page);
  await page.reload();
  await settled(page);
  assert.equal(await kept(page), before);
  assert.match(await page.locator('.wanted').innerText(), /walker\.bvh/);
  await drop(page, 'walker.bvh', bvh);
  await ofFile(page);
  await settled(page);
  assert.equal(await kept(page), before);
  assert.deepEqual(errors.filter((text) => !/fetched/.test(text)), []);
  await context.close();
});

test('without any room, or any storage, the page says so and works', { timeout: 240_000 }, async () => {
  const { page, context } = await withoutRoom(['works']);
  await page.keyboard.press('Digit3');
  await noticed(page, 'storageFull');
  await page.locator('.saving[data-saving="failed"]').waitFor();
  await page.keyboard.press('Digit1');
  assert.equal((await records(page, 'projects')).length, 0, 'nothing is kept by halves');
  await context.close();

  const { page: shut, context: private_ } = await open('about:blank');
  await shut.addInitScript(() => {
    for (const name of ['indexedDB', 'localStorage', 'sessionStorage']) {
      Object.defineProperty(window, name, { get: () => {
        throw new DOMException('keeps nothing', 'SecurityError');
      } });
    }
  });
  const errors = [];
  shut.on('pageerror', (error) => errors.push(String(error)));
  await shut.goto(site.url);
  await settled(shut);
  await shut.keyboard.press('Digit2');
  await noticed(shut, 'keepsNothing');
  assert.equal(await shut.locator('.saving b').innerText(), 'Not kept');
  await shut.locator('.message .icon-button').click();
  await shut.keyboard.press('Digit3');
  assert.equal((await state(shut)).notice, null, 'told once');
  assert.deepEqual(errors, []);
  await private_.close();
});

test('a damaged record is told of and left as it is', { timeout: 240_000 }, async () => {
  const { page, context, errors } = await open();
  await settled(page);
  await page.keyboard.press('Digit3');
  await saved(page);
  const [good] = await records(page, 'works');
  const bad = [
    'text', { ...good.work, found: { ...good.work.found, task: {} } },
    { ...good.work, edits: { 0: { assignments: { squat_deg: 'much' } } } },
  ];
  for (const damaged of bad) {
    await page.evaluate((record) => new Promise((done) => {
      const request = indexedDB.open('shigusa');
      request.onsuccess = () => {
        const transaction = request.result.transaction('works', 'readwrite');
        transaction.objectStore('works').put(record);
        transaction.oncomplete = () => {
          request.result.close();
          done();
        };
      };
    }), { id: good.id, work: damaged });
    await page.reload();
    await settled(page);
    await page.waitForFunction(() => window.shigusa.state.notice?.kind === 'failure');
    assert.match(await page.locator('.message').innerText(), /Untitled/, JSON.stringify(damaged));
    assert.equal((await state(page)).status, 'reached');
  }
  await page.keyboard.press('Digit2');
  await saved(page);
  const works = await records(page, 'works');
  assert.deepEqual(works.find(({ id }) => id === good.id).work, bad.at(-1));
  assert.equal(works.length, 2);
  assert.deepEqual(errors, []);
  await context.close();
});
