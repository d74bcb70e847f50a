// SPDX-License-Identifier: MIT
// The scene with its light, floor and camera. Draws only when something has changed.
import { type Object3D, type PerspectiveCamera, Scene, Vector3, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { Look } from '../kept/work';
import type { ViewSettings } from '../state/view_settings';
import { directionOf, Lens } from './camera';
import { Floor } from './floor';
import { Light } from './light';
import { forgetUploads } from './lost_context';
import { type Palette, palettes } from './palette';
import { onBackground, type PictureSettings, pngOfView, smallPicture } from './picture';
import { type Quality, QualityControl } from './quality';

const kInside = 0.86; // of the picture, from its middle
const kBelowMessages = 0.7;
const kRest = 0.25; // s without movement until the fine picture
const kPatience = 0.8; // s that the first picture waits for its motions

export class Stage {
  readonly scene = new Scene();
  readonly lens = new Lens();
  /** Where the picture is seen from; `lens.shown` is what it is seen through. */
  readonly camera: PerspectiveCamera = this.lens.camera;
  readonly renderer: WebGLRenderer;
  readonly orbit: OrbitControls;
  palette: Palette = palettes.light;
  private readonly floor = new Floor();
  /** Part of the scene: all that casts shadows. */
  readonly casters = new Scene();
  readonly light: Light;
  readonly quality = new QualityControl();
  private drawn: Quality = this.quality.still;
  private dirty = true;
  private last = 0;
  private rested = 0; // s since something moved
  private filming = false;
  private ended = false;
  private lost = false; // the graphics card has let go of the page
  private waited = 0; // s for the first picture
  private begun = false;
  /** Whether the first picture is on the page; other slow work waits for it. */
  shown = false;
  private bring: () => void = () => undefined;
  readonly firstPicture = new Promise<void>((done) => (this.bring = done));
  /** Called before each picture with the time since the last one, s; true: something moves. */
  onFrame: (seconds: number) => boolean = () => false;
  onDraw: () => void = () => undefined;
  /** The graphics card has let go of the page, or is back. */
  onLost: (lost: boolean) => void = () => undefined;
  /** Whether the first picture had better wait, as what it is of is soon there: each takes a slow machine half a second. */
  isAwaited: () => boolean = () => false;

  constructor(private readonly host: HTMLElement, canvas: HTMLCanvasElement) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true, powerPreference: 'high-performance' });
    this.renderer.debug.checkShaderErrors = false; // who asks waits for the shader
    this.light = new Light(this.renderer, this.casters, this.drawn);
    for (const [event, lost] of [['webglcontextlost', true], ['webglcontextrestored', false]] as const) {
      canvas.addEventListener(event, () => this.setLost(lost));
    }
    this.orbit = new OrbitControls(this.camera, canvas);
    this.orbit.enableDamping = false;
    this.orbit.maxPolarAngle = Math.PI * 0.53;
    this.lens.follow(this.orbit);
    this.orbit.addEventListener('change', () => this.turned());
    this.scene.add(this.floor.object, this.light.object, this.casters);
    this.frame(1.741);
    this.paint('light');
    new ResizeObserver(() => this.resize()).observe(host);
    this.resize();
    requestAnimationFrame(this.tick);
  }

  /** Looks at a body of this stature: from the front right, as strip figures do, if nothing else is said. */
  frame(stature: number, direction = directionOf('threeQuarters', -1)): void {
    const middle = new Vector3(0, 0.49 * stature, 0.12 * stature);
    this.lookAt(middle, direction, 2.2 * stature);
  }

  /** Looks at a place from nearby, the same way as now. */
  approach(place: Vector3, away: number): void {
    this.lookAt(place, this.camera.position.clone().sub(this.orbit.target).normalize(), away);
  }

  /** `away`: how far with the usual lens, m. */
  private lookAt(place: Vector3, direction: Vector3, away: number): void {
    this.orbit.target.copy(place);
    this.camera.position.copy(place).addScaledVector(direction, away * this.lens.reach);
    this.orbit.update();
    this.invalidate();
  }

  setLens(view: ViewSettings): void {
    this.lens.set(view);
    this.orbit.update();
    this.invalidate();
  }

  look(): Look {
    return { position_m: this.camera.position.toArray(), target_m: this.orbit.target.toArray() };
  }

  lookFrom({ position_m, target_m }: Look): void {
    this.orbit.target.set(...target_m);
    this.camera.position.set(...position_m);
    this.orbit.update();
    this.invalidate();
  }

  /** Goes back until these places are in the picture: the first ones below the messages, others anywhere. */
  include(places: readonly Vector3[], anywhere: readonly Vector3[] = []): void {
    const isOutside = (place: Vector3, top: number): boolean => {
      const p = place.clone().project(this.camera);
      return Math.abs(p.x) > kInside || p.y < -kInside || p.y > top;
    };
    const outside = (): boolean => {
      this.camera.updateMatrixWorld();
      return places.some((place) => isOutside(place, kBelowMessages)) || anywhere.some((place) => isOutside(place, kInside));
    };
    const { target } = this.orbit;
    for (let tries = 0; tries < 20 && outside(); ++tries) {
      const away = this.camera.position.clone().sub(target);
      if (away.length() * 1.06 > this.orbit.maxDistance) break;
      this.camera.position.copy(target).addScaledVector(away, 1.06);
    }
    this.orbit.update();
    this.invalidate();
  }

  paint(theme: 'light' | 'dark'): void {
    const palette = (this.palette = palettes[theme]);
    this.floor.paint(palette);
    this.light.paint(palette);
    this.invalidate();
  }

  private setLost(lost: boolean): void {
    this.lost = lost;
    if (lost) forgetUploads(this.scene);
    this.onLost(lost);
    this.invalidate();
  }

  /** Something may have moved. */
  invalidate(): void {
    this.light.invalidate();
    this.dirty = true;
  }

  /** The camera alone has moved. */
  private turned(): void {
    this.dirty = true;
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.host;
    if (width === 0 || height === 0 || this.filming) return;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2) * this.drawn.pixels);
    this.renderer.setSize(width, height, false);
    this.lens.resize(width / height);
    this.invalidate();
  }

  private readonly tick = (now: number): void => {
    if (this.ended) return;
    requestAnimationFrame(this.tick);
    const seconds = (now - this.last) / 1000;
    this.last = now;
    if (this.filming || this.lost) return;
    if (this.begun && !this.shown) {
      this.shown = true;
      this.dirty = true; // now with shadows
      this.bring();
    }
    if (!this.begun && this.isAwaited() && (this.waited += Math.min(seconds, 0.1)) < kPatience) return;
    this.begun = true;
    if (this.onFrame(Math.min(seconds, 0.1))) this.dirty = true;
    if (this.dirty) {
      // a picture after a rest says nothing of speed
      if (this.rested === 0) this.quality.measure(seconds);
      this.rested = 0;
      this.draw(this.quality.moving);
      return;
    }
    this.rested += seconds;
    if (this.rested > kRest && this.drawn !== this.quality.still) this.draw(this.quality.still);
  };

  /** Makes the graphics card prepare the scene's shaders and buffers before the first picture. */
  prepare(): void {
    if (!this.begun) this.renderer.compile(this.casters, this.lens.shown, this.scene);
  }

  private draw(quality: Quality): void {
    if (quality !== this.drawn) {
      this.drawn = quality;
      this.light.setQuality(quality);
      this.resize();
    }
    this.onDraw();
    this.lens.sync();
    this.dirty = false; // movements meanwhile, such as the camera's, are in this picture
    if (this.shown) this.light.update(); // the first picture comes without shadows, a quarter sooner
    this.renderer.render(this.scene, this.lens.shown);
  }

  /** How many times as many pixels the graphics card can draw along each side of the view. */
  get mostTimes(): number {
    const gl = this.renderer.getContext();
    const most = Math.min(gl.getParameter(gl.MAX_RENDERBUFFER_SIZE) as number, ...(gl.getParameter(gl.MAX_VIEWPORT_DIMS) as Int32Array));
    return most / Math.max(this.host.clientWidth, this.host.clientHeight, 1);
  }

  /** The middle of the view, small and square, as a data URL. */
  small(side: number): string {
    this.draw(this.drawn);
    return smallPicture(this.renderer.domElement, this.host, side);
  }

  /** The view as PNG, without what `hidden` says is for the hand alone. */
  async picture({ times, transparent }: PictureSettings, hidden: readonly Object3D[]): Promise<Uint8Array> {
    const { clientWidth: width, clientHeight: height } = this.host;
    this.renderer.setPixelRatio(times);
    this.renderer.setSize(width, height, false);
    this.drawBare(transparent, hidden);
    const made = pngOfView(this.renderer.domElement, this.host, transparent);
    this.resize();
    this.draw(this.drawn);
    return made;
  }

  private drawBare(transparent: boolean, hidden: readonly Object3D[]): void {
    this.onDraw();
    const seen = hidden.filter((item) => item.visible);
    for (const item of seen) item.visible = false;
    this.floor.showSurface(!transparent);
    this.lens.sync();
    this.light.update();
    this.renderer.render(this.scene, this.lens.shown);
    for (const item of seen) item.visible = true;
    this.floor.showSurface(true);
  }

  /** Draws nothing but pictures of a film until it ends, of this size, px; of each `turn` says how far the camera has gone round, rad.
   *  Returns how a picture is put onto a canvas, and what ends the film. */
  film([width, height]: readonly [number, number], transparent: boolean, hidden: readonly Object3D[]): { draw: (pen: CanvasRenderingContext2D, turn: number) => void; end: () => void } {
    const { camera, orbit, renderer, host } = this;
    const from = camera.position.clone();
    const away = from.clone().sub(orbit.target);
    this.filming = true;
    orbit.enabled = false;
    renderer.setPixelRatio(1);
    renderer.setSize(width, height, false);
    this.lens.resize(width / height);
    const look = (turn: number): void => {
      camera.position.copy(away).applyAxisAngle(camera.up, turn).add(orbit.target);
      camera.lookAt(orbit.target);
    };
    return {
      draw: (pen, turn) => {
        look(turn);
        this.drawBare(transparent, hidden);
        onBackground(pen, renderer.domElement, host, transparent);
      },
      end: () => {
        camera.position.copy(from);
        camera.lookAt(orbit.target);
        this.filming = false;
        orbit.enabled = true;
        this.resize();
        this.draw(this.drawn);
      },
    };
  }

  dispose(): void {
    this.ended = true;
    this.orbit.dispose();
    this.light.dispose();
    this.renderer.dispose();
  }
}
