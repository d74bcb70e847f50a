// SPDX-License-Identifier: MIT
// What the page says is of the page: no option of a command line, and controls by the names that they have.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { source } from './source.mjs';

const folder = (path) => fileURLToPath(new URL(path, import.meta.url));
const { en } = await source('i18n/en.ts');
const { englishMessages } = await source('i18n/messages_en.ts');
const { noticeTones } = await source('i18n/notice_tones.ts');
const { ja, japaneseMessages } = await source('i18n/japanese.ts');

const kOption = /--[a-z]/i;

/** The engine's sentences by their keys, from its catalogue. */
const engineMessages = Object.fromEntries(readdirSync(folder('../../src/core/messages')).flatMap((name) =>
  [...readFileSync(join(folder('../../src/core/messages'), name), 'utf8').matchAll(/MessageText\{\s*"(\w+)",\s*((?:"(?:[^"\\]|\\.)*"\s*)+)\}/g)]
    .map(([, key, texts]) => [key, [...texts.matchAll(/"((?:[^"\\]|\\.)*)"/g)].map(([, text]) => text).join('')])));

test('no sentence of the page names an option of the command line, in either language', () => {
  assert.ok(Object.keys(engineMessages).length > 300 && kOption.test(engineMessages.heels_no_toes), 'the catalogue is read');
  for (const [key, text] of Object.entries(engineMessages)) assert.doesNotMatch(englishMessages[key] ?? text, kOption, key);
  for (const words of [en, ja, japaneseMessages]) {
    assert.ok(Object.keys(words).length > 200);
    for (const [key, text] of Object.entries(words)) assert.doesNotMatch(text, kOption, key);
  }
  for (const path of readdirSync(folder('../src/i18n'), { recursive: true }).filter((name) => name.endsWith('.ts'))) {
    assert.doesNotMatch(readFileSync(join(folder('../src/i18n'), path), 'utf8'), kOption, path);
  }
});

test('the page’s own words for the engine’s sentences have their values, and name controls that are there', () => {
  const holes = (text) => new Set(text.match(/\{\d\}/g)).size;
  for (const [key, text] of Object.entries(englishMessages)) {
    assert.match(engineMessages[key] ?? '', kOption, `${key} needs other words`);
    assert.equal(holes(text), engineMessages[key].match(/\{[^{}]*\}/g)?.length ?? 0, key);
    for (const [, name] of text.matchAll(/“([^”]+)”/g)) assert.ok(Object.values(en).includes(name), `${key}: ${name}`);
    for (const [, name] of japaneseMessages[key].matchAll(/「([^」{]+)」/g)) assert.ok(Object.values(ja).includes(name), `${key}: ${name}`);
  }
});

test('what is lost, refused or fails is told in red', () => {
  const bad = new Set(Object.keys(noticeTones).filter((key) => noticeTones[key] === 'bad'));
  for (const key of ['storageFull', 'storageFailed', 'keepsNothing', 'fileTooLarge', 'partFailed', 'unreachable', 'badLink', 'unknownFile', 'changedFile', 'noRoom']) assert.ok(bad.has(key), key);
  for (const key of ['saved', 'linkCopied', 'cancelled', 'alsoKept', 'pictureBack']) assert.ok(!bad.has(key), key);
});
