// SPDX-License-Identifier: MIT
// A document as a task file, and links of earlier versions, which carry one.
import type { Facts, Task } from '../../../bindings/wasm/src/types';
import { ownMixture, sameWeights } from './criteria';
import type { Document, SearchSettings } from './model';

/** Motions that a drag's search may score: enough to see how the body goes, few enough to follow the hand. */
const kPreviewEvaluations = 16;

/** What a task says of the search of its preset. */
const kOfSearches = new Set(['search', 'layer_reading', 'generator', 'pareto']);

export function withPreset(settings: SearchSettings, preset: SearchSettings['preset']): SearchSettings {
  const more = Object.fromEntries(Object.entries(settings.more).filter(([key]) => !kOfSearches.has(key)));
  return { ...settings, preset, more };
}

/** What the page itself has a place for. */
const kKnown = new Set(['version', 'character', 'goals', 'preset', 'seed', 'evaluations', 'duration_s', 'fixed']);

/** All else that a task says, which is carried along. */
export function moreOf(task: Task): Partial<Task> {
  return Object.fromEntries(Object.entries(task).filter(([key]) => !kKnown.has(key)));
}

export function taskOf(facts: Facts, document: Document): Task {
  const { criteria, ...more } = document.settings.more;
  const task: Task = { ...more, version: 1, goals: document.goals.map((goal) => ({ ...goal })), preset: document.settings.preset };
  if (document.settings.seed !== 0) task.seed = document.settings.seed;
  if (document.settings.evaluations !== null) task.evaluations = document.settings.evaluations;
  if (document.settings.duration_s !== null) task.duration_s = document.settings.duration_s;
  if (document.fixed.length > 0) task.fixed = [...document.fixed];
  if (typeof criteria === 'object' || !sameWeights(document.weights, ownMixture(facts, document))) {
    const told: Record<string, object | undefined> = typeof criteria === 'object' ? { ...criteria } : {};
    task.criteria = Object.fromEntries(Object.entries(document.weights).map(([name, weight]) => [name, { ...told[name], weight }]));
  }
  return task;
}

export function previewTask(facts: Facts, document: Document): Task {
  const trial = { ...document, settings: withPreset(document.settings, facts.default_preset) };
  return { ...taskOf(facts, trial), candidates: 1, evaluations: kPreviewEvaluations };
}

/** The task with its character, complete: a file's person as measured, where a result tells. */
export function completeTask(facts: Facts, document: Document): Record<string, unknown> {
  const measured = document.result?.summary['task'] as { character?: unknown } | undefined;
  return { ...taskOf(facts, document), character: measured?.character ?? document.character.spec };
}

const kFragment = '#task=';

/** The task of a link; null if there is none. Throws a SyntaxError if it is damaged. */
export function taskOfLink(fragment: string): Task | null {
  if (!fragment.startsWith(kFragment)) return null;
  let text: string;
  try {
    text = atob(fragment.slice(kFragment.length).replaceAll('-', '+').replaceAll('_', '/'));
  } catch {
    throw new SyntaxError('not base64');
  }
  const bytes = Uint8Array.from(text, (letter) => letter.charCodeAt(0));
  const value: unknown = JSON.parse(new TextDecoder().decode(bytes));
  if (typeof value !== 'object' || value === null || !Array.isArray((value as Task).goals)) {
    throw new SyntaxError('no task');
  }
  return value;
}
