// SPDX-License-Identifier: MIT
// A film that the browser's recorder writes while it is played: as long as it lasts, so long it takes. A machine that draws slower than the
// pictures follow each other gives fewer of them; the motion's time stays right.
import { bitsPerSecond, canvasOf, type Film } from './film_settings';
import { withDuration } from './webm';

const kTypes = ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm'] as const;

function recordedType(): string | null {
  if (typeof MediaRecorder === 'undefined' || !('captureStream' in HTMLCanvasElement.prototype)) return null;
  return kTypes.find((type) => MediaRecorder.isTypeSupported(type)) ?? null;
}

export const canRecord = (): boolean => recordedType() !== null;

export async function recorded(film: Film, signal: AbortSignal, progress: (share: number) => void): Promise<Uint8Array> {
  const { settings, pictures } = film;
  const mimeType = recordedType();
  if (mimeType === null) throw new Error('the browser can make no film of this kind');
  const pen = canvasOf(settings);
  const stream = pen.canvas.captureStream(settings.fps);
  const recorder = new MediaRecorder(stream, { mimeType, videoBitsPerSecond: bitsPerSecond(settings) });
  const parts: Blob[] = [];
  const ended = new Promise<void>((resolve, reject) => {
    recorder.addEventListener('dataavailable', ({ data }) => parts.push(data));
    recorder.addEventListener('stop', () => resolve());
    recorder.addEventListener('error', () => reject(new Error('the browser stopped the film')));
  });
  try {
    recorder.start();
    film.draw(pen, 0); // recording starts here
    await play(film, signal, (picture) => {
      film.draw(pen, picture);
      progress((picture + 1) / pictures);
    });
    recorder.stop();
    await ended;
  } finally {
    if (recorder.state !== 'inactive') recorder.stop();
    for (const track of stream.getTracks()) track.stop();
  }
  return withDuration(new Uint8Array(await new Blob(parts).arrayBuffer()), pictures / settings.fps);
}

/** Calls `step` for each picture whose time has come, for the last one too, which stays for as long as each. */
function play({ pictures, settings: { fps } }: Film, signal: AbortSignal, step: (picture: number) => void): Promise<void> {
  return new Promise((resolve, reject) => {
    const since = performance.now();
    let drawn = 0;
    const tick = (): void => {
      if (signal.aborted) return reject(signal.reason as Error);
      const now = Math.floor(((performance.now() - since) / 1000) * fps);
      if (now >= pictures && drawn === pictures - 1) return resolve();
      const next = Math.min(now, pictures - 1);
      if (next > drawn) {
        drawn = next;
        try {
          step(next);
        } catch (error) {
          return reject(error);
        }
      }
      requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
  });
}
