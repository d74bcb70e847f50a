// SPDX-License-Identifier: MIT
// Rotations as people give them: three angles about the axes to the left, up and ahead.
import { Euler, MathUtils, Quaternion } from 'three';
import type { Quat } from '../../../bindings/wasm/src/types';

const kOrder = 'YXZ'; // first the heading, then the pitch in it, then the roll
const kNone: Quat = [0, 0, 0, 1];

export const angles = [['pitch', 90], ['heading', 180], ['roll', 180]] as const; // each with the most that it can be, °

function eulerOf(rotation: Quat): Euler {
  return new Euler().setFromQuaternion(new Quaternion(...rotation), kOrder);
}

/** In the order of `angles`, °. */
export function anglesOf(rotation: Quat = kNone): number[] {
  const { x, y, z } = eulerOf(rotation);
  return [x, y, z].map((angle) => MathUtils.radToDeg(angle));
}

/** With one of its angles changed; the others are not those of fields, which are rounded. */
export function withAngle(rotation: Quat = kNone, index: number, degrees: number): Quat {
  const euler = eulerOf(rotation);
  euler[(['x', 'y', 'z'] as const)[index]!] = MathUtils.degToRad(degrees);
  const { x, y, z, w } = new Quaternion().setFromEuler(euler);
  return [x, y, z, w];
}

export function isUnturned([x, y, z]: Quat): boolean {
  return Math.hypot(x, y, z) < 1e-9;
}
