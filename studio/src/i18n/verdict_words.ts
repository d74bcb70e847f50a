// SPDX-License-Identifier: MIT
// The engine's verdict on a motion in words that people use.
import type { Candidate, Reason } from '../../../bindings/wasm/src/types';
import type { Document } from '../state/model';
import { fallOf, reasonsOf, shortOf, unturnedOf } from '../state/verdict';
import { axisName, inSentence, jointName, t } from '.';

/** A joint's freedom in a sentence by its joint alone. */
const jointOf = (freedom = ''): string => inSentence(jointName(freedom.split('.')[0]!));

/** Seconds that are enough, in tenths, rounded up. */
export const enoughWords = (seconds: number): string => (Math.ceil(10 * seconds - 1e-6) / 10).toFixed(1);

/** Beyond this (mm) the feet's edge is far: where the floor hardly presses, it would have to press at any distance. */
const kFarOutside = 1000;

/** One reason why a motion is hard or impossible: "left knee at 127 % of its strength". */
export function reasonWords(document: Document, candidate: Candidate, reason: Reason): string {
  switch (reason.kind) {
    case 'strength':
      return t('needsStrength', { joint: jointOf(reason.joint), percent: Math.round(100 * (reason.share ?? 0)) });
    case 'pressure': {
      const fall = reason.verdict === 'impossible' ? fallOf(document, candidate) : null;
      if (fall !== null) return t(fall);
      if ((reason.outside_mm ?? 0) > kFarOutside) return t('losesBalanceFar');
      return t(reason.verdict === 'impossible' ? 'losesBalance' : 'barelyStands', { length: (reason.outside_mm ?? 0) / 1000 });
    }
    case 'collision':
      return t('isIn', {
        limb: inSentence(jointName(reason.limb ?? '')), other: inSentence(jointName(reason.other ?? '')), length: (reason.depth_mm ?? 0) / 1000,
      });
    case 'limit':
      return t('isBeyond', { joint: jointOf(reason.joint), deg: Math.round(reason.excess_deg ?? 0) });
  }
}

/** The same with the freedom of the joint, where others of that joint may stand beside it. */
export function detailWords(document: Document, candidate: Candidate, reason: Reason): string {
  const words = reasonWords(document, candidate, reason);
  const [, axis] = (reason.joint ?? '').split('.');
  return axis === undefined ? words : t('ofFreedom', { words, freedom: axisName(axis) });
}

/** All of them, a fall first, then the worst. */
export function reasonsWords(document: Document, candidate: Candidate): string[] {
  return reasonsOf(document, candidate).map((reason) => detailWords(document, candidate, reason));
}

/** What is left of the goals that a motion misses; "" where it meets them. */
function missWords(candidate: Candidate): string {
  const short = shortOf(candidate);
  if (short > 0) return t('short', { length: short / 1000 });
  const unturned = unturnedOf(candidate);
  return unturned > 0 ? t('unturned', { deg: unturned.toFixed(0) }) : '';
}

/** The verdict in a word or two: "not possible", "4.1 cm short". */
export function verdictMark(candidate: Candidate): string {
  return missWords(candidate) || t(candidate.summary.verdict);
}

/** The verdict with its worst reason: "not possible: would fall forward: a step is needed". */
export function verdictWords(document: Document, candidate: Candidate): string {
  const { verdict } = candidate.summary;
  const [worst] = reasonsOf(document, candidate);
  const said = verdict === 'possible' || !worst ? '' : t('because', { verdict: t(verdict), reason: reasonWords(document, candidate, worst) });
  return [missWords(candidate), said].filter((words) => words !== '').join(' · ') || t('possible');
}
