// SPDX-License-Identifier: MIT
// The engine's sentences in the page's language.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { drop, openStudio, settled, visit } from './support.mjs';

const { site, browser } = await visit();

const wrong = [
  ['empty.glb', '', /ファイルが空です/],
  ['letter.bvh', 'Dear reader', /HIERARCHY のはずの箇所に/],
  ['old.gltf', JSON.stringify({ asset: { version: '1.0' } }), /glTF のバージョンが "1.0" です/],
  ['bare.gltf', JSON.stringify({ asset: { version: '2.0' } }), /ノードがないため/],
  ['lone.gltf', JSON.stringify({ asset: { version: '2.0' }, nodes: [{ name: 'a' }] }), /骨格がありません：ノードが一つだけです/],
  ['bomb.urdf', '<!DOCTYPE a [<!ENTITY b "c">]><robot/>', /line 1 of bomb\.urdf：定義付きの文書型宣言は読めません/],
  ['other.urdf', '<mujoco/>', /<robot> のはずの箇所に <mujoco> があります/],
  ['lone.urdf', '<robot name="r"><link name="a"/></robot>', /人型ロボットではありません：.*ノードが一つだけです/],
  ['low.json', JSON.stringify({ version: 1, goals: [{ effector: 'left_foot', position_m: [0.1, 0.02, 0.3] }] }), /左足の目標：高さ 0\.020 m では足裏が床より 48 mm 下になります。この向きでは 0\.068 m 以上/],
];

test('what the engine refuses is told in Japanese, with its numbers', { timeout: 180_000 }, async () => {
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
    await page.click('#tab-body');
    const doubts = await page.locator('#panel-body li', { hasNot: page.locator('button') }).allInnerTexts();
    assert.ok(doubts.length > 0, name);
    for (const doubt of doubts) assert.match(doubt, /[ぁ-ん].*。/, `${name}: ${doubt}`);
  }
  assert.deepEqual(errors, []);
  await context.close();
});
