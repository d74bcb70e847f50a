// SPDX-License-Identifier: MIT
// The verdict of the engine as the page tells it: whether a motion ends on its goals, whether a body could make it, and how the
// body would fall.
import type { Candidate, CandidateSummary, Reason, Summary } from '../../../bindings/wasm/src/types';
import type { Document } from './model';

const kMet = 1; // mm from its goal at most
const kTurned = 1; // degrees from its rotation at most

/** How far the effector that is farthest from its goal ends, mm; 0 where each goal is met. */
export function shortOf({ summary }: Candidate): number {
  const worst = Math.max(0, ...summary.reached.map(({ error_mm }) => error_mm));
  return worst > kMet ? worst : 0;
}

export const isMet = (error_mm: number): boolean => error_mm <= kMet;

type Reached = CandidateSummary['reached'][number];
export const isTurned = ({ rotation_error_deg = 0 }: Reached): boolean => rotation_error_deg <= kTurned;

/** How far the worst turned effector is from its rotation, degrees; 0 where each is turned as asked for. */
export function unturnedOf({ summary }: Candidate): number {
  return Math.max(0, ...summary.reached.filter((reached) => !isTurned(reached)).map(({ rotation_error_deg = 0 }) => rotation_error_deg));
}

/** The remaining distance of the best motion, for a message; null if it is invisible, as the engine is stricter. */
export function missOf({ remaining_mm, remaining_deg = 0 }: Summary): { key: 'unreachable' | 'unturnedBest'; values: Record<string, string | number> } | null {
  if (!isMet(remaining_mm)) return { key: 'unreachable', values: { length: remaining_mm / 1000 } };
  return remaining_deg > kTurned ? { key: 'unturnedBest', values: { deg: remaining_deg.toFixed(0) } } : null;
}

export type Fall = 'fallsForward' | 'fallsBack' | 'fallsLeft' | 'fallsRight' | 'fallsOver';

/** Whether both feet stay, so that the description's polygon is the support polygon. */
function standsOnBoth({ goals, settings }: Document): boolean {
  const contacts = settings.more.contacts;
  return !goals.some(({ effector }) => effector.endsWith('_foot')) && (contacts === undefined || contacts.length > 1);
}

/** The side to which the centre of mass leaves the support polygon; null if it stays above it. */
export function fallOf(document: Document, { summary, series }: Candidate): Fall | null {
  const least = summary.support?.centre_of_mass;
  const mass = series.centre_of_mass;
  if (!least || least.least_mm >= 0 || mass.columns < 3) return null;
  const corners = document.character.description.support_polygon;
  if (corners.length < 3 || !standsOnBoth(document)) return 'fallsOver';
  const times = series.time.values;
  let frame = 0;
  while (frame + 1 < series.time.frames && times[frame]! < least.time_s) ++frame;
  const [x, z] = [mass.values[frame * mass.columns]!, mass.values[frame * mass.columns + 2]!];
  const xs = corners.map((corner) => corner[0]);
  const zs = corners.map((corner) => corner[1]);
  const beyond: readonly (readonly [Fall, number])[] = [
    ['fallsForward', z - Math.max(...zs)], ['fallsBack', Math.min(...zs) - z], ['fallsLeft', x - Math.max(...xs)], ['fallsRight', Math.min(...xs) - x],
  ];
  return beyond.reduce((most, side) => (side[1] > most[1] ? side : most))[0];
}

/** The reasons of a verdict, the worst first; a fall comes before all others, as it causes them. */
export function reasonsOf(document: Document, candidate: Candidate): Reason[] {
  const { reasons } = candidate.summary;
  const falls = ({ kind, verdict }: Reason): number => Number(kind === 'pressure' && verdict === 'impossible' && fallOf(document, candidate) !== null);
  return [...reasons].sort((a, b) => falls(b) - falls(a));
}

/** Joints that the verdict is about, "right_knee", each with its freedoms that need more than they have or go beyond their range. */
export function strainedJoints({ summary }: Candidate): Map<string, string[]> {
  const joints = new Map<string, string[]>();
  for (const { joint: freedom } of summary.reasons) {
    if (freedom === undefined) continue;
    const joint = freedom.split('.')[0]!;
    joints.set(joint, [...joints.get(joint) ?? [], freedom]);
  }
  return joints;
}
