// SPDX-License-Identifier: MIT
// The engine's sentences in the page's language.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { saved } from './kept.mjs';
import { drop, linkTo, openStudio, openTab, settled, visit } from './support.mjs';

const { site, browser } = await visit();

const wrong = [
  ['empty.glb', '', /ファイルが空です/],
  ['letter.bvh', 'Dear reader', /HIERARCHY のはずの箇所に/],
  ['old.gltf', JSON.stringify({ asset: { version: '1.0' } }), /glTF のバージョンが "1.0" です/],
  ['bare.gltf', JSON.stringify({ asset: { version: '2.0' } }), /ノードがないため/],
  ['lone.gltf', JSON.stringify({ asset: { version: '2.0' }, nodes: [{ name: 'a' }] }), /骨格がありません：ノードが一つだけです/],
  ['wrong.json', JSON.stringify({ version: 1, goals: [{ effector: 'tail', position_m: [0, 1, 0] }] }), /動かす部位「tail」はありません。.*使えるもの：/],
  ['key.json', JSON.stringify({ version: 1, goals: [{ effector: 'right_hand', position_m: [0, 1, 0], lod_kg: 1 }] }), /キー「lod_kg」はありません。「load_kg」ですか？/],
  ['far.json', JSON.stringify({ version: 1, goals: [{ effector: 'right_hand', position_m: [0, 'up', 0] }] }), /\[0,"up",0\] です。-100～100 の数 3 個/],
  ['bomb.urdf', '<!DOCTYPE a [<!ENTITY b "c">]><robot/>', /line 1 of bomb\.urdf：定義付きの文書型宣言は読めません/],
  ['other.urdf', '<mujoco/>', /MJCF ファイルで、\.urdf ファイルではありません/],
  ['lone.urdf', '<robot name="r"><link name="a"/></robot>', /人型ロボットではありません：.*ノードが一つだけです/],
  ['low.json', JSON.stringify({ version: 1, goals: [{ effector: 'left_foot', position_m: [0.1, 0.02, 0.3] }] }), /左足の目標：高さ 2 cm では足裏が床より 4\.8 cm 下になります。この向きでは 6\.8 cm 以上/],
];

test('what the engine refuses is told in Japanese, with its numbers, and lengths in the unit that is chosen', { timeout: 180_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url, { locale: 'ja-JP' });
  await settled(page);
  const lacking = await page.evaluate(async () => (await window.shigusa.untranslated('ja')).filter((word) => word.startsWith('messages')));
  assert.deepEqual(lacking, []);
  for (const [name, bytes, said] of wrong) {
    await page.evaluate(() => document.querySelector('.message .icon-button')?.click());
    await page.waitForFunction(() => window.shigusa.state.notice === null);
    await drop(page, name, Buffer.from(bytes));
    await page.waitForFunction(() => window.shigusa.state.notice?.kind === 'failure' && !window.shigusa.state.opening, undefined, { timeout: 60_000 });
    assert.match(await page.locator('.message').innerText(), said, name);
  }
  await page.click('.view-opener');
  await page.locator('[data-view="lengths"]').selectOption('in');
  assert.match(await page.locator('.message').innerText(), /高さ 0\.79 in では足裏が床より 1\.\d+ in 下になります。この向きでは 2\.68 in 以上/);
  await page.locator('.topbar select').last().selectOption('en');
  await page.waitForFunction(() => document.documentElement.lang === 'en');
  assert.match(await page.locator('.message').innerText(), /is 0\.79 in high, and its sole would end 1\.\d+ in below the floor; allowed are 2\.68 in/);
  assert.deepEqual(errors, []);
  await context.close();
});

test('doubts about a robot are in Japanese', { timeout: 120_000 }, async () => {
  const { page, context, errors } = await openStudio(browser, site.url, { locale: 'ja-JP' });
  await settled(page);
  for (const [name, path] of [['small.urdf', 'urdf_corpus/small_robot.urdf'], ['maker.xml', 'mjcf_corpus/maker.xml']]) {
    await drop(page, name, readFileSync(new URL(`../../tests/fuzz/${path}`, import.meta.url)));
    await page.waitForFunction((file) => window.shigusa.document.character.spec.source === file, name, { timeout: 60_000 });
    await settled(page);
    await openTab(page, 'body');
    const doubts = await page.locator('#panel-body li', { hasNot: page.locator('button') }).allInnerTexts();
    assert.ok(doubts.length > 0, name);
    for (const doubt of doubts) assert.match(doubt, /[ぁ-ん].*。/, `${name}: ${doubt}`);
  }
  assert.deepEqual(errors, []);
  await context.close();
});

test('why there are fewer motions is told in Japanese, after a reload too', { timeout: 120_000 }, async () => {
  const task = { character: { source: 'human' }, goals: [{ effector: 'right_hand', position_m: [-0.2, 0.05, 0.35] }], candidates: 12 };
  const { page, context, errors } = await openStudio(browser, linkTo(site, task), { locale: 'ja-JP' });
  const told = /^候補は 12 個のうち \d+ 個です。/;
  const why = /ほかの動作: .*\d+ 個が、.*もの。$/;
  await settled(page);
  assert.match(await page.locator('.gallery > p').last().innerText(), told);
  assert.match(await page.locator('.gallery > p').last().getAttribute('title'), why);
  await saved(page);
  await page.reload();
  await settled(page);
  assert.match(await page.locator('.gallery > p').last().innerText(), told);
  assert.match(await page.locator('.gallery > p').last().getAttribute('title'), why);
  assert.deepEqual(errors, []);
  await context.close();
});
