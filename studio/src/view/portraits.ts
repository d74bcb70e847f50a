// SPDX-License-Identifier: MIT
// A still picture of each character, as it stands before its first motion. Drawn once, by the renderer of the small pictures.
import { type PerspectiveCamera, type Scene, Vector3, type WebGLRenderer } from 'three';
import type { Candidate, Character } from '../../../bindings/wasm/src/types';
import { type Figure, isOwnMesh, poseFigure } from './figures';

const kWidth = 120; // px
const kHeight = 160;

export interface Portrait {
  readonly picture: HTMLCanvasElement;
  /** Drawn with the file's own mesh. */
  readonly mesh: boolean;
}

export class Portraits {
  private readonly drawn = new WeakMap<Character, Portrait>();
  private readonly listeners = new Set<() => void>();

  of(character: Character): Portrait | undefined {
    return this.drawn.get(character);
  }

  /** Draws a character as a candidate begins. */
  draw(character: Character, figure: Figure, candidate: Candidate, renderer: WebGLRenderer, scene: Scene, camera: PerspectiveCamera): void {
    poseFigure(figure, candidate, 0);
    const middle = new Vector3(0, 0.5 * figure.height, 0);
    camera.position.copy(middle).add(new Vector3(-0.42, 0.12, 1).normalize().multiplyScalar(2.2 * figure.height));
    camera.lookAt(middle);
    camera.aspect = kWidth / kHeight;
    camera.fov = 30;
    camera.updateProjectionMatrix();
    renderer.setSize(kWidth, kHeight, false);
    renderer.render(scene, camera);
    const picture = document.createElement('canvas');
    picture.width = kWidth;
    picture.height = kHeight;
    picture.getContext('2d')!.drawImage(renderer.domElement, 0, 0);
    this.drawn.set(character, { picture, mesh: isOwnMesh(figure) });
    for (const listener of this.listeners) listener();
  }

  subscribe(listener: () => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }
}
