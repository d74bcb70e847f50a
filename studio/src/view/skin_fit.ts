// SPDX-License-Identifier: MIT
// Where the mannequin's skin lies about a body at rest, bone by bone: each part is laid along the body's own bone and is as
// long as that, so that a body of any proportions is covered.
import { Matrix4, Quaternion, Vector3 } from 'three';
import type { BodyBones } from './body_bones';
import type { MannequinMesh, SkinBone } from './mannequin_file';

/** How a bone's skin lies. */
export interface Fit {
  bone: string; // the body's that carries it
  turn: Quaternion; // of the body's bone, unturned, from a hanging limb, in the axes of the nodes
  matrix: Matrix4; // from where the mesh is made to the world, the body at rest
}

const kAbove: Record<string, string> = {
  spine: 'hips', chest: 'spine', upper_chest: 'chest', neck: 'upper_chest', head: 'neck', shoulder: 'upper_chest', upper_arm: 'shoulder',
  lower_arm: 'upper_arm', hand: 'lower_arm', upper_leg: 'hips', lower_leg: 'upper_leg', foot: 'lower_leg', toes: 'foot',
};
const kCentral = new Set(['hips', 'spine', 'chest', 'upper_chest', 'neck']);
const kNext: Record<string, string> = { upper_arm: 'lower_arm', lower_arm: 'hand', upper_leg: 'lower_leg', lower_leg: 'foot', foot: 'toes' };
const kDown = new Vector3(0, -1, 0);
const kAhead = new Vector3(0, 0, 1);

function parts(name: string): { side: string; bone: string } {
  const [, side = '', bone = ''] = /^(left_|right_)?(.*)$/.exec(name)!;
  return { side, bone };
}

/** The bone above; of the hips these themselves. */
function above(name: string): string {
  const { side, bone } = parts(name);
  const next = kAbove[bone] ?? 'hips';
  return kCentral.has(next) ? next : side + next;
}

/** The bone, or the next one above it that the body has; the hips where it has none. */
export function carrier(body: BodyBones, name: string): string {
  return body.has(name) || name === 'hips' ? name : carrier(body, above(name));
}

export class SkinFitter {
  private readonly scale: number;
  private readonly trunk: Matrix4;
  private readonly made = new Map<string, Fit>();

  constructor(private readonly body: BodyBones, private readonly mesh: MannequinMesh, stature: number) {
    this.scale = stature / mesh.stature;
    const wide = this.ratio(body.way('right_upper_leg', 'left_upper_leg')?.length(), 2 * this.place('left_upper_leg').x);
    const tall = this.ratio(body.way('hips', 'neck')?.length(), mesh.measures['trunk']!);
    this.trunk = this.lay(body.at('hips')!, new Quaternion(), new Vector3(wide, tall, this.scale), this.place('hips'), 0);
  }

  private bone(name: string): SkinBone {
    return this.mesh.bones.find((bone) => bone.name === name)!;
  }

  private place(name: string): Vector3 {
    return new Vector3(...this.bone(name).place);
  }

  /** A body's length to the mesh's, where both are known. */
  private ratio(length: number | undefined, made: number): number {
    return length === undefined || length < 0.01 * this.scale ? this.scale : Math.min(Math.max(length / made, 0.4 * this.scale), 2.5 * this.scale);
  }

  /** From where the mesh is made to `at`, turned in the nodes' axes, scaled along the hanging limb's axes. */
  private lay(at: Vector3, turn: Quaternion, scale: Vector3, from: Vector3, angle: number): Matrix4 {
    const linear = new Matrix4().extractRotation(this.body.root.matrix);
    return new Matrix4().setPosition(at)
      .multiply(linear).multiply(new Matrix4().makeRotationFromQuaternion(turn)).multiply(linear.clone().transpose())
      .multiply(this.body.axes).multiply(new Matrix4().makeScale(...scale.toArray()))
      .multiply(new Matrix4().makeRotationZ(-angle)).multiply(new Matrix4().makeTranslation(from.negate()));
  }

  /** How a follower's skin lies where its joint hangs straight; `turn`: of the bone above. */
  hanging({ of, place, angle, kind }: SkinBone, turn: Quaternion): Matrix4 {
    const { side, bone } = parts(of!);
    const at = this.body.at(of!)!;
    const { x, y, z } = kind === 'half' ? { x: this.scale, y: this.scale, z: this.scale } : this.measure(side, bone, at);
    return this.lay(at, turn, new Vector3(x, y, z), new Vector3(...place), angle);
  }

  /** How a node's bone lies. */
  of(name: string): Fit {
    const known = this.made.get(name);
    if (known) return known;
    const fit = this.find(name);
    this.made.set(name, fit);
    return fit;
  }

  private find(name: string): Fit {
    const { side, bone } = parts(name);
    const plain = new Quaternion();
    const gone = this.missing(side, bone);
    if (gone) return gone;
    if (!side && bone !== 'neck' && bone !== 'head') return { bone: carrier(this.body, name), turn: plain, matrix: this.trunk };
    const at = this.body.at(name);
    if (bone === 'shoulder') return this.shoulder(side);
    if (!at) return this.of(carrier(this.body, name));
    const { x, y, z, turn } = this.measure(side, bone, at);
    return { bone: name, turn, matrix: this.lay(at, turn, new Vector3(x, y, z), this.place(name), this.bone(name).angle) };
  }

  /** A limb that the body has not shrinks into its joint. */
  private missing(side: string, bone: string): Fit | null {
    const limb = /arm|hand/.test(bone) ? 'arm' : /leg|foot|toes/.test(bone) ? 'leg' : null;
    if (!limb || this.body.has(`${side}lower_${limb}`)) return null;
    const root = `${side}upper_${limb}`;
    const at = this.body.at(root) ?? this.place(root).applyMatrix4(this.trunk);
    const tiny = 1e-3 * this.scale;
    const matrix = this.lay(at, new Quaternion(), new Vector3(tiny, tiny, tiny), this.place(root), 0);
    return { bone: carrier(this.body, limb === 'arm' ? `${side}shoulder` : 'hips'), turn: new Quaternion(), matrix };
  }

  /** Of a girdle the end at the arm's joint lies exactly. */
  private shoulder(side: string): Fit {
    const arm = `${side}upper_arm`;
    const made = this.place(arm);
    const at = this.body.at(arm) ?? made.clone().applyMatrix4(this.trunk);
    const across = this.body.way('right_upper_arm', 'left_upper_arm')?.length();
    const wide = this.ratio(across, 2 * Math.abs(made.x));
    const matrix = this.lay(at, new Quaternion(), new Vector3(wide, this.scale, this.scale), made, 0);
    return { bone: carrier(this.body, `${side}shoulder`), turn: new Quaternion(), matrix };
  }

  private measure(side: string, bone: string, at: Vector3): { x: number; y: number; z: number; turn: Quaternion } {
    const s = this.scale;
    const { measures } = this.mesh;
    const none = new Quaternion();
    if (bone === 'neck') return { x: s, y: this.ratio(this.body.way('neck', 'head')?.length(), this.place('head').y - this.place('neck').y), z: s, turn: none };
    if (bone === 'head') {
      // few files say where a head ends
      const top = this.ratio(this.body.tip('head')!.sub(at).length(), measures['head']!);
      const size = Math.min(Math.max(top, 0.9 * s), 1.15 * s);
      return { x: size, y: size, z: size, turn: none };
    }
    if (bone === 'toes') return { x: s, y: s, z: s, turn: this.of(`${side}foot`).turn };
    const next = kNext[bone];
    const way = next ? this.body.way(side + bone, side + next) : this.body.tip(side + bone)?.sub(at);
    if (bone === 'foot') {
      if (!way) return { x: s, y: s, z: s, turn: none };
      const made = this.place(`${side}toes`).sub(this.place(`${side}foot`)).applyAxisAngle(kAhead, -this.bone(`${side}foot`).angle);
      const long = this.ratio(way.length(), made.length());
      return { x: s, y: long, z: long, turn: this.turnOf(made, way) };
    }
    if (!way || way.length() < 0.04 * s) return { x: s, y: s, z: s, turn: this.of(carrier(this.body, above(side + bone))).turn };
    const hand = bone === 'hand';
    const long = hand && way.length() < 0.12 * s ? s : this.ratio(way.length(), measures[bone]!);
    return { x: hand ? long : s, y: long, z: hand ? long : s, turn: this.turnOf(kDown, way) };
  }

  /** The least turn, in the nodes' axes, from a way in the body's to one in the world. */
  private turnOf(made: Vector3, way: Vector3): Quaternion {
    const inward = new Matrix4().extractRotation(this.body.root.matrix).transpose();
    const from = made.clone().transformDirection(this.body.axes).transformDirection(inward);
    return new Quaternion().setFromUnitVectors(from, way.clone().transformDirection(inward));
  }
}
