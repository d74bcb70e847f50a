// SPDX-License-Identifier: MIT
// Bones of the mannequin in the pose of its mesh: the body's own nodes, followers of their joints and the fingers.
import { fingers, frames, joints, kHeadTop, lengths } from './body.mjs';

const { arm, fore, hand, leg, shank, foot } = frames;

const degrees = (angle) => (angle * Math.PI) / 180;
const unit = (v) => v.map((value) => value / Math.hypot(...v));
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const minus = (a, b) => a.map((value, k) => value - b[k]);

/** Bends from the straight hand, degrees: open, relaxed and in a grip, from the knuckle to the tip. */
const kBends = {
  thumb: { open: [-8, -2, -4], relaxed: [8, 12, 10], grip: [34, 30, 30] },
  index: { open: [-4, 4, 3], relaxed: [16, 24, 14], grip: [52, 62, 38] },
  middle: { open: [-4, 5, 3], relaxed: [21, 28, 16], grip: [58, 66, 40] },
  ring: { open: [-3, 6, 4], relaxed: [25, 31, 18], grip: [62, 68, 42] },
  little: { open: [-2, 7, 4], relaxed: [28, 33, 20], grip: [66, 68, 44] },
};
const kJointNames = ['proximal', 'intermediate', 'distal'];

/** In the axes of a hanging arm: x outwards, y up, z ahead. */
const hanging = ([u, v, w]) => [u, -v, w];

function fingerBones() {
  return Object.entries(fingers).flatMap(([name, { joints: places }]) =>
    kJointNames.map((joint, k) => {
      const way = minus(hanging(places[k + 1]), hanging(places[k]));
      // fingers bend to the palm, which faces inwards; the thumb across it
      const to = name === 'thumb' ? [-0.75, -0.25, -0.6] : [-1, 0, 0];
      const parent = k === 0 ? 'hand' : `${name}_${kJointNames[k - 1]}`;
      const { open, relaxed, grip } = kBends[name];
      return {
        name: `${name}_${joint}`, kind: 'finger', of: parent, place: hand.world(...places[k]), angle: hand.angle,
        axis: unit(cross(way, to)), bends: [open[k], relaxed[k], grip[k]].map(degrees),
      };
    }));
}

const central = ['hips', 'spine', 'chest', 'upper_chest', 'neck', 'head'].map((name) => ({ name, kind: 'node', place: joints[name], angle: 0 }));

/** `angle`: how far a bone is turned outwards from a hanging limb where the mesh is made. */
const sided = [
  { name: 'shoulder', kind: 'node', place: joints.shoulder, angle: 0 },
  { name: 'upper_arm', kind: 'node', place: arm.origin, angle: arm.angle },
  { name: 'lower_arm', kind: 'node', place: fore.origin, angle: arm.angle },
  { name: 'hand', kind: 'node', place: hand.origin, angle: arm.angle },
  { name: 'upper_leg', kind: 'node', place: leg.origin, angle: leg.angle },
  { name: 'lower_leg', kind: 'node', place: shank.origin, angle: leg.angle },
  { name: 'foot', kind: 'node', place: foot.origin, angle: leg.angle },
  { name: 'toes', kind: 'node', place: foot.world(0, 0.04753, lengths.foot), angle: leg.angle },
  // half: half of its joint's rotation; swing: the rotation without its twist about the limb; roll: with half of the twist
  { name: 'upper_arm_half', kind: 'half', of: 'upper_arm', place: arm.origin, angle: arm.angle / 2 },
  { name: 'upper_arm_swing', kind: 'swing', of: 'upper_arm', place: arm.origin, angle: arm.angle },
  { name: 'upper_arm_roll', kind: 'roll', of: 'upper_arm', place: arm.origin, angle: arm.angle },
  { name: 'lower_arm_half', kind: 'half', of: 'lower_arm', place: fore.origin, angle: arm.angle },
  { name: 'lower_arm_swing', kind: 'swing', of: 'lower_arm', place: fore.origin, angle: arm.angle },
  { name: 'lower_arm_roll', kind: 'roll', of: 'lower_arm', place: fore.origin, angle: arm.angle },
  { name: 'upper_leg_half', kind: 'half', of: 'upper_leg', place: leg.origin, angle: leg.angle / 2 },
  { name: 'lower_leg_half', kind: 'half', of: 'lower_leg', place: shank.origin, angle: leg.angle },
  ...fingerBones(),
];

/** The same bones for the right: their place mirrored, outwards the other way. */
function mirrored(bone) {
  const [x, y, z] = bone.place;
  const other = { ...bone, place: [-x, y, z], angle: -bone.angle };
  if (bone.axis) other.axis = [bone.axis[0], -bone.axis[1], -bone.axis[2]];
  return other;
}

const named = (side) => (bone) => ({ ...bone, name: `${side}_${bone.name}`, ...(bone.of ? { of: `${side}_${bone.of}` } : {}) });

export const bones = [...central, ...sided.map(named('left')), ...sided.map(mirrored).map(named('right'))];

const index = new Map(bones.map(({ name }, k) => [name, k]));
/** A bone's index; of a limb's the left one. */
export const boneOf = (name) => index.get(name) ?? index.get(`left_${name}`);
/** From a left bone to the right one. */
export const otherSide = bones.map(({ name }) => index.get(name.replace(/^left_/, 'right_')));

/** What the page measures other bodies by. */
export const measures = { ...lengths, head: kHeadTop - joints.head[1], trunk: joints.neck[1] - joints.hips[1] };
