// SPDX-License-Identifier: MIT
// The opened characters, each with its last state, so that the user can return to one without its file.
import type { Character } from '../../../bindings/wasm/src/types';
import type { Document } from './model';

/** As many are kept, and as many bytes of their files; one that is opened beyond that takes the place of the oldest. */
const kMost = 12;
const kMostBytes = 300e6;

function sameBytes(a: Uint8Array, b: Uint8Array): boolean {
  return a === b || (a.length === b.length && a.every((byte, index) => byte === b[index]));
}

/** Whether two are of one file, or the same built-in body, in whatever size; one without its file may be of any file of its name. */
export function isSameFile(a: Character, b: Character): boolean {
  return a.spec.source === b.spec.source && (!a.bytes || !b.bytes || sameBytes(a.bytes, b.bytes));
}

export function hasRoom(shelf: readonly Document[]): boolean {
  return shelf.length <= kMost && shelf.reduce((sum, { character }) => sum + (character.bytes?.length ?? 0), 0) <= kMostBytes;
}

/** The shelf with a document in the place of the one of its character, or as the newest. */
export function shelved(shelf: readonly Document[], document: Document): readonly Document[] {
  const at = shelf.findIndex(({ character }) => isSameFile(character, document.character));
  if (at >= 0) return shelf[at] === document ? shelf : shelf.map((old, index) => (index === at ? document : old));
  const next = [...shelf, document];
  while (next.length > 1 && !hasRoom(next)) next.shift();
  return next;
}
