// SPDX-License-Identifier: MIT
// Trials: the chosen candidate with other values of its parameters.
import type { Candidate } from '../../../bindings/wasm/src/types';
import type { Document, Edit } from './model';
import type { Studio } from './studio';

/** The motion that the chosen candidate's edits begin from, and these with further ones. The document has a result. */
export function assigned(document: Document, more: Edit['assignments']): { base: Edit['base']; all: Edit['assignments'] } {
  const old = document.edits[document.chosen];
  const base = old?.base ?? { summary: document.result!.summary, candidate: document.chosen + 1 };
  return { base, all: { ...old?.assignments, ...more } };
}

export function listed(assignments: Edit['assignments']): string[] {
  return Object.entries(assignments).map(([name, value]) => `${name}=${value}`);
}

/** A motion to be looked at alone; null where it cannot be played. Calls of one `slot` that wait give way to the newest. */
export async function trial(studio: Studio, assignments: Edit['assignments'], slot: string): Promise<Candidate | null> {
  const { document } = studio;
  if (!document?.result) return null;
  const { base, all } = assigned(document, assignments);
  try {
    const generated = await studio.engine.replay(document.character, base.summary, base.candidate, listed(all), slot);
    return generated?.candidates[0] ?? null;
  } catch {
    return null;
  }
}
