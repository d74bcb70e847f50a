// SPDX-License-Identifier: MIT
// How finely is drawn, by how long pictures take here: less while something moves on a slow machine, all of it
// again once it rests.

export interface Quality {
  pixels: number; // share of the screen's resolution
  shadow: number; // px of the shadow's map
  thumbnails: number; // pictures a second
}

const kLevels: readonly Quality[] = [
  { pixels: 1, shadow: 1024, thumbnails: 40 },
  { pixels: 0.8, shadow: 1024, thumbnails: 14 },
  { pixels: 0.55, shadow: 512, thumbnails: 6 },
];
const kSlow = 0.055; // s between pictures: coarser
const kFast = 0.024; // s: finer
const kPatience = 8; // pictures in a row until the level changes
const kMemory = 0.75; // of the mean

export class QualityControl {
  private level = 0;
  private mean = 1 / 60;
  private since = 0;

  get moving(): Quality {
    return kLevels[this.level]!;
  }
  get still(): Quality {
    return kLevels[0]!;
  }

  /** The time since the last picture, of two in a row. True: the level has changed. */
  measure(seconds: number): boolean {
    this.mean = kMemory * this.mean + (1 - kMemory) * Math.min(seconds, 0.5);
    if (++this.since < kPatience) return false;
    const step = this.mean > kSlow ? 1 : this.mean < kFast ? -1 : 0;
    const level = Math.min(Math.max(this.level + step, 0), kLevels.length - 1);
    if (level === this.level) return false;
    this.level = level;
    this.since = step < 0 ? -4 * kPatience : 0; // coming back takes longer, so that it does not swing
    return true;
  }
}
