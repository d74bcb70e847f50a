// SPDX-License-Identifier: MIT
// A work within a result's JSON, in its field `studio`. The result's own candidates are the motions, edited ones as
// they are edited, so that other programs read the same; beside each edit stands what was found before it.
import type { Summary } from '../../../bindings/wasm/src/types';
import { readWork, type StoredEdit, type StoredMotions, type Work } from './work';

type Found = StoredMotions['candidates'][number];

export function studioField({ found, ...work }: Work): object {
  const edits = Object.entries(work.edits).map(([index, edit]) => [index, { ...edit, found: found?.candidates[Number(index)] }]);
  return { ...work, edits: Object.fromEntries(edits) };
}

/** The work of a result; null where it has none, or one that is not of its candidates. */
export function workOfResult({ studio, task, candidates }: Summary): Work | null {
  if (typeof studio !== 'object' || studio === null) return null;
  const { edits } = studio as { edits?: Record<string, (StoredEdit & { found?: Found }) | null> };
  const motions = candidates.map(({ parameters }, index) => edits?.[index]?.found ?? { parameters });
  try {
    return readWork({ ...studio, found: { version: 1, task, candidates: motions } });
  } catch {
    return null;
  }
}
