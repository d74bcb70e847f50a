// SPDX-License-Identifier: MIT
// The page's state. A document is the unit of undo; it is never changed, only replaced. A session is
// the rest: what is shown and what is going on.
import type { Candidate, Character, EngineFailure, Generated, Goal, PresetName, Summary, Task } from '../../../bindings/wasm/src/types';
import type { LengthUnit } from '../i18n/lengths';
import type { NoticeKey } from '../i18n/notice_tones';
import type { Work } from '../kept/work';
import { initialView, type ViewSettings } from './view_settings';

/** What a person changed of a candidate, and the motion that came of it. */
export interface Edit {
  readonly base: { readonly summary: Summary; readonly candidate: number }; // the result that the assignments change
  readonly assignments: Readonly<Record<string, string>>; // by parameter; "name.locked" for locks
  readonly generated: Generated; // of one candidate
}

/** What is asked of the search beside the goals. */
export interface SearchSettings {
  readonly preset: PresetName;
  readonly seed: number;
  readonly evaluations: number | null; // null: the preset's own
  readonly duration_s: number | null; // null: from the distance
  readonly more: Readonly<Partial<Task>>; // the task's other fields, such as obstacles; kept unchanged
}

export interface Document {
  readonly character: Character;
  readonly goals: readonly Goal[];
  readonly weights: Readonly<Record<string, number>>; // of the criteria
  readonly fixed: readonly string[]; // assignments that the search keeps
  readonly settings: SearchSettings;
  readonly result: Generated | null;
  readonly chosen: number; // index in result.candidates
  readonly compared: number | null; // index of the one beside it
  readonly edits: Readonly<Record<number, Edit>>; // by index
}

export type Notice =
  | { kind: 'failure'; failure: EngineFailure; about?: string }
  | { kind: 'text'; key: NoticeKey; values?: Record<string, string | number> }
  | { kind: 'several'; of: readonly Notice[] };

/** A character whose shown figure is not the computed one. */
export interface Undrawn {
  readonly character: Character;
  readonly apart_m: number | null; // how far a hand is drawn from its place; null: another figure stands in for the mesh
}

/** A work whose character's file is not at hand. */
export interface Wanted {
  readonly work: Work;
  readonly character: Character | null; // as measured, in place of the file's; null: such a one is not known either
}

/** none: nothing to keep yet; incomplete: without the character's file; off: the browser keeps nothing. */
export type Saving = 'none' | 'unsaved' | 'saved' | 'incomplete' | 'off' | 'failed';

/** Whether the page works without the network; newer: and a newer one waits. */
export type Offline = 'no' | 'ready' | 'newer';

export type Tab = 'goals' | 'adjust' | 'criteria' | 'body' | 'plots' | 'take';
export type CompareMode = 'beside' | 'over';

/** How motions leave in files, beside their frames a second. */
export interface FileChoices {
  readonly clip: string; // name of the animations; empty: the engine's
  readonly jointNames: string; // of built-in bodies
  readonly inPlace: boolean; // without the hips' travel along the floor
  readonly together: boolean; // all motions in one GLB
}

export interface State {
  readonly document: Document | null;
  readonly shelf: readonly Document[]; // of each character that was opened the last one
  readonly canUndo: boolean;
  readonly canRedo: boolean;
  /** What a drag's quick search found; shown in place of the candidate while it lasts. */
  readonly preview: Candidate | null;
  readonly previewRemaining_mm: number;
  /** The document as it would be where a drag ended now; shown in place of the document's goals and things. */
  readonly trial: Document | null;
  readonly dragging: boolean;
  readonly search: { fraction: number; best: number } | null;
  readonly opening: string | null; // a file's name
  readonly wanted: Wanted | null;
  readonly undrawn: Undrawn | null;
  readonly pictureLost: boolean; // the graphics card has let go of the page
  readonly project: string; // its name
  readonly saving: Saving;
  readonly offline: Offline;
  readonly notice: Notice | null;
  readonly symmetric: boolean; // hands' goals move alike
  readonly rings: boolean; // rings that turn the selected object, instead of arrows that move it
  readonly snap: boolean; // places that are dragged snap to the floor, things, the other hand
  readonly selected: string; // effector, or a thing in the way
  readonly start: boolean; // the cards to begin with
  readonly hint: boolean; // whether the first hint about dragging is shown
  readonly playing: boolean;
  readonly loop: boolean;
  readonly speed: number;
  readonly tab: Tab;
  readonly compareMode: CompareMode;
  readonly overlays: boolean; // paths, centre of mass, support
  readonly view: ViewSettings;
  readonly fps: number; // of files that are saved
  readonly files: FileChoices;
  readonly lengths: LengthUnit; // that they are shown and typed in
  readonly language: 'en' | 'ja';
  readonly theme: 'auto' | 'light' | 'dark';
}

export const initialState: State = {
  document: null,
  shelf: [],
  canUndo: false,
  canRedo: false,
  preview: null,
  previewRemaining_mm: 0,
  trial: null,
  dragging: false,
  search: null,
  opening: null,
  wanted: null,
  undrawn: null,
  pictureLost: false,
  project: '',
  saving: 'none',
  offline: 'no',
  notice: null,
  symmetric: false,
  rings: false,
  snap: false,
  selected: 'right_hand',
  start: false,
  hint: true,
  playing: true,
  loop: true,
  speed: 1,
  tab: 'goals',
  compareMode: 'beside',
  overlays: true,
  view: initialView,
  fps: 60,
  files: { clip: '', jointNames: 'own', inPlace: false, together: false },
  lengths: 'cm',
  language: 'en',
  theme: 'auto',
};

/** The candidate of an index, with the user's changes. */
export function candidateAt(document: Document, index: number): Candidate | null {
  return document.edits[index]?.generated.candidates[0] ?? document.result?.candidates[index] ?? null;
}

/** The candidates of the result, edited ones in the place of those that were found. */
export function withEdits({ result, edits }: Document): Summary['candidates'] {
  const all = [...(result?.summary.candidates ?? [])];
  for (const [index, { generated }] of Object.entries(edits)) {
    const edited = generated.summary.candidates[0];
    if (edited) all[Number(index)] = { ...edited, rank: Number(index) + 1 };
  }
  return all;
}

export function chosenCandidate(document: Document | null): Candidate | null {
  return document === null ? null : candidateAt(document, document.chosen);
}

export function goalOf(document: Document, effector: string): Goal | undefined {
  return document.goals.find((goal) => goal.effector === effector);
}
