// SPDX-License-Identifier: MIT
// A ruler beside the figure, as high as it is: a tick each 10 cm, a number each 50 cm, in inches each 3 and 12, and the stature at its end. It turns
// with the camera, so that it always stands at the figure's right side in the picture.
import {
  type Camera, CanvasTexture, DoubleSide, Group, type BufferGeometry, Mesh, MeshBasicMaterial, PlaneGeometry, Sprite, SpriteMaterial, SRGBColorSpace, Vector3,
} from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import { lengths, statureWords } from '../i18n/lengths';
import type { Palette } from './palette';

const kAside = 0.37; // statures from the body's middle
/** In units of length: from tick to tick; and ticks from number to number. */
const kScales = { cm: { step: 10, numbered: 5 }, in: { step: 3, numbered: 4 } } as const;
const kMostSteps = 60; // of a giant ticks are farther apart
const kTick = 0.028; // m long
const kLine = 0.0045; // m thick
const kLetters = 0.05; // m high

export class Ruler {
  readonly object = new Group();
  private readonly material = new MeshBasicMaterial({ side: DoubleSide, transparent: true });
  private readonly level = new MeshBasicMaterial({ side: DoubleSide, transparent: true, opacity: 0.45 });
  private scale: Mesh | null = null;
  private stature_m = 0;
  private colour = '';

  constructor() {
    this.object.visible = false;
  }

  /** How high it is drawn, m, and its numbers; null where it is not shown. */
  get drawn(): { height_m: number; texts: string[] } | null {
    if (!this.object.visible || !this.scale) return null;
    this.scale.geometry.computeBoundingBox();
    return { height_m: this.scale.geometry.boundingBox!.max.y, texts: this.object.children.flatMap(({ userData }) => ('text' in userData ? [String(userData['text'])] : [])) };
  }

  paint(palette: Palette): void {
    this.material.color = this.level.color = palette.ruler;
    const colour = `#${palette.ruler.getHexString()}`;
    if (colour === this.colour) return;
    this.colour = colour;
    this.build();
  }

  setStature(stature_m: number): void {
    if (stature_m === this.stature_m) return;
    this.stature_m = stature_m;
    this.build();
  }

  /** Anew, as in another unit of lengths. */
  build(): void {
    for (const child of [...this.object.children]) {
      child.removeFromParent();
      if (child instanceof Mesh) (child.geometry as BufferGeometry).dispose();
      if (child instanceof Sprite) {
        child.material.map?.dispose();
        child.material.dispose();
      }
    }
    const height = this.stature_m;
    if (!(height > 0)) return;
    const { name: unit, perMetre } = lengths();
    const { step: least, numbered } = kScales[unit];
    let long = 1;
    while ((height * perMetre) / (least * long) > kMostSteps) long *= 10;
    const step = (least * long) / perMetre; // m; all of a giant's ruler is larger
    const parts = [bar(0, kLine * long, 0, height)];
    for (let k = 0; k * step <= height + 1e-9; ++k) {
      const isNumbered = k % numbered === 0;
      const thick = kLine * long * 0.8;
      const y = Math.max(k * step, thick / 2);
      parts.push(bar(-kTick * long * (isNumbered ? 2 : 1), 0, y - thick / 2, Math.min(y + thick / 2, height)));
      // the last number would stand in the stature's
      if (isNumbered && k > 0 && height - k * step > kLetters * long) this.object.add(this.label(String(k * least * long), k * step, long, 0.75));
    }
    this.object.add(this.label(statureWords(height), height, long, 1));
    this.scale = new Mesh(mergeGeometries(parts), this.material);
    this.object.add(this.scale, new Mesh(bar(-kAside * height, 0, height - 0.6 * kLine * long, height), this.level));
  }

  private label(text: string, y: number, long: number, size: number): Sprite {
    const canvas = document.createElement('canvas');
    const pen = canvas.getContext('2d')!;
    const font = '600 44px system-ui, sans-serif';
    pen.font = font;
    canvas.width = Math.ceil(pen.measureText(text).width) + 8;
    canvas.height = 56;
    pen.font = font;
    pen.fillStyle = this.colour;
    pen.textBaseline = 'middle';
    pen.fillText(text, 4, 30);
    const map = new CanvasTexture(canvas);
    map.colorSpace = SRGBColorSpace;
    const sprite = new Sprite(new SpriteMaterial({ map, depthWrite: false, transparent: true }));
    const high = kLetters * long * size;
    sprite.scale.set((high * canvas.width) / canvas.height, high, 1);
    sprite.center.set(0, 0.5);
    sprite.position.set(0.02 * long, y, 0);
    sprite.userData['text'] = text;
    return sprite;
  }

  /** At the right side of a body that stands at a place, as the camera sees it. */
  pose(camera: Camera, place: Vector3, shown: boolean): void {
    this.object.visible = shown;
    if (!shown) return;
    const right = new Vector3().setFromMatrixColumn(camera.matrixWorld, 0).setY(0).normalize();
    this.object.rotation.y = Math.atan2(-right.z, right.x);
    this.object.position.copy(place).addScaledVector(right, kAside * this.stature_m);
  }
}

function bar(left: number, right: number, low: number, high: number): PlaneGeometry {
  const plane = new PlaneGeometry(right - left, high - low);
  plane.translate((left + right) / 2, (low + high) / 2, 0);
  return plane;
}
