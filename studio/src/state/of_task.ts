// SPDX-License-Identifier: MIT
// The document that a task asks for.
import type { Character, Facts, Task } from '../../../bindings/wasm/src/types';
import { weightsOf } from './criteria';
import type { Document, SearchSettings } from './model';
import { newDocument } from './start';
import { moreOf, previewTask } from './task';
import type { Workbench } from './workbench';

export function documentOf(facts: Facts, character: Character, task: Task): Document {
  const settings: SearchSettings = {
    preset: task.preset ?? facts.default_preset,
    seed: task.seed ?? 0,
    evaluations: task.evaluations ?? null,
    duration_s: task.duration_s ?? null,
    more: moreOf(task),
  };
  const goals = structuredClone(task.goals ?? []);
  return { ...newDocument(facts, character, goals), settings, weights: weightsOf(facts, task), fixed: task.fixed ?? [] };
}

/** The same of a task that the engine takes: a quick search says what it refuses, before the page draws any of it. */
export async function checkedDocumentOf({ facts, engine }: Workbench, character: Character, task: Task): Promise<Document> {
  const document = documentOf(facts, character, task);
  await engine.preview(character, previewTask(facts, document));
  return document;
}
