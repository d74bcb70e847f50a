// SPDX-License-Identifier: MIT
// Links and libraries that others may have damaged are refused with a reason, and good ones come back whole: without a browser.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { deflateRawSync } from 'node:zlib';
import { sources } from './source.mjs';

const { linkOf, workOfLink, readLibrary } = await sources('kept/link', 'kept/library');

const goal = { effector: 'right_hand', position_m: [0.2, 0.9, 0.4] };
const kWork = {
  version: 1, character: { spec: { source: 'human' }, sha256: '' }, task: { goals: [goal] }, chosen: 0, compared: null,
  found: { version: 1, task: { goals: [goal] }, candidates: [{ parameters: { weights: {} } }] }, edits: { 0: { assignments: { squat_deg: '30' } } },
  picture: { tab: 'goals', selected: 'right_hand', compareMode: 'beside', overlays: true, speed: 1, playing: true, time_s: 0, fps: 60, look: { position_m: [0, 1, 3], target_m: [0, 1, 0] } },
};
const kBegin = '#work=1.';
const packed = (text) => kBegin + deflateRawSync(Buffer.from(text)).toString('base64url');
const changed = (change) => packed(JSON.stringify({ ...kWork, ...change }));
const picture = (change) => changed({ picture: { ...kWork.picture, ...change } });

test('a link brings a work back, and none is made of one that is too large', async () => {
  const link = await linkOf(kWork, 'https://example.org/page/#old');
  assert.ok(link.startsWith(`https://example.org/page/${kBegin}`));
  assert.deepEqual(await workOfLink(new URL(link).hash), kWork);
  assert.equal(await workOfLink('#task=x'), null);
  const noise = Array.from({ length: 20_000 }, (_, k) => Math.sin(k)); // nothing to be deflated
  assert.equal(await linkOf({ ...kWork, task: { goals: [goal], noise } }, 'https://example.org/'), null);
});

const kBadLinks = {
  letters: `${kBegin}%%%`,
  cut: packed(JSON.stringify(kWork)).slice(0, 150),
  'not deflated': kBegin + Buffer.from(JSON.stringify(kWork)).toString('base64url'),
  'too large': packed(' '.repeat(5_000_000)),
  deep: packed(`${'['.repeat(100_000)}${']'.repeat(100_000)}`),
  'deep within': packed(JSON.stringify(kWork).replace('"version":1', `"version":1,"more":${'['.repeat(500)}${']'.repeat(500)}`)),
  'no work': packed('[]'),
  version: changed({ version: 2 }),
  choice: changed({ chosen: 99 }),
  compared: changed({ compared: 0.5 }),
  'no task': changed({ task: { goals: 1 } }),
  'no motions': changed({ found: { ...kWork.found, candidates: [] } }),
  'number as text': changed({ edits: { 0: { assignments: { squat_deg: 3 } } } }),
  'edit of no motion': changed({ edits: { 7: { assignments: {} } } }),
  digest: changed({ character: { spec: { source: 'human' }, sha256: 'x' } }),
  tab: picture({ tab: 'x' }),
  look: picture({ look: { position_m: [0, 1, 1e9], target_m: [0, 0, 0] } }),
  view: picture({ view: { ghosts: 1e6 } }),
  speed: picture({ speed: 0 }),
  message: changed({ fewer: { text: 'x', key: 'y' } }),
};
for (const [name, hash] of Object.entries(kBadLinks)) {
  test(`a link with a wrong part is refused: ${name}`, async () => {
    await assert.rejects(workOfLink(hash), SyntaxError);
  });
}

const good = { name: 'Good', kind: 'goals', goals: [goal], things: [] };
const library = (...entries) => JSON.stringify({ shigusa_library: 1, entries });
const second = (change) => library(good, { ...good, ...change });
const kBadLibraries = [
  '', '{', '[]', 'null', '"text"', '{}', JSON.stringify({ shigusa_library: 2, entries: [good] }), '{"shigusa_library":1,"entries":{}}', library(),
  library(...Array.from({ length: 201 }, () => good)), '['.repeat(100_000),
  second({ name: '' }), second({ name: 7 }), second({ name: 'x'.repeat(81) }), second({ kind: 'film' }), second({ kind: undefined }), second({ goals: [] }), second({ goals: [null] }),
  second({ goals: [goal, goal] }), second({ goals: [{ ...goal, position_m: [0, 1] }] }), second({ goals: [{ ...goal, position_m: [0, 1e9, 0] }] }),
  second({ goals: [{ ...goal, position_m: [0, null, 0] }] }), second({ goals: [{ ...goal, rotation_xyzw: 'up' }] }), second({ things: [{}] }), second({ things: 'box' }),
  second({ things: [{ position_m: [0, 0, 0], size_m: [1] }] }), second({ picture: 'https://example.org/x.png' }), second({ picture: `data:image/png;base64,${'A'.repeat(60_001)}` }),
  second({ kind: 'start' }), second({ kind: 'start', start: { source: 'human', frame: 1.5 } }), second({ kind: 'start', start: { source: 'human', seat_m: '1' } }),
  second({ kind: 'start', start: { source: '', heels: true } }), second({ kind: 'start', start: { source: 'human', heels: 'yes' } }),
];

test('a damaged library is refused, a good one is read', () => {
  for (const text of kBadLibraries) assert.throws(() => readLibrary(text), SyntaxError, text.slice(0, 200));
  assert.deepEqual(readLibrary(library(good)).map(({ name, goals }) => [name, goals]), [['Good', [goal]]]);
});
