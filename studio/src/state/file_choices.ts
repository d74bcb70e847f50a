// SPDX-License-Identifier: MIT
// How motions leave in files, as a person has chosen.
import type { Character, ExportOptions } from '../../../bindings/wasm/src/types';
import type { FileChoices, State } from './model';

export function exportOptions({ fps, files }: State, character: Character): ExportOptions {
  const options: ExportOptions = { fps };
  if (files.clip !== '') options.clip = files.clip;
  if (files.inPlace) options.in_place = true;
  // a character's file has names of its own
  if (files.jointNames !== 'own' && !character.bytes) options.joint_names = files.jointNames;
  return options;
}

/** What the animation of a motion is called that the page itself writes; `number` from 1. */
export function clipName({ clip, together }: FileChoices, number: number): string {
  if (clip === '') return together ? `shigusa ${number}` : 'shigusa';
  return together ? `${clip} ${number}` : clip;
}
