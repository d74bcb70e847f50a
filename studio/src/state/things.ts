// SPDX-License-Identifier: MIT
// Things in the way: how one comes and goes.
import type { Document } from './model';
import { thingsOf, withThings } from './places';
import { kAverageStature } from './start';

const kSide = 0.3; // m, of a new box
const kAhead = 0.7; // m, where it stands beside an average person
const kApart = 0.4; // m, from one that stands there already

/** A box on the floor ahead of the body, beside those that stand there; `word`: what things are called. */
export function withNewThing(document: Document, word: string): Document {
  const things = thingsOf(document);
  const names = new Set(things.map(({ name }) => name));
  let number = things.length + 1;
  while (names.has(`${word} ${number}`)) ++number;
  const ahead = (kAhead * document.character.description.stature_m) / kAverageStature;
  let left = 0;
  while (things.some(({ position_m: [x, , z] }) => Math.hypot(x - left, z - ahead) < kApart / 2)) left += kApart;
  return withThings(document, [...things, { name: `${word} ${number}`, position_m: [left, kSide / 2, ahead], size_m: [kSide, kSide, kSide] }]);
}

/** Without it, and without the hands that would rest on it. */
export function withoutThing(document: Document, index: number): Document {
  const things = thingsOf(document);
  const name = things[index]?.name ?? `obstacle ${index + 1}`;
  const rest = withThings(document, things.filter((_, k) => k !== index));
  const { support, ...more } = rest.settings.more;
  const left = support?.filter(({ on }) => on !== name) ?? [];
  return { ...rest, settings: { ...rest.settings, more: left.length === 0 ? more : { ...more, support: left } } };
}
