// SPDX-License-Identifier: MIT
// Motions are ranked by criteria (docs/criteria.md): the engine's mixtures, and weights of a person's own.
import type { Candidate, Facts, Task } from '../../../bindings/wasm/src/types';
import { candidateAt, type Document } from './model';

export type Weights = Readonly<Record<string, number>>;

/** The mixture of a task without criteria; criteria of weight 0 are not computed. */
export function mixtureOf(facts: Facts, task: { preset?: string; pareto?: unknown }): Weights {
  const preset = facts.presets.find(({ name }) => name === (task.preset ?? facts.default_preset));
  const name = task.pareto === true ? facts.pareto_mixture : preset?.mixture;
  return facts.mixtures[name ?? ''] ?? {};
}

/** The same of a document. */
export function ownMixture(facts: Facts, { settings }: Pick<Document, 'settings'>): Weights {
  return mixtureOf(facts, { preset: settings.preset, pareto: settings.more['pareto'] });
}

/** The weights of a task: its own where given, else its mixture's. */
export function weightsOf(facts: Facts, task: Task): Record<string, number> {
  const { criteria } = task;
  const named = typeof criteria === 'string' ? facts.mixtures[criteria] : undefined;
  const weights = { ...named ?? mixtureOf(facts, task) };
  for (const [name, entry] of Object.entries(typeof criteria === 'object' ? criteria : {})) {
    const weight = (entry as { weight?: unknown } | null)?.weight;
    if (typeof weight === 'number') weights[name] = weight;
  }
  return weights;
}

export function sameWeights(a: Weights, b: Weights): boolean {
  return Object.keys({ ...a, ...b }).every((name) => (a[name] ?? 0) === (b[name] ?? 0));
}

/** Σ weight · penalty, lower is better. What a motion was not scored by counts nothing: search again to know it. */
export function scoreOf(candidate: Candidate, weights: Weights): number {
  let sum = 0;
  for (const [name, penalty] of Object.entries(candidate.summary.criteria)) sum += (weights[name] ?? 0) * penalty;
  return sum;
}

/** Criteria that have a weight now and that the motions at hand were not scored by. */
export function unknownCriteria(document: Document): string[] {
  const known = document.result?.candidates[0]?.summary.criteria ?? {};
  return Object.keys(document.weights).filter((name) => (document.weights[name] ?? 0) > 0 && !(name in known));
}

/** Indices of the candidates: impossible ones last, each group by ascending score. */
export function ranking(document: Document): number[] {
  const count = document.result?.candidates.length ?? 0;
  const isImpossible = (index: number): number => Number(candidateAt(document, index)?.summary.verdict === 'impossible');
  const scores = Array.from({ length: count }, (_, index) => {
    const candidate = candidateAt(document, index);
    return candidate === null ? Infinity : scoreOf(candidate, document.weights);
  });
  return scores.map((_, index) => index).sort((a, b) => isImpossible(a) - isImpossible(b) || (scores[a] ?? 0) - (scores[b] ?? 0) || a - b);
}
