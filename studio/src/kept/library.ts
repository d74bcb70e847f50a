// SPDX-License-Identifier: MIT
// Goals and start postures that a person keeps under a name, to be used in any project: in the browser's database, and as JSON to
// be carried elsewhere. Others may have written a file that comes in: `readLibrary` checks all that the page itself reads.
import type { CharacterSpec, Goal, Obstacle } from '../../../bindings/wasm/src/types';
import { fieldsOf, kFarthest, need } from './check';
import { answer, completed, openDatabase } from './database';
import { freshId } from './projects';

/** The part of a character's spec that determines the body before its motion. */
export type StartPosture = Pick<CharacterSpec, 'source' | 'animation' | 'frame' | 'seat_m' | 'heels'>;

interface Named {
  readonly id: string;
  readonly name: string;
  readonly changed_ms: number; // since 1970
  readonly picture?: string; // data URL
}

export type Entry = Named & ({ readonly kind: 'goals'; readonly goals: readonly Goal[]; readonly things: readonly Obstacle[] } | { readonly kind: 'start'; readonly start: StartPosture });

export type NewEntry = Entry extends infer E ? E extends Entry ? Omit<E, 'id' | 'changed_ms'> : never : never;

export const kMostLibraryBytes = 8e6;
const kMostEntries = 200;
const kLongestName = 80;
const kLongestPicture = 60_000; // letters
const kMostGoals = 40;
const kMostThings = 100;

function listOf(value: unknown, place: string, least: number, most: number): unknown[] {
  need(Array.isArray(value) && value.length >= least && value.length <= most, place, `a list of ${least} to ${most}`);
  return value;
}

function needNumbers(value: unknown, count: number, place: string): void {
  const isOne = (x: unknown): boolean => typeof x === 'number' && Math.abs(x) <= kFarthest;
  need(Array.isArray(value) && value.length === count && value.every(isOne), place, `${count} numbers from -${kFarthest} to ${kFarthest}`);
}

function needText(value: unknown, longest: number, place: string): asserts value is string {
  need(typeof value === 'string' && value.trim() !== '' && value.length <= longest, place, `a text of up to ${longest} letters`);
}

function readGoals(value: unknown, place: string): readonly Goal[] {
  const goals = listOf(value, place, 1, kMostGoals);
  const effectors = goals.map((goal, k) => {
    const { effector, position_m, rotation_xyzw } = fieldsOf(goal, `${place}[${k}]`);
    needText(effector, kLongestName, `${place}[${k}].effector`);
    needNumbers(position_m, 3, `${place}[${k}].position_m`);
    if (rotation_xyzw !== undefined) needNumbers(rotation_xyzw, 4, `${place}[${k}].rotation_xyzw`);
    return effector;
  });
  need(new Set(effectors).size === goals.length, place, 'of one goal for each effector');
  return goals as Goal[];
}

function readThings(value: unknown, place: string): readonly Obstacle[] {
  const things = listOf(value, place, 0, kMostThings);
  things.forEach((thing, k) => {
    const { name, position_m, size_m, radius_m, rotation_xyzw } = fieldsOf(thing, `${place}[${k}]`);
    if (name !== undefined) needText(name, kLongestName, `${place}[${k}].name`);
    needNumbers(position_m, 3, `${place}[${k}].position_m`);
    if (size_m !== undefined) needNumbers(size_m, 3, `${place}[${k}].size_m`);
    if (radius_m !== undefined) needNumbers([radius_m], 1, `${place}[${k}].radius_m`);
    if (rotation_xyzw !== undefined) needNumbers(rotation_xyzw, 4, `${place}[${k}].rotation_xyzw`);
  });
  return things as Obstacle[];
}

function readStart(value: unknown, place: string): StartPosture {
  const { source, animation, frame, seat_m, heels } = fieldsOf(value, place);
  needText(source, 1000, `${place}.source`);
  if (animation !== undefined) needText(animation, 1000, `${place}.animation`);
  need(frame === undefined || frame === 'rest' || (Number.isInteger(frame) && (frame as number) >= 0), `${place}.frame`, 'a whole number or "rest"');
  need(seat_m === undefined || (typeof seat_m === 'number' && seat_m > 0 && seat_m < 10), `${place}.seat_m`, 'a height in metres');
  need(heels === undefined || typeof heels === 'boolean', `${place}.heels`, 'true or false');
  return { source, animation, frame, seat_m, heels } as StartPosture;
}

function readEntry(value: unknown, place: string): NewEntry {
  const { name, kind, picture, goals, things, start } = fieldsOf(value, place);
  needText(name, kLongestName, `${place}.name`);
  const isPicture = typeof picture === 'string' && picture.length <= kLongestPicture && /^data:image\/(png|jpeg);base64,[\w+/=]+$/.test(picture);
  need(picture === undefined || isPicture, `${place}.picture`, 'a small PNG or JPEG as a data URL');
  const named = { name, ...(isPicture && { picture }) };
  if (kind === 'goals') return { ...named, kind, goals: readGoals(goals, `${place}.goals`), things: readThings(things ?? [], `${place}.things`) };
  need(kind === 'start', `${place}.kind`, '"goals" or "start"');
  return { ...named, kind, start: readStart(start, `${place}.start`) };
}

/** What a library's JSON has; a SyntaxError says why it is none. */
export function readLibrary(text: string): NewEntry[] {
  const { shigusa_library, entries } = fieldsOf(JSON.parse(text), 'the file');
  need(shigusa_library === 1, 'shigusa_library', '1');
  return listOf(entries, 'entries', 1, kMostEntries).map((entry, k) => readEntry(entry, `entries[${k}]`));
}

/** Whether a JSON value is a library's, well or damaged. */
export const isLibrary = (value: object): boolean => 'shigusa_library' in value;

export function libraryText(entries: readonly Entry[]): string {
  return `${JSON.stringify({ shigusa_library: 1, entries: entries.map(({ id: _, changed_ms: __, ...entry }) => entry) }, null, 1)}\n`;
}

/** Where the browser keeps nothing, entries last as long as the page. */
export class Library {
  private readonly database = openDatabase();
  private entries: Entry[] | null = null;
  private readonly listeners = new Set<() => void>();

  /** Subscribes to changes; returns the function that unsubscribes. */
  subscribe(listener: () => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  private tell(): void {
    for (const listener of this.listeners) listener();
  }

  /** The newest one first. */
  async list(): Promise<readonly Entry[]> {
    const store = (await this.database)?.transaction('poses').objectStore('poses');
    if (store) this.entries = await answer<Entry[]>(store.getAll());
    this.entries ??= [];
    return this.entries.sort((a, b) => b.changed_ms - a.changed_ms || a.name.localeCompare(b.name));
  }

  /** Keeps new entries, or others in the place of those of the same id. */
  async put(entries: readonly Entry[]): Promise<void> {
    const ids = new Set(entries.map(({ id }) => id));
    this.entries = [...(this.entries ?? []).filter(({ id }) => !ids.has(id)), ...entries];
    await this.write((store) => {
      for (const entry of entries) store.put(entry);
    });
  }

  add(entries: readonly NewEntry[]): Promise<void> {
    const now = Date.now();
    return this.put(entries.map((entry) => ({ ...entry, id: freshId(), changed_ms: now })));
  }

  async remove(id: string): Promise<void> {
    this.entries = (this.entries ?? []).filter((entry) => entry.id !== id);
    await this.write((store) => store.delete(id));
  }

  private async write(change: (store: IDBObjectStore) => void): Promise<void> {
    const transaction = (await this.database)?.transaction('poses', 'readwrite');
    if (transaction) {
      const end = completed(transaction);
      change(transaction.objectStore('poses'));
      await end;
    }
    this.tell();
  }
}
