// SPDX-License-Identifier: MIT
// A person's work as plain data: what was asked for, what was found and chosen of it, every edit, and how it was
// looked at. Links, files and the browser's storage hold it as JSON, which others may have changed: `readWork` checks
// all that the page itself reads of it, and the engine the rest.
import type { CharacterSpec, Message, Task, Vec3 } from '../../../bindings/wasm/src/types';
import type { CompareMode, Tab } from '../state/model';
import { type ViewSettings, wrongSetting } from '../state/view_settings';
import { fieldsOf, kFarthest, need } from './check';

/** From where the picture is seen. */
export interface Look {
  readonly position_m: Vec3;
  readonly target_m: Vec3;
}

/** Motions as their source data: the part of a result's JSON from which the engine restores them. */
export interface StoredMotions {
  readonly version: 1;
  readonly task: Task; // with its character as measured
  readonly candidates: readonly { readonly parameters: object }[];
}

export interface StoredEdit {
  readonly assignments: Readonly<Record<string, string>>;
  readonly base?: StoredMotions; // of one motion; absent if the edit is of a search's result
}

export interface StoredPicture {
  readonly look?: Look;
  readonly view?: Partial<ViewSettings>;
  readonly tab: Tab;
  readonly selected: string; // effector
  readonly compareMode: CompareMode;
  readonly overlays: boolean;
  readonly speed: number;
  readonly playing: boolean;
  readonly time_s: number;
  readonly fps: number; // of files that are saved
  readonly snap?: boolean;
  readonly symmetric?: boolean;
}

export interface Work {
  readonly version: 1;
  /** As it was opened; `sha256`: of its file, "" if the browser could not compute it. */
  readonly character: { readonly spec: CharacterSpec; readonly sha256?: string };
  readonly task: Task; // as it is asked for now
  readonly found?: StoredMotions;
  readonly conflict?: Message; // which goals are in one another's way
  readonly fewer?: Message; // why there are fewer motions than asked for
  readonly notes?: readonly Message[]; // on its goals
  readonly searching?: boolean; // the task was being searched
  readonly chosen: number; // index of the search's candidate
  readonly compared: number | null;
  readonly edits: Readonly<Record<string, StoredEdit>>; // by index
  readonly picture: StoredPicture;
}

const kDeepest = 16; // messages in messages
const kTabs: readonly Tab[] = ['goals', 'adjust', 'criteria', 'body', 'plots', 'take'];
const kModes: readonly CompareMode[] = ['beside', 'over'];

const isNumber = (value: unknown, low: number, high: number): value is number => typeof value === 'number' && value >= low && value <= high;
const isPoint = (value: unknown): value is Vec3 => Array.isArray(value) && value.length === 3 && value.every((x) => isNumber(x, -kFarthest, kFarthest));

/** Sentences have values, and these may be sentences again. */
function isMessage(value: unknown, depth = 0): value is Message {
  if (typeof value === 'string') return true;
  if (typeof value !== 'object' || value === null || depth > kDeepest) return false;
  const { text, key, values, number, unit } = value as Record<string, unknown>;
  if (typeof text !== 'string') return false;
  if (key === undefined) return typeof number === 'number' && (unit === undefined || typeof unit === 'string');
  return typeof key === 'string' && Array.isArray(values) && values.every((each) => isMessage(each, depth + 1));
}

function readMotions(value: unknown, place: string): StoredMotions {
  const { version, task, candidates } = fieldsOf(value, place);
  need(version === 1, `${place}.version`, '1');
  fieldsOf(task, `${place}.task`);
  need(Array.isArray(candidates) && candidates.length > 0, `${place}.candidates`, 'a list [ … ] that is not empty');
  for (const [index, candidate] of candidates.entries()) fieldsOf(candidate, `${place}.candidates[${index}]`);
  return value as StoredMotions;
}

function readEdits(value: unknown, count: number): Work['edits'] {
  const edits = fieldsOf(value, 'edits');
  for (const [index, edit] of Object.entries(edits)) {
    const place = `edits.${index.slice(0, 20)}`;
    need(/^\d+$/.test(index) && Number(index) < count, place, 'of a motion that was found');
    const { assignments, base } = fieldsOf(edit, place);
    const all = Object.values(fieldsOf(assignments, `${place}.assignments`));
    need(all.every((text) => typeof text === 'string'), `${place}.assignments`, 'texts by name');
    if (base !== undefined) readMotions(base, `${place}.base`);
  }
  return edits as Work['edits'];
}

function readPicture(value: unknown): StoredPicture {
  const picture = fieldsOf(value, 'picture');
  const { look, view, tab, selected, compareMode, overlays, speed, playing, time_s, fps, snap, symmetric } = picture;
  if (look !== undefined) {
    const { position_m, target_m } = fieldsOf(look, 'picture.look');
    need(isPoint(position_m) && isPoint(target_m), 'picture.look', `of points up to ${kFarthest} m away`);
  }
  if (view !== undefined) {
    const wrong = wrongSetting(fieldsOf(view, 'picture.view'));
    need(wrong === undefined, `picture.view.${wrong}`, 'as the View menu has it');
  }
  need(kTabs.includes(tab as Tab), 'picture.tab', `one of ${kTabs.join(', ')}`);
  need(typeof selected === 'string', 'picture.selected', 'the name of an effector');
  need(kModes.includes(compareMode as CompareMode), 'picture.compareMode', `one of ${kModes.join(', ')}`);
  need(typeof overlays === 'boolean' && typeof playing === 'boolean', 'picture.overlays and picture.playing', 'true or false');
  need([snap, symmetric].every((one) => one === undefined || typeof one === 'boolean'), 'picture.snap and picture.symmetric', 'true or false');
  need(isNumber(speed, 0.01, 100), 'picture.speed', 'a number from 0.01 to 100');
  need(isNumber(time_s, 0, Number.MAX_VALUE) && isNumber(fps, 1, 1000), 'picture.time_s and picture.fps', 'numbers');
  return value as StoredPicture;
}

/** The work that a JSON value is; a SyntaxError says why it is none. */
export function readWork(value: unknown): Work {
  const work = fieldsOf(value, 'the work');
  need(work['version'] === 1, 'version', '1');
  const { spec, sha256 } = fieldsOf(work['character'], 'character');
  need(typeof fieldsOf(spec, 'character.spec')['source'] === 'string', 'character.spec.source', 'a text');
  need(sha256 === undefined || sha256 === '' || (typeof sha256 === 'string' && /^[0-9a-f]{64}$/.test(sha256)), 'character.sha256', '64 hexadecimal digits');
  need(Array.isArray(fieldsOf(work['task'], 'task')['goals']), 'task.goals', 'a list [ … ]');
  const found = work['found'] === undefined ? undefined : readMotions(work['found'], 'found');
  const count = found?.candidates.length ?? 0;
  const { conflict, fewer, notes, searching, chosen, compared } = work;
  need(conflict === undefined || isMessage(conflict), 'conflict', 'a message');
  need(fewer === undefined || isMessage(fewer), 'fewer', 'a message');
  need(notes === undefined || (Array.isArray(notes) && notes.every((note) => isMessage(note))), 'notes', 'messages');
  need(searching === undefined || typeof searching === 'boolean', 'searching', 'true or false');
  const isIndex = (index: unknown): boolean => Number.isInteger(index) && isNumber(index, 0, Math.max(count - 1, 0));
  need(isIndex(chosen), 'chosen', 'of a motion that was found');
  need(compared === null || isIndex(compared), 'compared', 'of a motion that was found');
  readEdits(work['edits'], count);
  readPicture(work['picture']);
  return value as Work;
}
