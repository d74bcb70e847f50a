// SPDX-License-Identifier: MIT
// Signs over two figures that are compared: the number that its card has, and how long its motion lasts.
import { CanvasTexture, Group, Sprite, SpriteMaterial, SRGBColorSpace, type Vector3 } from 'three';

const kHigh = 0.026; // of a sign, of the picture's height at a distance of 1
const kAbove = 0.06; // statures, over the head
const kPixels = 64; // px high

export interface Tag {
  readonly text: string;
  readonly colour: string;
  readonly place: Vector3; // below it
}

interface Drawn {
  readonly sprite: Sprite;
  text: string;
}

function makeTag(): Drawn {
  const sprite = new Sprite(new SpriteMaterial({ depthTest: false, depthWrite: false, transparent: true, sizeAttenuation: false }));
  sprite.renderOrder = 9;
  sprite.visible = false;
  return { sprite, text: '' };
}

export class Tags {
  readonly object = new Group();
  private readonly tags = [makeTag(), makeTag()];

  constructor() {
    this.object.add(...this.tags.map(({ sprite }) => sprite));
  }

  /** Texts as they are shown; for tests. */
  get texts(): string[] {
    return this.tags.filter(({ sprite }) => sprite.visible).map(({ text }) => text);
  }

  /** `size`: how large a thing of constant size is drawn. */
  show(texts: readonly Tag[], stature: number, size: number): void {
    this.tags.forEach((tag, k) => {
      const asked = texts[k];
      tag.sprite.visible = asked !== undefined;
      if (!asked) return;
      const { text, colour, place } = asked;
      if (tag.text !== text || tag.sprite.userData['colour'] !== colour) this.draw(tag, text, colour);
      const wide = tag.sprite.userData['wide'] as number;
      tag.sprite.position.copy(place).setY((1 + kAbove) * stature);
      tag.sprite.scale.set(kHigh * wide * size, kHigh * size, 1);
    });
  }

  private draw(tag: Drawn, text: string, colour: string): void {
    const canvas = document.createElement('canvas');
    const pen = canvas.getContext('2d')!;
    const font = `600 ${0.56 * kPixels}px system-ui, sans-serif`;
    pen.font = font;
    canvas.width = Math.ceil(pen.measureText(text).width + 0.6 * kPixels);
    canvas.height = kPixels;
    pen.fillStyle = colour;
    pen.beginPath();
    pen.roundRect(0, 0, canvas.width, kPixels, kPixels / 2);
    pen.fill();
    pen.font = font;
    pen.fillStyle = '#ffffff';
    pen.textAlign = 'center';
    pen.textBaseline = 'middle';
    pen.fillText(text, canvas.width / 2, 0.53 * kPixels);
    const { material } = tag.sprite;
    material.map?.dispose();
    material.map = new CanvasTexture(canvas);
    material.map.colorSpace = SRGBColorSpace;
    material.needsUpdate = true;
    tag.text = text;
    tag.sprite.userData = { colour, wide: canvas.width / kPixels };
  }
}
