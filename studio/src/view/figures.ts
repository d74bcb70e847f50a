// SPDX-License-Identifier: MIT
// Which figure a character is drawn as, and letting go of one.
import { Mesh, type Object3D, SkinnedMesh, type Texture } from 'three';
import type { Character } from '../../../bindings/wasm/src/types';
import { isRobot } from '../state/start';
import { type Figure, makeMannequin } from './mannequin';
import { makeSticks } from './sticks';

export type { Figure } from './mannequin';

const ownMeshes = new WeakSet<Figure>();

/** Whether a figure is the mesh of its character's own file. */
export function isOwnMesh(figure: Figure): boolean {
  return ownMeshes.has(figure);
}

export async function makeFigure(character: Character): Promise<Figure> {
  const { description } = character;
  if (character.bytes && description.nodes.some((node) => node.file_node !== undefined)) {
    try {
      const { makeGltfFigure } = await import('./gltf_figure');
      const figure = await makeGltfFigure(character);
      ownMeshes.add(figure);
      return figure;
    } catch {
      // a file without a mesh, or one that three cannot read: its joints can be drawn all the same
    }
  }
  return (isRobot(description) ? null : makeMannequin(description)) ?? makeSticks(description);
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
