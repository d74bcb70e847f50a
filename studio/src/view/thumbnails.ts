// SPDX-License-Identifier: MIT
// Small moving pictures of the candidates. Each is a film of a few pictures, drawn once, a picture at a time, by
// one renderer with one figure; playing them costs next to nothing.
import { DirectionalLight, HemisphereLight, PerspectiveCamera, Scene, WebGLRenderer } from 'three';
import type { Candidate, Character } from '../../../bindings/wasm/src/types';
import { candidateAt } from '../state/model';
import type { Studio } from '../state/studio';
import { type CardView, cardView } from './card_camera';
import { disposeFigure, type Figure, makeFigure, poseFigure } from './figures';
import type { Palette } from './palette';
import { Portraits } from './portraits';

const kPictures = 16; // of a film
const kKeptHeight = 96; // px, of a picture in a list
const kPlayed = 60; // ms between changes of the picture
const kFov = 24; // degrees
const kRest = 0.7; // s at a motion's end

interface Film {
  candidate: Candidate;
  pictures: HTMLCanvasElement; // beside each other
  drawn: boolean[];
  view?: CardView; // from where it is seen
  left: number;
}

export class Thumbnails {
  private made: WebGLRenderer | null = null;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(kFov, 1, 0.1, 30);
  private readonly key = new DirectionalLight(0xffffff, 2.2);
  private readonly fill = new HemisphereLight(0xffffff, 0x888888, 1.3);
  private figure: Figure | null = null;
  private character: Character | null = null;
  private canvases: (HTMLCanvasElement | undefined)[] = []; // by candidate
  private films: (Film | undefined)[] = [];
  private next = 0;
  private drawnAt = 0;
  private playedAt = 0;
  private palette: Palette | null = null;
  readonly portraits = new Portraits();
  /** The last picture alone, for users who prefer reduced motion. */
  still = false;

  /** `pace`: pictures a second that may be drawn, so that the large view keeps its own; 0 until that has its first one. */
  constructor(private readonly studio: Studio, private readonly pace: () => number) {
    this.key.position.set(-2, 4, 3);
    this.scene.add(this.key, this.fill);
    requestAnimationFrame(this.tick);
  }

  private get renderer(): WebGLRenderer {
    if (!this.made) {
      this.made = new WebGLRenderer({ antialias: true, alpha: true });
      this.made.debug.checkShaderErrors = false; // as in the large view
    }
    return this.made;
  }

  paint(palette: Palette): void {
    this.palette = palette;
    this.fill.groundColor = palette.ground;
    this.fill.intensity = palette.ambient;
    this.key.intensity = palette.light;
    this.colour();
  }

  private colour(): void {
    this.films = [];
    if (!this.figure || !this.palette) return;
    this.figure.skin.color = this.palette.skin;
    this.figure.joints.color = this.palette.joints;
  }

  /** Canvases by the candidate's index. */
  show(canvases: (HTMLCanvasElement | undefined)[]): void {
    this.canvases = canvases;
  }

  private async setCharacter(character: Character | null): Promise<void> {
    this.character = character;
    if (this.figure) disposeFigure(this.figure);
    this.figure = null; // nothing is drawn until this one's is there
    const figure = character ? await makeFigure(character) : null;
    if (this.character !== character) {
      if (figure) disposeFigure(figure);
      return;
    }
    this.figure = figure;
    if (!figure || !character) return;
    this.scene.add(figure.object);
    this.colour();
  }

  /** A candidate at its end, small, as a data URL; null until it is drawn. */
  pictureOf(index: number): string | null {
    const film = this.films[index];
    if (!film?.drawn[kPictures - 1]) return null;
    const width = film.pictures.width / kPictures;
    const { height } = film.pictures;
    const canvas = globalThis.document.createElement('canvas');
    canvas.height = kKeptHeight;
    canvas.width = Math.max(Math.round((kKeptHeight * width) / height), 1);
    canvas.getContext('2d')!.drawImage(film.pictures, (kPictures - 1) * width, 0, width, height, 0, 0, canvas.width, canvas.height);
    return canvas.toDataURL('image/png');
  }

  private readonly tick = (now: number): void => {
    requestAnimationFrame(this.tick);
    const pace = this.pace();
    if (pace === 0 || document.hidden || this.studio.store.state.dragging || this.made?.getContext().isContextLost()) return;
    const character = this.studio.document?.character ?? null;
    if (character !== this.character) void this.setCharacter(character);
    if (!this.figure) return;
    if (now - this.drawnAt >= 1000 / pace && this.drawNext()) this.drawnAt = now;
    if (now - this.playedAt < kPlayed) return;
    this.playedAt = now;
    this.canvases.forEach((_, index) => this.play(index, now / 1000));
  };

  /** The next picture that is missing, the portrait once a card has something to show; false where none is. */
  private drawNext(): boolean {
    const begun = this.films.some((film) => film?.drawn[kPictures - 1]);
    return (begun && this.drawPortrait()) || this.drawOneOfFilms() || this.drawPortrait();
  }

  private drawOneOfFilms(): boolean {
    for (let tries = 0; tries < this.canvases.length; ++tries) {
      this.next = (this.next + 1) % this.canvases.length;
      if (this.drawOne(this.next)) return true;
    }
    return false;
  }

  private drawPortrait(): boolean {
    const { figure, character } = this;
    const { document } = this.studio;
    const candidate = document && document.character === character ? candidateAt(document, document.chosen) : null;
    if (!figure || !character || !candidate || this.portraits.of(character)) return false;
    this.portraits.draw(character, figure, candidate, this.renderer, this.scene, this.camera);
    return true;
  }

  /** The film of a candidate in the size that its canvas has now. */
  private film(index: number): Film | null {
    const canvas = this.canvases[index];
    const { document } = this.studio;
    const candidate = document ? candidateAt(document, index) : null;
    if (!canvas?.isConnected || !candidate) return null;
    const ratio = Math.min(window.devicePixelRatio, 2);
    const width = Math.round(canvas.clientWidth * ratio);
    const height = Math.round(canvas.clientHeight * ratio);
    if (width === 0 || height === 0) return null;
    const old = this.films[index];
    if (old?.candidate === candidate && old.pictures.width === width * kPictures && old.pictures.height === height) return old;
    const pictures = globalThis.document.createElement('canvas');
    pictures.width = width * kPictures;
    pictures.height = height;
    const film: Film = { candidate, pictures, drawn: Array.from({ length: kPictures }, () => false), left: this.still ? 1 : kPictures };
    this.films[index] = film;
    return film;
  }

  /** Draws one more picture of a film, the last one first; false where none is missing. */
  private drawOne(index: number): boolean {
    const film = this.film(index);
    if (!film || film.left === 0 || !this.figure) return false;
    const picture = film.drawn[kPictures - 1] ? kPictures - 1 - film.left : kPictures - 1;
    const width = film.pictures.width / kPictures;
    const { height } = film.pictures;
    this.camera.aspect = width / height;
    this.camera.fov = kFov;
    const view = (film.view ??= cardView(this.figure, film.candidate, this.camera));
    poseFigure(this.figure, film.candidate, (film.candidate.summary.duration_s * picture) / (kPictures - 1));
    this.renderer.setSize(width, height, false);
    this.camera.position.copy(view.from);
    this.camera.lookAt(view.at);
    this.camera.updateProjectionMatrix();
    this.renderer.render(this.scene, this.camera);
    film.pictures.getContext('2d')!.drawImage(this.renderer.domElement, picture * width, 0);
    film.drawn[picture] = true;
    --film.left;
    return true;
  }

  private play(index: number, seconds: number): void {
    const film = this.film(index);
    const canvas = this.canvases[index];
    if (!film?.drawn[kPictures - 1] || !canvas) return;
    const duration = film.candidate.summary.duration_s;
    const since = seconds % (duration + kRest);
    const last = kPictures - 1;
    const wanted = this.still ? last : Math.min(Math.round((since / duration) * last), last);
    const picture = film.drawn[wanted] ? wanted : last;
    const width = film.pictures.width / kPictures;
    const { height } = film.pictures;
    if (canvas.width !== width || canvas.height !== height) {
      canvas.width = width;
      canvas.height = height;
    }
    const pen = canvas.getContext('2d')!;
    pen.clearRect(0, 0, width, height);
    pen.drawImage(film.pictures, picture * width, 0, width, height, 0, 0, width, height);
  }
}
