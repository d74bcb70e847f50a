// SPDX-License-Identifier: MIT
// A body's bones, unturned, by the names that all bodies share, and the body's own axes.
import type { Bone, Group } from 'three';
import { Matrix4, Vector3 } from 'three';
import type { CharacterDescription } from '../../../bindings/wasm/src/types';
import { makeNodes } from './pose';

export class BodyBones {
  readonly root: Group;
  readonly nodes: Bone[];
  /** From the body's axes (left, up, ahead) to the world. */
  readonly axes: Matrix4;
  private readonly places: Vector3[];
  private readonly bones = new Map<string, number>();

  constructor(private readonly description: CharacterDescription) {
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
    const left = (this.way('right_upper_leg', 'left_upper_leg') ?? new Vector3(1, 0, 0)).normalize();
    const up = (this.way('hips', 'neck') ?? this.way('hips', 'head') ?? new Vector3(0, 1, 0)).normalize();
    up.addScaledVector(left, -up.dot(left)).normalize();
    this.axes = new Matrix4().makeBasis(left, up, left.clone().cross(up));
  }

  has(bone: string): boolean {
    return this.bones.has(bone);
  }

  at(bone: string): Vector3 | undefined {
    const index = this.bones.get(bone);
    return index === undefined ? undefined : this.places[index]!.clone();
  }

  node(bone: string): Bone | undefined {
    const index = this.bones.get(bone);
    return index === undefined ? undefined : this.nodes[index];
  }

  way(from: string, to: string): Vector3 | undefined {
    const a = this.at(from);
    const b = this.at(to);
    return a && b ? b.sub(a) : undefined;
  }

  /** The place of the node below a bone that is farthest from it: a fingertip, the top of the head. */
  tip(bone: string): Vector3 | undefined {
    const root = this.bones.get(bone);
    if (root === undefined) return undefined;
    const below = new Set([root]);
    let farthest = root;
    this.description.nodes.forEach((node, index) => {
      if (!below.has(node.parent)) return;
      below.add(index);
      if (this.places[index]!.distanceTo(this.places[root]!) > this.places[farthest]!.distanceTo(this.places[root]!)) farthest = index;
    });
    return this.places[farthest]!.clone();
  }
}
