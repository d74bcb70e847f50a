// SPDX-License-Identifier: MIT
// Joints that need more than they have, or go beyond their range, glow red on the figure: faintly all the time, brightly while
// they do.
import { CanvasTexture, Color, Group, Sprite, SpriteMaterial, SRGBColorSpace, type Vector3 } from 'three';
import type { Candidate, CharacterDescription } from '../../../bindings/wasm/src/types';
import { strainedJoints } from '../state/verdict';
import { momentAt, valueAt } from './pose';
import type { Palette } from './palette';

const kSize = 0.1; // shares of the stature
const kFaint = 0.45; // opacities
const kBright = 1;

interface Mark {
  joint: string;
  sprite: Sprite;
  freedoms: { column: number; strength: readonly [number, number] }[];
}

export class StrainedJoints {
  readonly object = new Group();
  private readonly texture = glow();
  private marks: Mark[] = [];
  private shown: Candidate | null = null;
  private colour = new Color('red');

  paint(palette: Palette): void {
    this.colour = palette.missing;
    for (const { sprite } of this.marks) sprite.material.color = this.colour;
  }

  get names(): string[] {
    return this.marks.map(({ joint }) => joint);
  }

  show(candidate: Candidate | null, description: CharacterDescription | undefined): void {
    if (candidate === this.shown) return;
    this.shown = candidate;
    for (const { sprite } of this.marks) {
      sprite.material.dispose();
      sprite.removeFromParent();
    }
    this.marks = [];
    if (!candidate || !description) return;
    for (const [joint, names] of strainedJoints(candidate)) {
      const material = new SpriteMaterial({ map: this.texture, color: this.colour, depthTest: false, depthWrite: false, transparent: true });
      const sprite = new Sprite(material);
      sprite.scale.setScalar(kSize * description.stature_m);
      sprite.renderOrder = 4;
      const freedoms = names.map((name) => description.joints.findIndex((freedom) => freedom.name === name)).filter((column) => column >= 0)
        .map((column) => ({ column, strength: description.joints[column]!.strength_nm }));
      this.marks.push({ joint, sprite, freedoms });
      this.object.add(sprite);
    }
  }

  /** `placeOf`: where a joint is drawn now, null where it is not. */
  pose(seconds: number, placeOf: (joint: string) => Vector3 | null): void {
    const { shown } = this;
    if (!shown) return;
    const { time, torques } = shown.series;
    const moment = momentAt(time, seconds);
    for (const { joint, sprite, freedoms } of this.marks) {
      const place = placeOf(joint);
      sprite.visible = place !== null;
      if (!place) continue;
      sprite.position.copy(place);
      const over = freedoms.some(({ column, strength: [low, high] }) => {
        const torque = valueAt(torques, moment, column);
        return torque > high || torque < low;
      });
      sprite.material.opacity = over ? kBright : kFaint;
    }
  }
}

/** A disc that fades outwards. */
function glow(): CanvasTexture {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 64;
  const pen = canvas.getContext('2d')!;
  const shade = pen.createRadialGradient(32, 32, 2, 32, 32, 32);
  shade.addColorStop(0, 'rgba(255,255,255,0.95)');
  shade.addColorStop(0.45, 'rgba(255,255,255,0.75)');
  shade.addColorStop(1, 'rgba(255,255,255,0)');
  pen.fillStyle = shade;
  pen.fillRect(0, 0, 64, 64);
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  return texture;
}
