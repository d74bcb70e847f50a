// SPDX-License-Identifier: MIT
// The characters that were opened, beside one another.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { source } from './source.mjs';

const { Workbench } = await source('state/workbench.ts');

const of = (name, size = 0) => ({
  character: { spec: { source: name }, description: {}, ...(size > 0 && { bytes: new Uint8Array(size) }) }, goals: [], settings: {}, edits: {}, chosen: 0, result: null,
});

/** A workbench and the names of the characters that its engine has let go of. */
function opened(...documents) {
  const closed = [];
  const workbench = new Workbench({ close: ({ spec }) => closed.push(spec.source) });
  for (const document of documents) workbench.commit(document);
  return { workbench, closed, names: () => workbench.store.state.shelf.map(({ character }) => character.spec.source) };
}

test('what is put beside the one at hand leaves that, and is there once', () => {
  const { workbench, closed, names } = opened(of('human'), of('a.glb', 3));
  assert.equal(workbench.shelve(of('b.glb', 3)), true);
  assert.deepEqual(names(), ['human', 'a.glb', 'b.glb']);
  assert.equal(workbench.document.character.spec.source, 'a.glb');
  const before = workbench.store.state.shelf;
  assert.equal(workbench.shelve(of('b.glb', 3)), true, 'it is there');
  assert.equal(workbench.store.state.shelf, before, 'with what was last done with it');
  assert.deepEqual(closed, ['b.glb'], 'the second copy is let go of');
});

test('where there is no room it is refused, and none of those there gives way', () => {
  const { workbench, closed, names } = opened(of('human'));
  for (let k = 1; k < 12; ++k) assert.equal(workbench.shelve(of(`${k}.bvh`, 1)), true);
  assert.equal(workbench.shelve(of('late.bvh', 1)), false);
  assert.equal(names().length, 12);
  assert.deepEqual([names()[0], closed], ['human', ['late.bvh']]);
  const { workbench: other } = opened(of('large.glb', 299e6));
  assert.equal(other.shelve(of('more.glb', 2e6)), false, 'too many bytes');
  // what is opened, not put beside, takes the place of the oldest
  workbench.commit(of('shown.bvh', 1));
  assert.deepEqual([names().length, names()[0], names().at(-1)], [12, '1.bvh', 'shown.bvh']);
});
