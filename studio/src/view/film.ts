// SPDX-License-Identifier: MIT
// The view as a film: picture by picture where the browser encodes pictures that it is given, however long each takes to be drawn; else as
// its recorder writes it while it is played.
import { encoded, encodingOf } from './film_encoded';
import { canRecord, recorded } from './film_recorded';
import type { Film, FilmSettings } from './film_settings';

export type { FilmSettings } from './film_settings';

const kHeld_s = 6; // of a film of one moment
const kWholeTurn = 2 * Math.PI;

/** What is filmed. */
export interface Scene {
  readonly duration: number; // s, of the motion
  /** Puts the picture of a time onto the canvas; null: of the moment that is shown. */
  draw(pen: CanvasRenderingContext2D, time: number | null, turn: number): void;
}

export const canFilm = (): boolean => typeof VideoEncoder !== 'undefined' || canRecord();

const lengthOf = ({ plays }: FilmSettings, duration: number): number => (plays > 0 ? plays * duration : kHeld_s);

const picturesOf = (settings: FilmSettings, duration: number): number => Math.max(Math.round(lengthOf(settings, duration) * settings.fps), 1);

/** How long a film lasts, s. */
export const secondsOf = (settings: FilmSettings, duration: number): number => picturesOf(settings, duration) / settings.fps;

/** The last picture of a motion is of its end; of the camera's way round each is another. */
function filmOf(scene: Scene, settings: FilmSettings): Film {
  const { fps, plays, turntable } = settings;
  const pictures = picturesOf(settings, scene.duration);
  return {
    settings, pictures,
    draw: (pen, picture) => {
      const time = plays === 0 ? null : picture === pictures - 1 ? scene.duration : (picture / fps) % scene.duration;
      scene.draw(pen, time, turntable ? (kWholeTurn * picture) / pictures : 0);
    },
  };
}

/** Whether a film of this kind is recorded while it is played, which a page must be seen for. */
export const isPlayed = async (settings: FilmSettings): Promise<boolean> => (await encodingOf(settings)) === null;

/** The WebM file; rejects with the reason of `signal`. */
export async function film(scene: Scene, settings: FilmSettings, signal: AbortSignal, progress: (share: number) => void): Promise<Uint8Array> {
  const made = filmOf(scene, settings);
  const encoding = await encodingOf(settings);
  return encoding ? encoded(made, encoding, signal, progress) : recorded(made, signal, progress);
}
