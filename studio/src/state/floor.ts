// SPDX-License-Identifier: MIT
// Goals stay above the floor: feet with their soles, all else by a little.
import type { Character, Goal, Quat, Vec3 } from '../../../bindings/wasm/src/types';

const kLeast = 0.01; // m

/** How high a corner is that is turned from the effector's frame to the world. */
function heightOf([x, y, z]: Vec3, [qx, qy, qz, qw]: Quat): number {
  return 2 * (qx * qy + qw * qz) * x + (1 - 2 * (qx * qx + qz * qz)) * y + 2 * (qy * qz - qw * qx) * z;
}

/** The least height that an effector may be given, m. */
export function leastHeight({ description }: Character, effector: string, rotation?: Quat): number {
  const foot = description.feet.find((other) => other.effector === effector);
  if (!foot) return kLeast;
  if (!rotation) return foot.least_m;
  return foot.floor_m - Math.min(0, ...foot.sole_m.map((corner) => heightOf(corner, rotation)));
}

/** The goal, lifted to the floor where it is below. */
export function aboveFloor(character: Character, goal: Goal): Goal {
  const least = leastHeight(character, goal.effector, goal.rotation_xyzw);
  const [x, y, z] = goal.position_m;
  return y >= least ? goal : { ...goal, position_m: [x, least, z] };
}
