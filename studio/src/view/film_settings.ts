// SPDX-License-Identifier: MIT
// The settings and pictures of a film, for both ways to make one.

export interface FilmSettings {
  readonly size: readonly [width: number, height: number]; // px
  readonly fps: number;
  readonly plays: number; // of the motion; 0: the moment that is shown
  readonly turntable: boolean; // the camera goes round once
  readonly transparent: boolean;
}

/** A film to be made: as many pictures, each for as long as the others. */
export interface Film {
  readonly settings: FilmSettings;
  readonly pictures: number;
  draw(pen: CanvasRenderingContext2D, picture: number): void;
}

/** `isRead`: its pixels are, and not its picture alone. */
export function canvasOf({ size: [width, height] }: FilmSettings, isRead = false): CanvasRenderingContext2D {
  const canvas = document.createElement('canvas');
  canvas.width = width;
  canvas.height = height;
  return canvas.getContext('2d', { willReadFrequently: isRead })!;
}

export function bitsPerSecond({ size: [width, height], fps }: FilmSettings): number {
  return 0.15 * width * height * fps; // bits a pixel
}
