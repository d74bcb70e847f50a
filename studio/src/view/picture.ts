// SPDX-License-Identifier: MIT
// The view as a picture in a file: finer than the screen where that is asked for, on the page's background or on none.

const kSmallQuality = 0.85;

export interface PictureSettings {
  readonly times: number; // as many pixels along each side as the view has
  readonly transparent: boolean;
}

/** The background that the page has behind the view: styles/page.css draws the same. */
function fillBackground(pen: CanvasRenderingContext2D, host: HTMLElement): void {
  const { width, height } = pen.canvas;
  const style = getComputedStyle(host);
  const [x, y] = [0.5 * width, 0.35 * height];
  const across = Math.SQRT2 * 0.5 * width;
  const down = Math.SQRT2 * 0.65 * height;
  const shade = pen.createRadialGradient(0, 0, 0, 0, 0, 1);
  shade.addColorStop(0, style.getPropertyValue('--stage-top'));
  shade.addColorStop(1, style.getPropertyValue('--stage-bottom'));
  pen.save();
  pen.translate(x, y);
  pen.scale(across, down);
  pen.fillStyle = shade;
  pen.fillRect(-x / across, -y / down, width / across, height / down);
  pen.restore();
}

/** Draws a picture of the size of the pen's canvas in place of its content. */
export function onBackground(pen: CanvasRenderingContext2D, drawn: HTMLCanvasElement, host: HTMLElement, transparent: boolean): void {
  if (transparent) pen.clearRect(0, 0, pen.canvas.width, pen.canvas.height);
  else fillBackground(pen, host);
  pen.drawImage(drawn, 0, 0);
}

/** `drawn`: the picture as it was just drawn, before the browser shows it. */
export async function pngOfView(drawn: HTMLCanvasElement, host: HTMLElement, transparent: boolean): Promise<Uint8Array> {
  const canvas = document.createElement('canvas');
  canvas.width = drawn.width;
  canvas.height = drawn.height;
  onBackground(canvas.getContext('2d')!, drawn, host, transparent);
  const blob = await new Promise<Blob | null>((done) => canvas.toBlob(done, 'image/png'));
  if (!blob) throw new Error('the picture could not be made');
  return new Uint8Array(await blob.arrayBuffer());
}

/** The same, small and square, as a data URL. */
export function smallPicture(drawn: HTMLCanvasElement, host: HTMLElement, side: number): string {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = side;
  const pen = canvas.getContext('2d')!;
  fillBackground(pen, host);
  const from = Math.min(drawn.width, drawn.height);
  pen.drawImage(drawn, (drawn.width - from) / 2, (drawn.height - from) / 2, from, from, 0, 0, side, side);
  return canvas.toDataURL('image/jpeg', kSmallQuality);
}
