// SPDX-License-Identifier: MIT
// Whether a figure stands where the engine has the motion.
import { Vector3 } from 'three';
import type { Candidate, CandidateSummary, Character, CharacterDescription } from '../../../bindings/wasm/src/types';
import type { Undrawn } from '../state/model';
import { type Figure, poseFigure } from './figures';

const kApart = 0.01; // m, at which a hand is seen to be elsewhere

/** Index of the node that an effector of a motion is; -1 where the character has none there. */
export function nodeOfReached({ nodes }: CharacterDescription, reached: CandidateSummary['reached'][number]): number {
  const file = reached['gltf_node' as keyof typeof reached] as unknown as number | undefined;
  return nodes.findIndex((node) => (file === undefined ? node.name === reached.joint : node.file_node === file));
}

/** How far effectors are drawn at most from where they are computed, at the start and at the end, m; the figure stays at the end. */
function drawnApart(figure: Figure, description: CharacterDescription, candidate: Candidate): number {
  const { summary, series: { effectors } } = candidate;
  const drawn = new Vector3();
  let apart = 0;
  for (const [seconds, frame] of [[0, 0], [summary.duration_s, effectors.frames - 1]] as const) {
    poseFigure(figure, candidate, seconds);
    figure.object.updateMatrixWorld(true);
    summary.reached.forEach((reached, index) => {
      const node = figure.nodes[nodeOfReached(description, reached)];
      if (!node) return;
      const computed = new Vector3().fromArray(effectors.values, frame * effectors.columns + 3 * index);
      apart = Math.max(apart, node.getWorldPosition(drawn).sub(figure.object.position).distanceTo(computed));
    });
  }
  return apart;
}

/** What keeps a character from being drawn as its first motion is computed; null where nothing does. */
export function undrawnOf(figure: Figure, character: Character, candidate: Candidate): Undrawn | null {
  const apart_m = drawnApart(figure, character.description, candidate);
  return !(apart_m < kApart) ? { character, apart_m } : figure.standsIn ? { character, apart_m: null } : null;
}
