// SPDX-License-Identifier: MIT
// The page reads the engine's table of file formats here.
import type { Character, CharacterSpec, Facts, FormatFacts } from '../../../bindings/wasm/src/types';

export const endingOf = (name: string): string => `.${name.toLowerCase().split('.').pop() ?? ''}`;

const isCharacters = (format: FormatFacts): boolean => format.person || format.robot;

/** Whether a character needs no file. */
export function isBuiltIn(facts: Facts, spec: CharacterSpec): boolean {
  return facts.bodies.some(({ name }) => name === spec.source);
}

/** The format of a character's file by its name; undefined where characters are read from no such file. */
export function characterFormat(facts: Facts, name: string): FormatFacts | undefined {
  return facts.formats.find((format) => isCharacters(format) && format.endings.includes(endingOf(name)));
}

/** Whether a character's own file is of a kind that a format needs. */
export function hasNeeded(facts: Facts, format: FormatFacts, character: Character): boolean {
  if (format.needs.length === 0) return true;
  const own = character.bytes && characterFormat(facts, character.spec.source);
  return own !== undefined && format.needs.includes(own.name);
}

/** What a person picks characters by: ".bvh,.glb". */
export function characterEndings(facts: Facts): string[] {
  return facts.formats.filter(isCharacters).flatMap((format) => format.endings);
}

/** "BVH, GLB, VRM" */
export function characterFormats(facts: Facts): string {
  return facts.formats.filter(isCharacters).map(({ name }) => name.toUpperCase()).join(', ');
}
