// SPDX-License-Identifier: MIT
// How long a hand waits for the picture: the last hundred of each kind.

export interface Timing {
  total_ms: number; // from the event to the new motion in the page
  engine_ms: number; // of it inside the engine
}

const kMost = 100;

export class Timings {
  readonly dragToPose: Timing[] = [];
  readonly sliderToMotion: Timing[] = [];
  readonly search: Timing[] = [];

  add(list: Timing[], since: number, engine_ms: number): void {
    list.push({ total_ms: performance.now() - since, engine_ms });
    if (list.length > kMost) list.shift();
  }
}
