// SPDX-License-Identifier: MIT
// One value of the state, with subscribers to its changes.

export type Listener<S> = (state: S, previous: S) => void;

export class Store<S extends object> {
  private listeners = new Set<Listener<S>>();
  private value: S;

  constructor(initial: S) {
    this.value = initial;
  }

  get state(): Readonly<S> {
    return this.value;
  }

  set(patch: Partial<S>): void {
    const previous = this.value;
    const changed = (Object.keys(patch) as (keyof S)[]).some((key) => patch[key] !== previous[key]);
    if (!changed) return;
    this.value = { ...previous, ...patch };
    for (const listener of [...this.listeners]) listener(this.value, previous);
  }

  /** Returns a function that ends the subscription. */
  subscribe(listener: Listener<S>): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }
}
