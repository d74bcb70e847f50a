// SPDX-License-Identifier: MIT
// Small moving pictures of the candidates: one renderer and one figure for all, a card at a time.
import {
  DirectionalLight, HemisphereLight, PerspectiveCamera, Scene, Vector3, WebGLRenderer,
} from 'three';
import type { Character } from '../../../bindings/wasm/src/types';
import { candidateAt } from '../state/model';
import type { Studio } from '../state/studio';
import { disposeFigure, type Figure, makeFigure } from './figures';
import { poseNodes } from './pose';
import { type Palette } from './palette';

/** Pictures a second of all cards together, so that the large view keeps its own. */
const kPictures = 40;
const kRest = 0.7; // s at a motion's end

export class Thumbnails {
  private readonly renderer = new WebGLRenderer({ antialias: true, alpha: true });
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(30, 1, 0.1, 30);
  private readonly key = new DirectionalLight(0xffffff, 2.2);
  private readonly fill = new HemisphereLight(0xffffff, 0x888888, 1.3);
  private figure: Figure | null = null;
  private character: Character | null = null;
  private canvases: (HTMLCanvasElement | undefined)[] = []; // by candidate
  private next = 0;
  private last = 0;
  private started = performance.now();
  private ended = false;
  private palette: Palette | null = null;
  still = false;

  constructor(private readonly studio: Studio) {
    this.key.position.set(-2, 4, 3);
    this.scene.add(this.key, this.fill);
    requestAnimationFrame(this.tick);
  }

  paint(palette: Palette): void {
    this.palette = palette;
    this.fill.groundColor = palette.ground;
    this.fill.intensity = palette.ambient;
    this.key.intensity = palette.light;
    this.colour();
  }

  private colour(): void {
    if (!this.figure || !this.palette) return;
    this.figure.skin.color = this.palette.skin;
    this.figure.joints.color = this.palette.joints;
  }

  /** Canvases by the candidate's index. */
  show(canvases: (HTMLCanvasElement | undefined)[]): void {
    this.canvases = canvases;
    const character = this.studio.document?.character ?? null;
    if (character !== this.character) void this.setCharacter(character);
  }

  private async setCharacter(character: Character | null): Promise<void> {
    this.character = character;
    const figure = character ? await makeFigure(character) : null;
    if (this.character !== character) {
      if (figure) disposeFigure(figure);
      return;
    }
    if (this.figure) disposeFigure(this.figure);
    this.figure = figure;
    if (!figure || !character) return;
    this.scene.add(figure.object);
    this.colour();
    const stature = character.description.stature_m;
    const middle = new Vector3(0, 0.5 * stature, 0.12 * stature);
    this.camera.position.copy(middle).add(new Vector3(-0.62, 0.22, 1).normalize().multiplyScalar(2.15 * stature));
    this.camera.lookAt(middle);
  }

  private readonly tick = (now: number): void => {
    if (this.ended) return;
    requestAnimationFrame(this.tick);
    if (now - this.last < 1000 / kPictures || !this.figure || document.hidden || this.studio.store.state.dragging) return;
    this.last = now;
    for (let tries = 0; tries < this.canvases.length; ++tries) {
      this.next = (this.next + 1) % this.canvases.length;
      if (this.draw(this.next, now)) return;
    }
  };

  private draw(index: number, now: number): boolean {
    const canvas = this.canvases[index];
    const { document } = this.studio;
    if (!canvas?.isConnected || !document || !this.figure) return false;
    const candidate = candidateAt(document, index);
    if (!candidate) return false;
    const duration = candidate.summary.duration_s;
    const since = ((now - this.started) / 1000) % (duration + kRest);
    poseNodes(this.figure.nodes, candidate, this.still ? duration : Math.min(since, duration));
    const ratio = Math.min(window.devicePixelRatio, 2);
    const width = Math.round(canvas.clientWidth * ratio);
    const height = Math.round(canvas.clientHeight * ratio);
    if (width === 0 || height === 0) return false;
    if (canvas.width !== width || canvas.height !== height) {
      canvas.width = width;
      canvas.height = height;
    }
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.fov = this.camera.aspect < 0.9 ? 30 * (0.9 / this.camera.aspect) : 30;
    this.camera.updateProjectionMatrix();
    this.renderer.render(this.scene, this.camera);
    const pen = canvas.getContext('2d')!;
    pen.clearRect(0, 0, width, height);
    pen.drawImage(this.renderer.domElement, 0, 0);
    return true;
  }

  dispose(): void {
    this.ended = true;
    if (this.figure) disposeFigure(this.figure);
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }
}
