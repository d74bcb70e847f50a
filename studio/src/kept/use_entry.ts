// SPDX-License-Identifier: MIT
// Applies an entry of the library to the open project, as one step.
import type { Character } from '../../../bindings/wasm/src/types';
import { openCharacter } from '../state/files';
import type { Document } from '../state/model';
import { thingsOf, withGoal, withThings } from '../state/places';
import { effectorsOf } from '../state/start';
import type { Studio } from '../state/studio';
import { previewTask } from '../state/task';
import type { Entry, StartPosture } from './library';

export function startOfSpec({ spec: { source, animation, frame, seat_m, heels } }: Character): StartPosture {
  return { source, animation, frame, seat_m, heels };
}

export async function useEntry(studio: Studio, entry: Entry): Promise<void> {
  const { document } = studio;
  if (!document) return;
  await (entry.kind === 'goals' ? useGoals(studio, document, entry) : useStart(studio, document, entry));
}

/** Goals of effectors that this body has not are left out. */
async function useGoals(studio: Studio, document: Document, { name, goals, things }: Extract<Entry, { kind: 'goals' }>): Promise<void> {
  const known = new Set(effectorsOf(document.character));
  const possible = goals.filter(({ effector }) => known.has(effector));
  if (possible.length === 0) return studio.tell({ kind: 'text', key: 'unknownGoals', values: { name } });
  const bare = withThings({ ...document, goals: [] }, structuredClone(things));
  const asked = possible.reduce((all, goal) => withGoal(all, structuredClone(goal)), withoutLostSupport(bare, document));
  // reports the engine's refusal before any change
  await studio.engine.preview(document.character, previewTask(studio.facts, asked));
  if (studio.document === document) await studio.settle(asked);
}

/** Hands rest no more on things that are gone. */
function withoutLostSupport(document: Document, before: Document): Document {
  const names = (of: Document): Set<string | undefined> => new Set(thingsOf(of).map(({ name }) => name));
  const now = names(document);
  const gone = new Set([...names(before)].filter((name) => !now.has(name)));
  const { support, ...more } = document.settings.more;
  const left = support?.filter(({ on }) => !gone.has(on)) ?? [];
  return { ...document, settings: { ...document.settings, more: left.length > 0 ? { ...more, support: left } : more } };
}

async function useStart(studio: Studio, { character: { spec, bytes } }: Document, { name, start }: Extract<Entry, { kind: 'start' }>): Promise<void> {
  const { source, ...posture } = start;
  const isOfFile = posture.animation !== undefined || posture.frame !== undefined;
  if (isOfFile && source !== spec.source) return studio.tell({ kind: 'text', key: 'otherPosture', values: { name, source } });
  await openCharacter(studio, { ...spec, ...posture }, bytes);
}
