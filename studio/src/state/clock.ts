// SPDX-License-Identifier: MIT
// Where in the motion we are. Apart from the store, as it changes with every picture.

export class Clock {
  private listeners = new Set<(time: number) => void>();
  private seconds = 0;
  duration = 1; // s
  /** How long a loop rests at the motion's end, s. */
  readonly rest = 0.9;
  private rested = 0;

  get time(): number {
    return this.seconds;
  }

  set time(value: number) {
    const time = Math.min(Math.max(value, 0), this.duration);
    this.rested = 0;
    if (time === this.seconds) return;
    this.seconds = time;
    for (const listener of this.listeners) listener(time);
  }

  /** Goes on by `seconds`; false where a motion that does not loop has come to its end. */
  advance(seconds: number, loop: boolean): boolean {
    if (this.seconds < this.duration) {
      this.time = this.seconds + seconds;
      return true;
    }
    if (!loop) return false;
    this.rested += seconds;
    if (this.rested >= this.rest) this.time = 0;
    return true;
  }

  subscribe(listener: (time: number) => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }
}
