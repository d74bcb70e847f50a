// SPDX-License-Identifier: MIT
// A mannequin around any skeleton whose bones are known: parts are made at rest in the world and then hung on
// the nodes; the trunk is one skin over the spine.
import {
  BufferAttribute, type Bone, type BufferGeometry, Group, Matrix4, Mesh, MeshStandardMaterial, type Object3D, Skeleton,
  SkinnedMesh, Vector3,
} from 'three';
import type { CharacterDescription } from '../../../bindings/wasm/src/types';
import * as anatomy from './anatomy';
import { makeNodes } from './pose';
import { ball, limb } from './shapes';

export interface Figure {
  object: Group;
  /** By index of the description's nodes. */
  nodes: (Object3D | undefined)[];
  height: number; // m, of all that is drawn
  skin: MeshStandardMaterial;
  joints: MeshStandardMaterial;
}

type Profile = readonly (readonly [number, number])[];

class Builder {
  readonly skin = new MeshStandardMaterial({ roughness: 0.62, metalness: 0 });
  readonly joints = new MeshStandardMaterial({ roughness: 0.5, metalness: 0 });
  readonly root: Group;
  readonly nodes: Bone[];
  readonly scale: number;
  private readonly places: Vector3[];
  private readonly bones = new Map<string, number>();
  readonly left: Vector3;
  readonly up: Vector3;
  readonly ahead: Vector3;

  constructor(readonly description: CharacterDescription) {
    const { root, nodes } = makeNodes(description);
    this.root = root;
    this.nodes = nodes;
    this.places = nodes.map((node) => node.getWorldPosition(new Vector3()));
    description.nodes.forEach((node, index) => {
      if (node.name !== '' && !this.bones.has(node.name)) this.bones.set(node.name, index);
    });
    for (const [bone, name] of Object.entries(description.humanoid)) {
      const index = description.nodes.findIndex((node) => node.name === name);
      if (index >= 0) this.bones.set(bone, index);
    }
    this.scale = description.stature_m / anatomy.kStature;
    const across = this.way('right_upper_leg', 'left_upper_leg') ?? new Vector3(1, 0, 0);
    this.left = across.normalize();
    this.up = (this.way('hips', 'neck') ?? this.way('hips', 'head') ?? new Vector3(0, 1, 0)).normalize();
    this.up.addScaledVector(this.left, -this.up.dot(this.left)).normalize();
    this.ahead = this.left.clone().cross(this.up);
  }

  has(bone: string): boolean {
    return this.bones.has(bone);
  }
  at(bone: string): Vector3 | undefined {
    const index = this.bones.get(bone);
    return index === undefined ? undefined : this.places[index];
  }
  node(bone: string): Bone | undefined {
    const index = this.bones.get(bone);
    return index === undefined ? undefined : this.nodes[index];
  }
  way(from: string, to: string): Vector3 | undefined {
    const a = this.at(from);
    const b = this.at(to);
    return a && b ? b.clone().sub(a) : undefined;
  }
  /** The place of the last node below a bone: a fingertip, the top of the head. */
  tip(bone: string): Vector3 | undefined {
    let index = this.bones.get(bone);
    if (index === undefined) return undefined;
    for (;;) {
      const child = this.description.nodes.findIndex((node) => node.parent === index);
      if (child < 0) return this.places[index];
      index = child;
    }
  }

  hang(bone: string, geometry: BufferGeometry, material = this.skin): void {
    const node = this.node(bone);
    if (!node) return;
    const mesh = new Mesh(geometry, material);
    mesh.castShadow = true;
    mesh.receiveShadow = true;
    mesh.frustumCulled = false;
    node.attach(mesh);
  }

  limb(bone: string, end: Vector3 | undefined, profile: Profile): void {
    const start = this.at(bone);
    if (!start || !end || start.distanceTo(end) < 0.01) return;
    this.hang(bone, limb(start, end, profile.map(([share, radius]) => [share, radius * this.scale] as const)));
  }

  joint(bone: string, radius: number): void {
    const place = this.at(bone);
    if (place) this.hang(bone, ball(place, radius * this.scale), this.joints);
  }

  /** From the body's axes at a place to the world. */
  frame(place: Vector3, ahead = this.ahead): Matrix4 {
    const level = ahead.clone().addScaledVector(this.up, -ahead.dot(this.up)).normalize();
    return new Matrix4().makeBasis(this.up.clone().cross(level), this.up, level).setPosition(place);
  }
}

function addTrunk(b: Builder): void {
  const hips = b.at('hips');
  const neck = b.at('neck') ?? b.at('head');
  if (!hips || !neck) return;
  const height = neck.clone().sub(hips).dot(b.up);
  const geometry = anatomy.plain(anatomy.trunk(height, b.scale));
  const chain = ['hips', 'spine', 'chest', 'upper_chest', 'neck'].filter((bone) => b.has(bone));
  const heights = chain.map((bone) => b.at(bone)!.clone().sub(hips).dot(b.up));
  const blend = 0.075 * b.scale; // half the height over which a joint bends the skin
  const points = geometry.getAttribute('position');
  const indices = new Uint16Array(points.count * 4);
  const weights = new Float32Array(points.count * 4);
  for (let i = 0; i < points.count; ++i) {
    const shares: number[] = chain.map((_, k) => (k === 0 ? 1 : 0));
    for (let k = 1; k < chain.length; ++k) {
      const t = Math.min(Math.max((points.getY(i) - heights[k]! + blend) / (2 * blend), 0), 1);
      const smooth = t * t * (3 - 2 * t);
      for (let j = 0; j < k; ++j) shares[j]! *= 1 - smooth;
      shares[k] = smooth;
    }
    const largest = shares.map((share, k) => [share, k] as const).sort((p, q) => q[0] - p[0]).slice(0, 4);
    const sum = largest.reduce((total, [share]) => total + share, 0);
    largest.forEach(([share, k], slot) => {
      indices[4 * i + slot] = share > 0 ? k : 0;
      weights[4 * i + slot] = share / sum;
    });
  }
  geometry.setAttribute('skinIndex', new BufferAttribute(indices, 4));
  geometry.setAttribute('skinWeight', new BufferAttribute(weights, 4));
  geometry.applyMatrix4(b.frame(hips));
  const mesh = new SkinnedMesh(geometry, b.skin);
  mesh.castShadow = true;
  mesh.receiveShadow = true;
  mesh.frustumCulled = false;
  mesh.bind(new Skeleton(chain.map((bone) => b.node(bone)!)), new Matrix4()); // made in the world
  b.root.parent?.add(mesh);
}

function addHead(b: Builder): void {
  const place = b.at('head');
  if (!place) return;
  const top = b.tip('head')!.clone().sub(place).dot(b.up);
  const height = top > 0.08 * b.scale ? top : 0.158 * b.scale;
  b.hang('head', anatomy.head(height, b.scale).applyMatrix4(b.frame(place)));
  if (b.has('neck')) b.limb('neck', place.clone().addScaledVector(b.up, 0.02 * b.scale), anatomy.profiles.neck);
}

function addArm(b: Builder, side: 'left' | 'right'): void {
  const shoulder = b.at(`${side}_upper_arm`);
  if (b.has(`${side}_shoulder`) && shoulder) {
    const from = b.at(`${side}_shoulder`)!.clone().lerp(shoulder, 0.35);
    b.hang(`${side}_shoulder`, limb(from, shoulder, anatomy.profiles.clavicle.map(([s, r]) => [s, r * b.scale] as const)));
  }
  b.joint(`${side}_upper_arm`, anatomy.joints.shoulder);
  if (!b.has(`${side}_lower_arm`)) return; // a body with one arm
  b.limb(`${side}_upper_arm`, b.at(`${side}_lower_arm`), anatomy.profiles.upper_arm);
  b.joint(`${side}_lower_arm`, anatomy.joints.elbow);
  b.limb(`${side}_lower_arm`, b.at(`${side}_hand`), anatomy.profiles.lower_arm);
  b.joint(`${side}_hand`, anatomy.joints.wrist);
  const wrist = b.at(`${side}_hand`);
  if (!wrist) return;
  const tip = b.tip(`${side}_hand`)!;
  const forearm = b.way(`${side}_lower_arm`, `${side}_hand`) ?? b.up.clone().negate();
  const reach = tip.distanceTo(wrist);
  const out = (reach > 0.04 * b.scale ? tip.clone().sub(wrist) : forearm).normalize();
  const sign = side === 'left' ? 1 : -1;
  // hanging, the palm faces the body; held out, the floor
  const palm = b.left.clone().multiplyScalar(-sign).sub(b.up);
  palm.addScaledVector(out, -palm.dot(out)).normalize();
  const thumb = out.clone().cross(palm).multiplyScalar(-sign);
  const length = reach > 0.12 * b.scale ? Math.min(reach, 0.2 * b.scale) : 0.188 * b.scale;
  b.hang(`${side}_hand`, anatomy.hand(wrist, length, out, palm, thumb));
}

function addLeg(b: Builder, side: 'left' | 'right'): void {
  if (!b.has(`${side}_lower_leg`)) return;
  b.limb(`${side}_upper_leg`, b.at(`${side}_lower_leg`), anatomy.profiles.upper_leg);
  b.joint(`${side}_lower_leg`, anatomy.joints.knee);
  b.limb(`${side}_lower_leg`, b.at(`${side}_foot`), anatomy.profiles.lower_leg);
  b.joint(`${side}_foot`, anatomy.joints.ankle);
  const ankle = b.at(`${side}_foot`);
  if (!ankle) return;
  const toes = b.at(`${side}_toes`);
  const ahead = toes ? toes.clone().sub(ankle) : b.ahead.clone();
  ahead.addScaledVector(b.up, -ahead.dot(b.up));
  const long = toes ? ahead.length() : 0.139 * b.scale;
  const rise = 0.0204 * b.scale; // of the toes' joint above the sole
  const drop = toes ? ankle.clone().sub(toes).dot(b.up) + rise : 0.068 * b.scale;
  const sole = ankle.clone().addScaledVector(b.up, -drop);
  b.hang(`${side}_foot`, anatomy.foot(long, b.scale).applyMatrix4(b.frame(sole, ahead)));
  const front = toes ?? sole.clone().addScaledVector(ahead.clone().normalize(), long).addScaledVector(b.up, rise);
  const shape = anatomy.toes(rise, b.scale, side === 'left' ? -1 : 1).applyMatrix4(b.frame(front, ahead));
  b.hang(toes ? `${side}_toes` : `${side}_foot`, shape);
}

/** Bodies with a bone map or with the names of bones; null where neither tells enough. */
export function makeMannequin(description: CharacterDescription): Figure | null {
  const object = new Group();
  const builder = new Builder(description);
  object.add(builder.root);
  object.updateMatrixWorld(true);
  if (!builder.has('hips') || !builder.has('head') || !builder.has('right_lower_leg')) return null;
  addTrunk(builder);
  addHead(builder);
  for (const side of ['left', 'right'] as const) {
    addArm(builder, side);
    addLeg(builder, side);
  }
  return { object, nodes: builder.nodes, height: description.stature_m, skin: builder.skin, joints: builder.joints };
}
