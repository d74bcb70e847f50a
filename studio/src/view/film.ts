// SPDX-License-Identifier: MIT
// The view as a film, which the browser's recorder writes while it is played: as long as it lasts, so long it takes. A machine that draws slower
// than the film's pictures follow each other gives fewer of them; the motion's time stays right.
import { withDuration } from './webm';

const kTypes = ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm'] as const;
const kBitsPerPixel = 0.15;
const kHeld_s = 6; // of a film of one moment
const kWholeTurn = 2 * Math.PI;

export interface FilmSettings {
  readonly size: readonly [width: number, height: number]; // px
  readonly fps: number;
  readonly plays: number; // of the motion; 0: the moment that is shown
  readonly turntable: boolean; // the camera goes round once
  readonly transparent: boolean;
}

/** What is filmed. */
export interface Scene {
  readonly duration: number; // s, of the motion
  /** Puts the picture of a time onto the canvas; null: of the moment that is shown. */
  draw(pen: CanvasRenderingContext2D, time: number | null, turn: number): void;
}

/** What this browser can record; null: no film. */
export function filmType(): string | null {
  if (typeof MediaRecorder === 'undefined' || !('captureStream' in HTMLCanvasElement.prototype)) return null;
  return kTypes.find((type) => MediaRecorder.isTypeSupported(type)) ?? null;
}

export const lengthOf = ({ plays }: FilmSettings, duration: number): number => (plays > 0 ? plays * duration : kHeld_s);

/** The WebM file; rejects with an AbortError where `signal` ends it. */
export async function film(scene: Scene, settings: FilmSettings, signal: AbortSignal, progress: (share: number) => void): Promise<Uint8Array> {
  const { size: [width, height], fps, plays, turntable } = settings;
  const length = lengthOf(settings, scene.duration);
  const canvas = document.createElement('canvas');
  canvas.width = width;
  canvas.height = height;
  const pen = canvas.getContext('2d')!;
  const draw = (seconds: number): void => {
    const time = plays === 0 ? null : seconds >= length ? scene.duration : seconds % scene.duration;
    scene.draw(pen, time, turntable ? (kWholeTurn * seconds) / length : 0);
  };
  const stream = canvas.captureStream(fps);
  const recorder = new MediaRecorder(stream, { mimeType: filmType()!, videoBitsPerSecond: width * height * fps * kBitsPerPixel });
  const parts: Blob[] = [];
  const ended = new Promise<void>((resolve, reject) => {
    recorder.addEventListener('dataavailable', ({ data }) => parts.push(data));
    recorder.addEventListener('stop', () => resolve());
    recorder.addEventListener('error', () => reject(new Error('the browser stopped the film')));
  });
  try {
    recorder.start();
    draw(0); // only what is drawn from here on is recorded
    await play(length, fps, signal, (seconds) => {
      draw(seconds);
      progress(seconds / length);
    });
    recorder.stop();
    await ended;
  } finally {
    if (recorder.state !== 'inactive') recorder.stop();
    for (const track of stream.getTracks()) track.stop();
  }
  return withDuration(new Uint8Array(await new Blob(parts).arrayBuffer()), length);
}

/** Calls `step` for each picture as time goes by, for the last one too, which stays for as long as each. */
function play(length: number, fps: number, signal: AbortSignal, step: (seconds: number) => void): Promise<void> {
  return new Promise((resolve, reject) => {
    const since = performance.now();
    let drawn = 0; // pictures
    const last = Math.round(length * fps);
    const tick = (): void => {
      if (signal.aborted) return reject(signal.reason as Error);
      const now = Math.floor(((performance.now() - since) / 1000) * fps);
      if (now > last && drawn === last) return resolve();
      const next = Math.min(now, last);
      if (next > drawn) {
        drawn = next;
        try {
          step(next === last ? length : next / fps);
        } catch (error) {
          return reject(error);
        }
      }
      requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
  });
}
