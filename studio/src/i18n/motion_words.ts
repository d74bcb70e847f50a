// SPDX-License-Identifier: MIT
// A motion among others in words: its differences, and how much worse than the best it is.
import type { Candidate, Message } from '../../../bindings/wasm/src/types';
import { candidateAt, type Document } from '../state/model';
import { engineText, postureWords, t } from '.';

type Posture = Candidate['summary']['final_posture'] & { elbow_swivel_deg?: number };

const kHangs = 8; // degrees from hanging down

/** How the elbow is held about the line from shoulder to hand: 0 hangs down. */
function elbowWords(swivel: number): string {
  if (Math.abs(swivel) < kHangs) return t('elbowHangs');
  return t(swivel >= 0 ? 'elbowOut' : 'elbowIn', { deg: Math.round(Math.abs(swivel)) });
}

/** The posture's words, and beside those with the same words the number that differs most. */
export function differenceWords(document: Document, index: number): string {
  const posture = (i: number): Posture | undefined => candidateAt(document, i)?.summary.final_posture;
  const mine = posture(index);
  if (!mine) return '';
  const words = postureWords(mine.words);
  const count = document.result?.candidates.length ?? 0;
  const twins = Array.from({ length: count }, (_, i) => posture(i)).filter((other, i) => i !== index && other?.words === mine.words);
  if (twins.length === 0) return words;
  const spread = (of: (posture: Posture | undefined) => number): number => Math.max(...twins.map((other) => Math.abs(of(other) - of(mine))));
  const knees = (of: Posture | undefined): number => of?.knee_flexion_deg ?? 0;
  const turn = (of: Posture | undefined): number => of?.trunk_turn_deg ?? 0;
  const swivel = (of: Posture | undefined): number => of?.elbow_swivel_deg ?? 0;
  const ways = [
    [spread(knees), t('knees', { deg: Math.round(knees(mine)) })], [spread(turn), t('turned', { deg: Math.round(Math.abs(turn(mine))) })],
    [spread(swivel), elbowWords(swivel(mine))],
  ] as const;
  return `${words} · ${[...ways].sort((a, b) => b[0] - a[0])[0]![1]}`;
}

/** That there are fewer motions than were asked for; the engine's sentence begins with both numbers. */
export function fewerWords(fewer: Message): string {
  if (typeof fewer === 'string' || !('key' in fewer)) return engineText(fewer);
  const [found, asked] = fewer.values.map(engineText);
  return t('fewer', { found: found!, asked: asked! });
}

/** By how many times a score is that of the best. */
const kAsGood = 1.1;
const kLittleWorse = 1.5;
const kMuchWorse = 4;

export function scoreWords(score: number, best: number): string {
  const times = best > 0 ? score / best : 1;
  if (score <= best) return t('scoreBest');
  if (times <= kAsGood) return t('scoreAsGood');
  return t(times <= kLittleWorse ? 'scoreLittleWorse' : times <= kMuchWorse ? 'scoreWorse' : 'scoreMuchWorse');
}
