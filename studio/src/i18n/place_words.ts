// SPDX-License-Identifier: MIT
// The names of goals and things, as people say them.
import type { Document } from '../state/model';
import { lookName, thingOf, thingsOf } from '../state/places';
import { jointName, t } from '.';

/** The name of a thing in the way; the task may have none for it. */
export function thingWords(document: Document, index: number): string {
  return thingsOf(document)[index]?.name ?? `${t('thing')} ${index + 1}`;
}

export function placeWords(document: Document, name: string): string {
  if (name === lookName) return t('looksAt');
  const index = thingOf(name);
  return index === null ? jointName(name) : thingWords(document, index);
}
