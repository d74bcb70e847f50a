// SPDX-License-Identifier: MIT
// The criteria's names and weights (docs/criteria.md).
import type { Candidate, Task } from '../../../bindings/wasm/src/types';
import { candidateAt, type Document } from './model';

/** The mixture `default`; what is 0 is not computed. */
export const defaultWeights: Readonly<Record<string, number>> = {
  joint_range: 0.25,
  balance_zone: 0.2,
  discomfort: 0.27,
  joint_acceleration: 0.22,
  low_back: 0.2,
  collision: 0.5,
  centre_of_pressure: 0.35,
  feasibility: 1,
  balance: 0,
  torque: 0,
  work: 0,
  head: 0,
};

const kNothing = Object.fromEntries(Object.keys(defaultWeights).map((name) => [name, 0]));
/** The mixtures that tasks name. */
const kMixtures: Readonly<Record<string, Readonly<Record<string, number>>>> = {
  default: defaultWeights,
  paper: { ...kNothing, joint_range: 0.5, balance: 0.3, torque: 0.2 },
  pareto: { ...kNothing, balance: 1 / 3, torque: 1 / 3, discomfort: 1 / 3 },
};

/** The weights of a task: what it says of some, and of the others its preset's own. */
export function weightsOf({ criteria, preset }: Task): Record<string, number> {
  const own = preset === 'paper' || preset === 'layers' ? 'paper' : 'default';
  const weights = { ...kMixtures[typeof criteria === 'string' ? criteria : own] ?? defaultWeights };
  for (const [name, entry] of Object.entries(typeof criteria === 'object' ? criteria : {})) {
    const weight = (entry as { weight?: unknown } | null)?.weight;
    if (typeof weight === 'number') weights[name] = weight;
  }
  return weights;
}

export function sameAsDefault(weights: Readonly<Record<string, number>>): boolean {
  return Object.keys(defaultWeights).every((name) => (weights[name] ?? 0) === defaultWeights[name]);
}

/** Σ weight · penalty, lower is better. What a motion was not scored by counts nothing: search again to know it. */
export function scoreOf(candidate: Candidate, weights: Readonly<Record<string, number>>): number {
  let sum = 0;
  for (const [name, penalty] of Object.entries(candidate.summary.criteria)) sum += (weights[name] ?? 0) * penalty;
  return sum;
}

/** Criteria that have a weight now and that the motions at hand were not scored by. */
export function unknownCriteria(document: Document): string[] {
  const known = document.result?.candidates[0]?.summary.criteria ?? {};
  return Object.keys(document.weights).filter((name) => (document.weights[name] ?? 0) > 0 && !(name in known));
}

/** Indices of the candidates: what is impossible after all others, and of each the lowest score first. */
export function ranking(document: Document): number[] {
  const count = document.result?.candidates.length ?? 0;
  const isImpossible = (index: number): number => Number(candidateAt(document, index)?.summary.verdict === 'impossible');
  const scores = Array.from({ length: count }, (_, index) => {
    const candidate = candidateAt(document, index);
    return candidate === null ? Infinity : scoreOf(candidate, document.weights);
  });
  return scores.map((_, index) => index).sort((a, b) => isImpossible(a) - isImpossible(b) || (scores[a] ?? 0) - (scores[b] ?? 0) || a - b);
}
