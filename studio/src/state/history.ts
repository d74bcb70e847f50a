// SPDX-License-Identifier: MIT
// Undo and redo go over this list: earlier and later values, the newest last.

/** Results are large (about a megabyte), so old ones are let go. */
const kMostSteps = 60;

export class History<T> {
  private past: T[] = [];
  private future: T[] = [];
  private key: string | undefined;
  private undone: T[] = []; // the redo list before the last step

  constructor(private present: T) {}

  get value(): T {
    return this.present;
  }
  get canUndo(): boolean {
    return this.past.length > 0;
  }
  get canRedo(): boolean {
    return this.future.length > 0;
  }

  /** A step. Steps in a row that have the same key, as those of one slider's drag, are one. */
  push(value: T, key?: string): void {
    if (key === undefined || key !== this.key) {
      this.undone = this.future;
      this.past.push(this.present);
      if (this.past.length > kMostSteps) this.past.shift();
    }
    this.key = key;
    this.present = value;
    this.future = [];
  }

  /** Changes the present state without a step: a step's later outcome, such as a search's result. */
  amend(value: T): void {
    this.present = value;
  }

  /** The next step is one of its own, whatever its key. */
  endRun(): void {
    this.key = undefined;
  }

  undo(): T {
    const earlier = this.past.pop();
    if (earlier !== undefined) {
      this.future.push(this.present);
      this.present = earlier;
    }
    this.key = undefined;
    return this.present;
  }

  /** As if the last step, one with this key, had not been; false where it was another. */
  takeBack(key: string): boolean {
    if (key !== this.key || this.past.length === 0) return false;
    this.present = this.past.pop()!;
    this.future = this.undone;
    this.key = undefined;
    return true;
  }

  redo(): T {
    const later = this.future.pop();
    if (later !== undefined) {
      this.past.push(this.present);
      this.present = later;
    }
    this.key = undefined;
    return this.present;
  }

  /** Every value that can come back, and the present one. */
  all(): T[] {
    return [...this.past, this.present, ...this.future];
  }

  reset(value: T): void {
    this.past = [];
    this.future = [];
    this.key = undefined;
    this.present = value;
  }
}
