// SPDX-License-Identifier: MIT
// All motions by another timing: the same parameters in a task that says so. Nothing is searched.
import type { Summary, Task } from '../../../bindings/wasm/src/types';
import type { Edit } from './model';
import type { Studio } from './studio';

export type Timed = Partial<Pick<Task, 'ease' | 'gaze_lead'>>;

function timed(summary: Summary, timing: Timed): Summary {
  return { ...summary, task: { ...(summary['task'] as Task), ...timing } };
}

/** Shows a preview of the chosen motion, if still wanted; keepTiming makes it permanent. */
export async function tryTiming(studio: Studio, timing: Timed, isWanted: () => boolean): Promise<void> {
  const { document } = studio;
  if (!document?.result) return;
  const edited = document.edits[document.chosen]?.generated.summary;
  const [summary, candidate] = edited ? [edited, 1] : [document.result.summary, document.chosen + 1];
  try {
    const generated = await studio.engine.replay(document.character, timed(summary, timing), candidate, []);
    if (generated && studio.document === document && isWanted()) studio.store.set({ preview: generated.candidates[0] ?? null, previewRemaining_mm: 0 });
  } catch (error) {
    studio.fail(error);
  }
}

/** Keeps it for all motions, edited ones too. */
export async function keepTiming(studio: Studio, timing: Timed): Promise<void> {
  const { document } = studio;
  if (!document?.result) return;
  try {
    const result = await studio.restore(document.character, timed(document.result.summary, timing));
    const edits: Record<number, Edit> = {};
    for (const [index, edit] of Object.entries(document.edits)) {
      const generated = await studio.restore(document.character, timed(edit.generated.summary, timing));
      edits[Number(index)] = { ...edit, base: { ...edit.base, summary: timed(edit.base.summary, timing) }, generated };
    }
    if (studio.document !== document) return;
    const settings = { ...document.settings, more: { ...document.settings.more, ...timing } };
    studio.commit({ ...document, settings, result, edits });
  } catch (error) {
    studio.fail(error);
  } finally {
    studio.store.set({ preview: null });
  }
}
