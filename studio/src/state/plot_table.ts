// SPDX-License-Identifier: MIT
// The numbers behind the plots: shares of ranges and strengths by the limits that the engine holds in each frame, and a table of all.
import type { Candidate, CharacterDescription, Series } from '../../../bindings/wasm/src/types';
import { effectorPaths } from './speed';

const kDegrees = 180 / Math.PI;

export function columnOf(series: Series, index: number, of: (value: number, frame: number) => number = (value) => value): Float64Array {
  return Float64Array.from({ length: series.frames }, (_, f) => of(series.values[f * series.columns + index] ?? 0, f));
}

/** Where in its range a freedom is, 0 to 1; an upper limit may move with another joint's angle, as the engine has it. */
export function rangeShare({ joints }: CharacterDescription, { series }: Candidate, index: number): Float64Array {
  const low = joints[index]!.limits_rad[0];
  const highs = columnOf(series.upper_limits, index);
  return columnOf(series.angles, index, (value, frame) => {
    const high = highs[frame] ?? 0;
    return high > low ? (value - low) / (high - low) : 0;
  });
}

/** The torque by the strength in its direction. */
export function strengthShare({ joints }: CharacterDescription, { series }: Candidate, index: number): Float64Array {
  const [low, high] = joints[index]!.strength_nm;
  return columnOf(series.torques, index, (value) => (value > 0 ? value / Math.max(high, 1e-9) : value / Math.min(low, -1e-9)));
}

/** All that is plotted, of every freedom, as CSV. */
export function plotTable(description: CharacterDescription, candidate: Candidate): string {
  const { series, summary } = candidate;
  const columns: (readonly [string, Float64Array])[] = [['time_s', columnOf(series.time, 0)]];
  description.joints.forEach(({ name }, index) => {
    columns.push(
      [`${name}.angle_deg`, columnOf(series.angles, index, (value) => value * kDegrees)],
      [`${name}.limit_deg`, columnOf(series.upper_limits, index, (value) => value * kDegrees)],
      [`${name}.range_share`, rangeShare(description, candidate, index)],
      [`${name}.torque_nm`, columnOf(series.torques, index)],
      [`${name}.strength_share`, strengthShare(description, candidate, index)],
    );
  });
  if (series.support.columns >= 2) {
    columns.push(['centre_of_mass_inside_m', columnOf(series.support, 0)], ['pressure_inside_m', columnOf(series.support, 1)]);
  }
  effectorPaths(candidate).forEach(({ speeds }, k) => columns.push([`${summary.reached[k]?.effector ?? k}.speed_m_s`, speeds]));
  const rows = Array.from({ length: series.time.frames }, (_, f) => columns.map(([, values]) => String(Number((values[f] ?? 0).toPrecision(7)))).join(','));
  return [columns.map(([name]) => (/[",\n]/.test(name) ? `"${name.replaceAll('"', '""')}"` : name)).join(','), ...rows, ''].join('\n');
}
