// SPDX-License-Identifier: MIT
// Bones that no body has and that its skin wants: they turn by a part of what a joint does, so that skin neither folds nor
// wrings, and fingers that open and close.
import { Bone, Matrix4, Quaternion, Vector3 } from 'three';
import type { BodyBones } from './body_bones';
import type { SkinBone } from './mannequin_file';
import type { Fit } from './skin_fit';

const kNone = new Quaternion();
const kFullTwist = 1.9; // rad, beyond which less of a twist is taken back, as at half a turn its sense is lost
const kHighSwing = [1.9, 2.8] as const; // rad, of a limb from hanging; near the upper one a twist has no meaning

function smooth(low: number, high: number, x: number): number {
  const t = Math.min(Math.max((x - low) / (high - low), 0), 1);
  return t * t * (3 - 2 * t);
}

/** The part of a turn that is about an axis. */
function twistAngle(turn: Quaternion, axis: Vector3): number {
  const about = turn.x * axis.x + turn.y * axis.y + turn.z * axis.z;
  const angle = 2 * Math.atan2(about, turn.w);
  return angle > Math.PI ? angle - 2 * Math.PI : angle < -Math.PI ? angle + 2 * Math.PI : angle;
}

/** Follows a joint of the body. */
export class Follower {
  readonly bone = new Bone();
  private readonly turn = new Quaternion();
  private readonly back = new Quaternion();

  /** `down`: where a hanging limb points, in the nodes' axes; `above`: how the bone above is turned from hanging. */
  constructor(name: string, private readonly kind: SkinBone['kind'], private readonly joint: Bone, private readonly fit: Fit, private readonly above: Quaternion, private readonly down: Vector3) {
    this.bone.name = name;
    joint.parent!.add(this.bone);
    this.follow();
  }

  follow(): void {
    const { turn, back } = this;
    this.bone.position.copy(this.joint.position);
    turn.copy(this.above).invert().multiply(this.joint.quaternion).multiply(this.fit.turn);
    if (this.kind !== 'half') this.untwist(this.kind === 'swing' ? 1 : 0.5);
    else {
      this.untwist(1);
      turn.copy(back.slerpQuaternions(kNone, turn, 0.5));
    }
    this.bone.quaternion.copy(this.above).multiply(turn);
  }

  /** Takes a share of the turn about the limb back. */
  private untwist(share: number): void {
    const { turn, back, down } = this;
    const twist = twistAngle(turn, down);
    back.setFromAxisAngle(down, -twist);
    const swing = 2 * Math.acos(Math.min(Math.abs(turn.clone().multiply(back).w), 1));
    const kept = Math.abs(twist) < kFullTwist ? 1 : (Math.PI - Math.abs(twist)) / (Math.PI - kFullTwist);
    const known = 1 - smooth(kHighSwing[0], kHighSwing[1], swing);
    turn.multiply(back.setFromAxisAngle(down, -twist * share * kept * known));
  }
}

/** A finger's bone on the hand or on the bone before it. */
export class FingerBone {
  readonly bone = new Bone();
  private readonly axis: Vector3;

  /** `toHand`: from where the mesh is made to the hand's node. */
  constructor(private readonly made: SkinBone, before: SkinBone | null, parent: Bone, toHand: Matrix4) {
    const at = (place: SkinBone['place']): Vector3 => new Vector3(...place).applyMatrix4(toHand);
    this.bone.name = made.name;
    this.bone.position.copy(at(made.place));
    if (before) this.bone.position.sub(at(before.place));
    parent.add(this.bone);
    const hanging = new Matrix4().makeRotationZ(made.angle);
    this.axis = new Vector3(...made.axis!).transformDirection(hanging).transformDirection(toHand);
    if (toHand.determinant() < 0) this.axis.negate();
  }

  /** `closed`: -1 open, 0 relaxed, 1 in a grip. */
  bend(closed: number): void {
    const [open, relaxed, grip] = this.made.bends!;
    const angle = closed < 0 ? relaxed + (relaxed - open) * closed : relaxed + (grip - relaxed) * closed;
    this.bone.quaternion.setFromAxisAngle(this.axis, angle);
  }
}

/** How a hand that reaches opens on the way and closes at its end, by the share of the motion's time. */
export function handAt(share: number): number {
  return -0.9 * smooth(0.08, 0.5, share) + 1.35 * smooth(0.74, 1, share);
}

export const downOf = (body: BodyBones): Vector3 =>
  new Vector3(0, -1, 0).transformDirection(body.axes).transformDirection(new Matrix4().extractRotation(body.root.matrix).transpose());
