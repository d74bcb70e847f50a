// SPDX-License-Identifier: MIT
// Which figure a character is drawn as, and letting go of one.
import { Mesh, type Object3D, SkinnedMesh, type Texture } from 'three';
import type { Candidate, Character } from '../../../bindings/wasm/src/types';
import { isGltf } from '../plain_gltf/packed';
import { isRobot } from '../state/start';
import { type Figure, makeMannequin } from './mannequin';
import { loadMannequin, type Shape } from './mannequin_file';
import { poseNodes } from './pose';
import { makeSticks } from './sticks';

export type { Figure } from './mannequin';

const ownMeshes = new WeakSet<Figure>();

/** Whether a figure is the mesh of its character's own file. */
export function isOwnMesh(figure: Figure): boolean {
  return ownMeshes.has(figure);
}

export async function makeFigure(character: Character): Promise<Figure> {
  const { description } = character;
  let standsIn = false;
  if (character.bytes && isGltf(character.bytes)) {
    try {
      const { makeGltfFigure } = await import('./gltf_figure');
      const figure = await makeGltfFigure(character);
      if (figure) ownMeshes.add(figure);
      if (figure) return figure;
    } catch {
      standsIn = true; // its joints can be drawn all the same
    }
  }
  const figure = (isRobot(description) ? null : await mannequin(character)) ?? makeSticks(description);
  return Object.assign(figure, { standsIn });
}

/** kg/m², of which an average man's and woman's mass is. */
const kMeanMass = { male: 24.084, female: 20.563 };

function shapeOf({ spec, description }: Character): Shape {
  const sex = spec.sex ?? 'male';
  return { female: sex === 'female' ? 1 : 0, mass: description.mass_kg / (kMeanMass[sex] * description.stature_m ** 2) };
}

async function mannequin(character: Character): Promise<Figure | null> {
  const mesh = await loadMannequin().catch(() => null); // offline, say
  return mesh && makeMannequin(character.description, mesh, shapeOf(character));
}

/** Puts a figure where a candidate is at a time. */
export function poseFigure(figure: Figure, candidate: Candidate, seconds: number): void {
  poseNodes(figure.nodes, candidate, seconds);
  figure.follow?.(candidate, seconds);
}

export function disposeFigure(figure: Figure): void {
  figure.object.removeFromParent();
  figure.object.traverse((item: Object3D) => {
    if (!(item instanceof Mesh)) return;
    item.geometry.dispose();
    for (const material of [item.material].flat()) {
      for (const value of Object.values(material as object)) {
        if (typeof value === 'object' && value !== null && 'isTexture' in value) (value as Texture).dispose();
      }
      material.dispose();
    }
    if (item instanceof SkinnedMesh) item.skeleton.dispose();
  });
}
