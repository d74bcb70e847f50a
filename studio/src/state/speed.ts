// SPDX-License-Identifier: MIT
// Speeds along a motion, for display only: the criteria are computed in the engine.
import type { Candidate, Series } from '../../../bindings/wasm/src/types';

/** Distance between the neighbouring frames over the time between them, m/s. */
function speedOf(times: Float64Array, axes: readonly Float64Array[]): Float64Array {
  return times.map((_, f) => {
    const a = Math.max(f - 1, 0);
    const b = Math.min(f + 1, times.length - 1);
    const between = times[b]! - times[a]!;
    return between > 0 ? Math.hypot(...axes.map((axis) => axis[b]! - axis[a]!)) / between : 0;
  });
}

function column({ frames, columns, values }: Series, index: number): Float64Array {
  return Float64Array.from({ length: frames }, (_, f) => values[f * columns + index] ?? 0);
}

/** Where an effector is in each frame, m, and how fast, m/s. */
export interface EffectorPath {
  axes: readonly Float64Array[]; // x, y, z
  speeds: Float64Array;
}

export function effectorPaths({ series: { time, effectors } }: Candidate): EffectorPath[] {
  const times = column(time, 0);
  return Array.from({ length: Math.floor(effectors.columns / 3) }, (_, k) => {
    const axes = [0, 1, 2].map((axis) => column(effectors, 3 * k + axis));
    return { axes, speeds: speedOf(times, axes) };
  });
}

/** The speed at the upper end of a scale that the motions fit in, a multiple of 0.5 m/s, or of 0.1 m/s below that. */
export function speedScale(candidates: readonly Candidate[]): number {
  let fastest = 0;
  for (const candidate of candidates) {
    for (const { speeds } of effectorPaths(candidate)) fastest = speeds.reduce((most, speed) => Math.max(most, speed), fastest);
  }
  const tenths = Math.max(Math.ceil(fastest * 10 - 1e-6), 1);
  return (tenths > 5 ? Math.ceil(tenths / 5) * 5 : tenths) / 10;
}
