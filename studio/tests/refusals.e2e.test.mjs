// SPDX-License-Identifier: MIT
// What the page refuses: browsers that cannot run it, and seeds that are none.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { hear, openStudio, settled, state, visit } from './support.mjs';

const { site, browser } = await visit();

const lacks = {
  SIMD: () => {
    WebAssembly.validate = () => false;
  },
  'WebGL 2': () => {
    HTMLCanvasElement.prototype.getContext = () => null;
  },
};

for (const [name, take] of Object.entries(lacks)) {
  test(`a browser without ${name} is told what is missing`, { timeout: 60_000 }, async () => {
    const context = await browser.newContext({ viewport: { width: 1280, height: 720 } });
    const page = await context.newPage();
    const errors = [];
    hear(page, errors);
    page.on('pageerror', (error) => errors.push(String(error)));
    await page.addInitScript(take);
    await page.goto(site.url);
    assert.ok((await page.locator('.refused').innerText()).includes(name));
    assert.equal(await page.locator('[role="alert"]').count(), 1);
    assert.equal(page.workers().length, 0, 'no engine is started');
    if (process.env.SHIGUSA_SHOTS) await page.screenshot({ path: `${process.env.SHIGUSA_SHOTS}/without ${name}.png` });
    assert.deepEqual(errors, []);
    await context.close();
  });
}

test('a seed is a whole number below 2^53', { timeout: 120_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url);
  await settled(page);
  const field = page.locator('[data-key="seed"]');
  const type = async (text) => {
    await field.fill(text);
    await field.press('Enter');
  };
  const seed = () => page.evaluate(() => window.shigusa.document.settings.seed);
  for (const text of ['1e3', '9007199254740993']) {
    await type(text);
    await page.waitForFunction(() => window.shigusa.state.notice?.key === 'badSeed');
    assert.ok((await page.locator('.message').innerText()).includes('9007199254740991'), text);
    assert.equal(await seed(), 0, text);
    assert.equal(await field.inputValue(), '0', text);
    await page.locator('.message .icon-button').click();
  }
  await type('9007199254740991');
  await page.waitForFunction(() => window.shigusa.document.settings.seed === Number.MAX_SAFE_INTEGER);
  await settled(page);
  assert.equal((await state(page)).status, 'reached');
  assert.equal(await page.evaluate(() => window.shigusa.document.result.summary.task.seed), Number.MAX_SAFE_INTEGER, 'the engine had it whole');
  await page.getByRole('button', { name: 'Search with a new seed' }).click();
  await page.waitForFunction(() => window.shigusa.document.settings.seed === 0);
  await settled(page);
  assert.deepEqual(errors, []);
  await context.close();
});
