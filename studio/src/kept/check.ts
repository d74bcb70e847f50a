// SPDX-License-Identifier: MIT
// Rules for the validation of untrusted data; a SyntaxError names the place and the values allowed.

export const kFarthest = 100; // m

export type Fields = Record<string, unknown>;

export function need(holds: boolean, place: string, allowed: string): asserts holds {
  if (!holds) throw new SyntaxError(`${place} must be ${allowed}`);
}

export function fieldsOf(value: unknown, place: string): Fields {
  need(typeof value === 'object' && value !== null && !Array.isArray(value), place, 'an object { … }');
  return value as Fields;
}
