// SPDX-License-Identifier: MIT
// The nodes of a character as objects of three, moved by the engine's results. Between two of its frames
// nodes are blended; nothing else is worked out here.
import { Bone, Group, Matrix4, Quaternion, Vector3 } from 'three';
import type { Candidate, CharacterDescription, Series } from '../../../bindings/wasm/src/types';

export interface Moment {
  frame: number; // the earlier one
  next: number;
  share: number; // of the next
}

export function momentAt(time: Series, seconds: number): Moment {
  const last = time.frames - 1;
  let low = 0;
  let high = last;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if ((time.values[middle] ?? 0) <= seconds) low = middle;
    else high = middle;
  }
  const from = time.values[low] ?? 0;
  const to = time.values[high] ?? 0;
  const share = to > from ? Math.min(Math.max((seconds - from) / (to - from), 0), 1) : 0;
  return { frame: low, next: high, share };
}

/** A row's column, blended. */
export function valueAt(series: Series, moment: Moment, column: number): number {
  const a = series.values[moment.frame * series.columns + column] ?? 0;
  const b = series.values[moment.next * series.columns + column] ?? 0;
  return a + (b - a) * moment.share;
}

export interface MovedNode {
  position: Vector3;
  quaternion: Quaternion;
}

const blended = new Quaternion();

/** Puts nodes, in the order of the description, where a candidate has them at a time. Absent nodes are left out. */
export function poseNodes(nodes: readonly (MovedNode | undefined)[], candidate: Candidate, seconds: number): void {
  const { time, node_translations: places, node_rotations: turns } = candidate.series;
  const moment = momentAt(time, seconds);
  for (let n = 0; n < nodes.length; ++n) {
    const node = nodes[n];
    if (node === undefined || 3 * n >= places.columns) continue;
    node.position.set(
      valueAt(places, moment, 3 * n), valueAt(places, moment, 3 * n + 1), valueAt(places, moment, 3 * n + 2),
    );
    const a = moment.frame * turns.columns + 4 * n;
    const b = moment.next * turns.columns + 4 * n;
    node.quaternion.fromArray(turns.values, a);
    if (moment.share > 0) node.quaternion.slerp(blended.fromArray(turns.values, b), moment.share);
  }
}

/** From the nodes that a motion moves to the world. A motion's nodes stand in the world's own axes, in the file's
 *  unit; where the file is mirrored, as no rotation leads out of a mirror, they stand as in the file:
 *  p = unit · (left, up, ahead)ᵀ (q - origin). */
export function worldMatrix(description: CharacterDescription): Matrix4 {
  const unit = description.node_unit_m;
  const scale = new Matrix4().makeScale(unit, unit, unit);
  if (!description.placement) return scale;
  const { left, up, ahead, origin } = description.placement;
  const mirrored = new Vector3(...left).cross(new Vector3(...up)).dot(new Vector3(...ahead)) < 0;
  if (!mirrored) return scale;
  const turn = new Matrix4().set(
    left[0], left[1], left[2], 0, up[0], up[1], up[2], 0, ahead[0], ahead[1], ahead[2], 0, 0, 0, 0, 1,
  );
  return scale.multiply(turn).multiply(new Matrix4().makeTranslation(-origin[0], -origin[1], -origin[2]));
}

/** The nodes of a description, unturned, below a group that stands them into the world, which files keep as its place, turn and scale. */
export function makeNodes(description: CharacterDescription): { root: Group; nodes: Bone[] } {
  const root = new Group();
  root.applyMatrix4(worldMatrix(description));
  const nodes = description.nodes.map((node) => {
    const bone = new Bone();
    bone.name = node.name;
    bone.position.set(...node.offset);
    if (node.scale) bone.scale.set(...node.scale);
    return bone;
  });
  description.nodes.forEach((node, index) => {
    const parent = node.parent >= 0 ? nodes[node.parent] : undefined;
    (parent ?? root).add(nodes[index]!);
  });
  root.updateMatrixWorld(true);
  return { root, nodes };
}
