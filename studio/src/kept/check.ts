// SPDX-License-Identifier: MIT
// The page checks by these rules what others may have written; a SyntaxError names the place, and what is allowed there.

export const kFarthest = 100; // m

export type Fields = Record<string, unknown>;

export function need(holds: boolean, place: string, allowed: string): asserts holds {
  if (!holds) throw new SyntaxError(`${place} must be ${allowed}`);
}

export function fieldsOf(value: unknown, place: string): Fields {
  need(typeof value === 'object' && value !== null && !Array.isArray(value), place, 'an object { … }');
  return value as Fields;
}
