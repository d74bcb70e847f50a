// SPDX-License-Identifier: MIT
// The mannequin: one skin on the nodes of any body whose bones are known.
import { Bone, Group, Matrix4, MeshStandardMaterial, type Object3D, Skeleton, SkinnedMesh } from 'three';
import type { Candidate, CharacterDescription } from '../../../bindings/wasm/src/types';
import { BodyBones } from './body_bones';
import { drawCoarseFromAfar } from './coarse_skin';
import { downOf, FingerBone, Follower, handAt } from './followers';
import { makeSkin, type MannequinMesh, type Shape, type SkinBone } from './mannequin_file';
import { mannequinMaterial } from './mannequin_material';
import { carrier, SkinFitter } from './skin_fit';

export interface Figure {
  object: Group;
  /** By index of the description's nodes. */
  nodes: (Object3D | undefined)[];
  height: number; // m, of all that is drawn
  /** In place of a mesh that cannot be drawn. */
  standsIn?: boolean;
  skin: MeshStandardMaterial;
  joints: MeshStandardMaterial;
  /** Of the mannequin: what moves beside the nodes, what moves it to where they are at a time, and how closed a hand is. */
  others?: Object3D[];
  follow?: (candidate: Candidate, seconds: number) => void;
  closed?: (side: 'left' | 'right') => number;
}

class Builder {
  readonly followers: Follower[] = [];
  readonly fingers: { bone: FingerBone; side: 'left' | 'right' }[] = [];
  readonly bones: Bone[] = [];
  readonly inverses: Matrix4[] = [];
  private readonly fitter: SkinFitter;

  constructor(private readonly body: BodyBones, private readonly mesh: MannequinMesh, stature: number) {
    this.fitter = new SkinFitter(body, mesh, stature);
    for (const bone of mesh.bones) this.add(bone);
  }

  /** Skin on a bone. Files want each bone once in a skin, so the second part on one has a bone of its own there. */
  private hang(on: Bone, matrix: Matrix4): void {
    const bone = this.bones.includes(on) ? new Bone() : on;
    if (bone !== on) {
      bone.name = `${on.name}_part_${this.bones.length}`;
      on.add(bone);
    }
    bone.updateWorldMatrix(true, false);
    this.bones.push(bone);
    this.inverses.push(bone.matrixWorld.clone().invert().multiply(matrix));
  }

  private add(bone: SkinBone): void {
    if (bone.kind === 'finger') this.addFinger(bone);
    else if (bone.kind === 'node') {
      const fit = this.fitter.of(bone.name);
      this.hang(this.body.node(fit.bone)!, fit.matrix);
    } else this.addFollower(bone);
  }

  private addFollower(bone: SkinBone): void {
    const fit = this.fitter.of(bone.of!);
    const joint = this.body.node(fit.bone)!;
    const side = bone.name.replace(/_.*$/, '');
    const isArm = bone.of!.includes('arm');
    const name = bone.of!.includes('lower') ? `${side}_upper_${isArm ? 'arm' : 'leg'}` : isArm ? `${side}_shoulder` : 'hips';
    if (fit.bone !== bone.of) return this.hang(joint, fit.matrix); // a limb that the body has not
    const above = this.fitter.of(carrier(this.body, name)).turn;
    const follower = new Follower(bone.name, bone.kind, joint, fit, above, downOf(this.body));
    this.followers.push(follower);
    // the skin lies about the limb as it is at rest, and the follower as where it hangs
    const rest = follower.bone.quaternion.clone();
    follower.bone.quaternion.copy(above);
    this.hang(follower.bone, this.fitter.hanging(bone, above));
    follower.bone.quaternion.copy(rest);
  }

  private addFinger(bone: SkinBone): void {
    const side = bone.name.startsWith('left') ? 'left' : 'right';
    const hand = this.fitter.of(`${side}_hand`);
    const node = this.body.node(hand.bone)!;
    if (hand.bone !== `${side}_hand`) return this.hang(node, hand.matrix); // moves with what carries it
    const toHand = node.matrixWorld.clone().invert().multiply(hand.matrix);
    const before = this.fingers.find((finger) => finger.bone.bone.name === bone.of);
    const finger = new FingerBone(bone, this.mesh.bones.find(({ name, kind }) => name === bone.of && kind === 'finger') ?? null, before?.bone.bone ?? node, toHand);
    this.fingers.push({ bone: finger, side });
    this.hang(finger.bone, hand.matrix);
  }
}

/** Bodies with a bone map or with names of bones; null if neither suffices. */
export function makeMannequin(description: CharacterDescription, mesh: MannequinMesh, shape: Shape): Figure | null {
  const body = new BodyBones(description);
  if (!body.has('hips') || !body.has('head') || !body.has('right_lower_leg')) return null;
  const object = new Group();
  object.add(body.root);
  object.updateMatrixWorld(true);
  const { bones, inverses, followers, fingers } = new Builder(body, mesh, description.stature_m);
  const joints = new MeshStandardMaterial();
  const skin = mannequinMaterial(joints);
  const drawn = new SkinnedMesh(makeSkin(mesh, shape), skin);
  drawn.castShadow = true;
  drawn.receiveShadow = true;
  drawn.frustumCulled = false;
  drawCoarseFromAfar(drawn, mesh.coarse.length);
  drawn.bind(new Skeleton(bones, inverses), new Matrix4());
  object.add(drawn);
  const closed = { left: 0, right: 0 };
  const bend = (): void => {
    for (const { bone, side } of fingers) bone.bend(closed[side]);
  };
  bend();
  const follow = (candidate: Candidate, seconds: number): void => {
    for (const follower of followers) follower.follow();
    const reaching = new Set(candidate.summary.reached.map(({ effector }) => effector));
    const share = seconds / candidate.summary.duration_s;
    for (const side of ['left', 'right'] as const) closed[side] = reaching.has(`${side}_hand`) ? handAt(share) : 0;
    bend();
  };
  const others = [...followers.map(({ bone }) => bone), ...fingers.map(({ bone }) => bone.bone)];
  return { object, nodes: body.nodes, height: description.stature_m, skin, joints, others, follow, closed: (side) => closed[side] };
}
