// SPDX-License-Identifier: MIT
// A body as a line drawing of a motion's posture, small enough for a tooltip. Places are those of the engine's series.
import { type Bone, type Group, Vector3 } from 'three';
import type { Candidate, Character } from '../../../bindings/wasm/src/types';
import { makeNodes, poseNodes } from './pose';

export interface Drawing {
  /** Lines of points, m: x to the right of the picture, y up. */
  readonly limbs: readonly (readonly (readonly [number, number])[])[];
  readonly head: readonly [number, number] | null;
  /** The way of each goal's effector. */
  readonly paths: readonly (readonly (readonly [number, number])[])[];
}

interface Sticks {
  readonly root: Group;
  readonly nodes: Bone[];
  /** Pairs of nodes with a limb between them. */
  readonly links: readonly (readonly [number, number])[];
  readonly head: number; // -1: none
}

/** As strip figures are seen: from the front right. */
const kRight = new Vector3(1, 0, 0.62).normalize();
const kBack = new Vector3(0.62, 0, -1).normalize();
const kTilt = 0.12; // upward shift of distant points
const kPathSteps = 24;

const known = new WeakMap<Character, Sticks>();

/** Bones of a person by name; every node of a body without known bones. */
function sticksOf(character: Character): Sticks {
  const made = known.get(character);
  if (made) return made;
  const { description } = character;
  const { root, nodes } = makeNodes(description);
  const named = new Set(Object.values(description.humanoid));
  const isBone = (index: number): boolean => {
    const { name } = description.nodes[index]!;
    if (/thumb|index|middle|ring|little|eye|jaw/i.test(name)) return false;
    return named.size === 0 || named.has(name);
  };
  const links: [number, number][] = [];
  description.nodes.forEach((_, index) => {
    if (!isBone(index)) return;
    let parent = description.nodes[index]!.parent;
    while (parent >= 0 && !isBone(parent)) parent = description.nodes[parent]!.parent;
    if (parent >= 0) links.push([parent, index]);
  });
  const headName = description.humanoid['head'] ?? 'head';
  const sticks = { root, nodes, links, head: description.nodes.findIndex(({ name }) => name === headName) };
  known.set(character, sticks);
  return sticks;
}

function onPaper(place: Vector3): [number, number] {
  return [place.dot(kRight), place.y + kTilt * place.dot(kBack)];
}

/** A candidate at a share of its time, with the ways of its effectors. */
export function drawSticks(character: Character, candidate: Candidate, share: number): Drawing {
  const { root, nodes, links, head } = sticksOf(character);
  poseNodes(nodes, candidate, share * candidate.summary.duration_s);
  root.updateMatrixWorld(true);
  const places = nodes.map((node) => onPaper(node.getWorldPosition(new Vector3())));
  const { effectors } = candidate.series;
  const paths = candidate.summary.reached.map((_, index) => Array.from({ length: kPathSteps + 1 }, (_step, k) => {
    const frame = Math.round((k / kPathSteps) * (effectors.frames - 1));
    return onPaper(new Vector3().fromArray(effectors.values, frame * effectors.columns + 3 * index));
  }));
  return { limbs: links.map(([from, to]) => [places[from]!, places[to]!]), head: places[head] ?? null, paths };
}
