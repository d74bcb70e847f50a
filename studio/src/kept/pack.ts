// SPDX-License-Identifier: MIT
// Turns the document on the table into a work, and a work into the document again.
import type { Character, CharacterSpec, Generated, Summary } from '../../../bindings/wasm/src/types';
import { plainBytes } from '../plain_gltf/packed';
import { characterFormat, isBuiltIn } from '../state/formats';
import type { Document, Edit } from '../state/model';
import { checkedDocumentOf } from '../state/of_task';
import { placeOf } from '../state/places';
import type { Studio } from '../state/studio';
import { taskOf } from '../state/task';
import { initialView } from '../state/view_settings';
import { digestOf, knownDigest } from './digest';
import type { StoredEdit, StoredMotions, Work } from './work';

/** Other calls of the page may take the place of a replay that waits. */
const kTries = 20;

function storedMotions({ task, candidates }: Summary): StoredMotions {
  const parameters = candidates.map((candidate) => ({ parameters: candidate['parameters'] as object }));
  return { version: 1, task: task as StoredMotions['task'], candidates: parameters };
}

function storedEdit({ base, assignments }: Edit, found: Summary): StoredEdit {
  if (base.summary === found) return { assignments };
  const { task, candidates } = storedMotions(base.summary);
  return { assignments, base: { version: 1, task, candidates: candidates.slice(base.candidate - 1, base.candidate) } };
}

/** The document as a work, with the picture of it. */
export async function workOf(studio: Studio, document: Document): Promise<Work> {
  if (document.character.bytes) await digestOf(document.character.bytes);
  return workNow(studio, document)!;
}

/** The same at once; null where that would take too long. */
export function workNow(studio: Studio, document: Document): Work | null {
  const { spec, bytes } = document.character;
  const { state } = studio.store;
  const sha256 = bytes && knownDigest(bytes);
  if (bytes && sha256 === undefined) return null;
  const look = studio.eye?.look() ?? studio.firstLook;
  const summary = document.result?.summary;
  const edits = summary ? Object.entries(document.edits).map(([index, edit]) => [index, storedEdit(edit, summary)] as const) : [];
  return {
    version: 1,
    character: state.wanted?.character === document.character ? state.wanted.work.character
      : { spec, ...(sha256 !== undefined && { sha256 }) },
    task: taskOf(studio.facts, document),
    ...(summary && { found: storedMotions(summary) }),
    ...(summary?.fewer_message !== undefined && { fewer: summary.fewer_message }),
    ...(summary?.conflict_message !== undefined && { conflict: summary.conflict_message }),
    ...(summary?.goal_note_messages !== undefined && { notes: summary.goal_note_messages }),
    ...(state.search && { searching: true }),
    chosen: document.chosen,
    compared: document.compared,
    edits: Object.fromEntries(edits),
    picture: {
      ...(look && { look }),
      view: state.view, tab: state.tab, selected: state.selected, compareMode: state.compareMode, overlays: state.overlays,
      speed: state.speed, playing: state.playing, time_s: studio.clock.time, fps: state.fps,
      snap: state.snap, symmetric: state.symmetric,
    },
  };
}

/** Puts a work on the table. `files`: those that came with it, of which one may be its character's. */
export async function openWork(studio: Studio, work: Work, files: readonly File[] = []): Promise<void> {
  const own = await characterOf(studio, work, files);
  if (!own && !isMeasured(work)) return studio.store.set({ wanted: { work, character: null } });
  const character = own ?? (await studio.open(work.found!.task.character as CharacterSpec));
  const asked = await askedFor(studio, character, work);
  const result = work.found ? await restored(studio, character, work.found, work) : null;
  const edits: Record<number, Edit> = {};
  if (result) {
    for (const [index, edit] of Object.entries(work.edits)) edits[Number(index)] = await editOf(studio, character, edit, result, Number(index));
  }
  const { chosen, compared, picture } = work;
  // a search reports its own outcome
  void studio.begin({ ...asked, result, edits, chosen, compared: compared === chosen ? null : compared });
  show(studio, picture);
  studio.store.set({ wanted: own ? null : { work, character } });
  // a search that had not come to its end begins anew
  if (result && work.searching) void studio.search();
}

/** The work's own task; where the engine refuses that, the one that its motions were found for. */
async function askedFor(studio: Studio, character: Character, { task, found }: Work): Promise<Document> {
  if (!found) return checkedDocumentOf(studio, character, task);
  return checkedDocumentOf(studio, character, task).catch(() => checkedDocumentOf(studio, character, found.task));
}

async function restored(studio: Studio, character: Character, motions: StoredMotions, told: Pick<Work, 'conflict' | 'fewer' | 'notes'> = {}): Promise<Generated> {
  const generated = await studio.restore(character, motions as unknown as Summary);
  const { conflict, fewer, notes } = told;
  return { ...generated, summary: {
    ...generated.summary, ...(conflict !== undefined && { conflict_message: conflict }), ...(fewer !== undefined && { fewer_message: fewer }), ...(notes !== undefined && { goal_note_messages: [...notes] }),
  } };
}

async function editOf(studio: Studio, character: Character, { assignments, base }: StoredEdit, found: Generated, index: number): Promise<Edit> {
  const start = base ? await restored(studio, character, base) : found;
  const from = { summary: start.summary, candidate: base ? 1 : index + 1 };
  const list = Object.entries(assignments).map(([name, value]) => `${name}=${value}`);
  if (base && list.length === 0) return { base: from, assignments, generated: start };
  for (let tries = 0; tries < kTries; ++tries) {
    const generated = await studio.engine.replay(character, from.summary, from.candidate, list);
    if (generated) return { base: from, assignments, generated };
  }
  throw new Error('the edits could not be played, as others were');
}

function show(studio: Studio, { look, view, tab, selected, compareMode, overlays, speed, playing, time_s, fps, snap = false, symmetric = false }: Work['picture']): void {
  const known = studio.document && placeOf(studio.document, selected) !== undefined;
  studio.store.set({ view: { ...initialView, ...view }, tab, compareMode, overlays, speed, playing: playing && !studio.calm, fps, snap, symmetric, ...(known && { selected }) });
  studio.clock.time = time_s;
  if (!look) return;
  if (studio.eye) studio.eye.lookFrom(look);
  else studio.firstLook = look;
}

/** Whether the person can stand there without their file. */
function isMeasured({ found }: Work): boolean {
  const character = found?.task.character;
  return typeof character === 'object' && (character.landmarks_m !== undefined || character.urdf !== undefined);
}

/** A work's character; null where its file is not at hand. */
async function characterOf(studio: Studio, { character: { spec, sha256 } }: Work, files: readonly File[]): Promise<Character | null> {
  const now = studio.document?.character;
  if (sha256 === undefined) {
    const same = now && !now.bytes && isBuiltIn(studio.facts, spec) && JSON.stringify(now.spec) === JSON.stringify(spec);
    return same ? now : studio.open(spec);
  }
  const isIt = async (name: string, bytes: Uint8Array): Promise<boolean> => (sha256 === '' ? name === spec.source : (await digestOf(bytes)) === sha256);
  if (now?.bytes && await isIt(now.spec.source, now.bytes)) {
    return JSON.stringify(now.spec) === JSON.stringify(spec) ? now : studio.open(spec, now.bytes);
  }
  for (const file of files) {
    const bytes = await plainBytes(file, characterFormat(studio.facts, file.name)?.max_bytes ?? 0);
    if (await isIt(file.name, bytes) || await isIt(file.name, new Uint8Array(await file.arrayBuffer()))) return studio.open(spec, bytes);
  }
  return null;
}
