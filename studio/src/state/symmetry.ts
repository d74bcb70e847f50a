// SPDX-License-Identifier: MIT
// Hands that move alike: where one hand's goal has changed, the other's is its mirror image in the plane between left and right.
import type { Goal, GoalAxis, Vec3 } from '../../../bindings/wasm/src/types';
import { type Document, goalOf } from './model';
import { withGoal } from './places';
import { effectorsOf } from './start';

const kOther: Readonly<Record<string, string>> = { left_hand: 'right_hand', right_hand: 'left_hand' };

const mirrored = ([x, y, z]: Vec3): Vec3 => [-x, y, z];

function mirroredAxis({ axis, direction }: GoalAxis): GoalAxis {
  const words: Partial<Record<string, GoalAxis['direction']>> = { left: 'right', right: 'left' };
  return {
    axis: typeof axis === 'string' ? axis : mirrored(axis),
    direction: typeof direction === 'string' ? words[direction] ?? direction : mirrored(direction),
  };
}

/** The goal for the other hand; what that one holds stays. */
function mirrorImage(goal: Goal, other: string, load_kg: number | undefined): Goal {
  const { position_m, rotation_xyzw, axis, tolerance_m } = goal;
  const image: Goal = { effector: other, position_m: mirrored(position_m) };
  if (rotation_xyzw) {
    const [x, y, z, w] = rotation_xyzw;
    image.rotation_xyzw = [x, -y, -z, w];
  }
  if (axis) image.axis = mirroredAxis(axis);
  if (tolerance_m) image.tolerance_m = tolerance_m;
  if (load_kg !== undefined) image.load_kg = load_kg;
  return image;
}

/** Whether a body has both hands. */
export function hasBothHands({ character }: Document): boolean {
  const effectors = effectorsOf(character);
  return Object.keys(kOther).every((hand) => effectors.includes(hand));
}

/** The document with the other hand's goal as the mirror image of this one's. */
export function withMirrorImage(document: Document, hand: string): Document {
  const goal = goalOf(document, hand);
  const other = kOther[hand];
  return goal && other && hasBothHands(document) ? withGoal(document, mirrorImage(goal, other, goalOf(document, other)?.load_kg)) : document;
}

/** After a change of one hand's goal; where both have changed, or one is gone, all stays as it is. */
export function madeSymmetric(before: Document, after: Document): Document {
  const changed = Object.keys(kOther).filter((hand) => goalOf(before, hand) !== goalOf(after, hand));
  return changed.length === 1 ? withMirrorImage(after, changed[0]!) : after;
}
