// SPDX-License-Identifier: MIT
// Files and links that come in: characters, results, tasks.
import type { CharacterSpec, Generated, Summary, Task } from '../../../bindings/wasm/src/types';
import { digestOf } from '../kept/digest';
import { workOfResult } from '../kept/in_result';
import { isLibrary, kMostLibraryBytes, readLibrary } from '../kept/library';
import { openWork } from '../kept/pack';
import { takeWanted } from '../kept/wanted';
import { plainBytes } from '../plain_gltf/packed';
import { characterFormat, characterFormats, endingOf, isBuiltIn } from './formats';
import type { Document, Notice } from './model';
import { checkedDocumentOf, documentOf } from './of_task';
import { newDocument } from './start';
import type { Studio } from './studio';
import { noticeOf } from './workbench';

const kJson = '.json';
const kMostJsonBytes = 200e6;
const kOfTheFile = new Set(['source', 'frame', 'animation', 'seat_m', 'heels', 'map']);

const isJson = ({ name }: File): boolean => endingOf(name) === kJson;

/** Opens what was dropped or picked: a result or a task with the files that it names; of characters the first is shown, and the
 *  others stand on the shelf. What becomes of each is told; what cannot be opened changes nothing. */
export async function openFiles(studio: Studio, files: readonly File[]): Promise<void> {
  studio.tell(null);
  const wanted = await takeWanted(studio, files);
  const json = wanted ? undefined : (files.find(({ name }) => name === 'summary.json') ?? files.find(isJson));
  const others = files.filter((file) => file !== wanted && file !== json);
  if (!json) return openCharacters(studio, others, wanted !== null);
  const text = json.size > kMostJsonBytes ? '' : await json.text();
  const refused = await tried(studio, json, kMostJsonBytes, () => openJson(studio, json.name, text, others));
  if (refused) studio.tellToo(refused);
  await openCharacters(studio, others.filter(({ name }) => !text.includes(JSON.stringify(name))), refused === null);
}

/** `isShown`: something else of what came is, already. */
async function openCharacters(studio: Studio, files: readonly File[], isShown: boolean): Promise<void> {
  const refused: Notice[] = [];
  const kept: string[] = [];
  let shown = isShown;
  for (const file of files) {
    const { facts } = studio;
    const most = characterFormat(facts, file.name)?.max_bytes;
    const take = shown ? shelve : show;
    const refusal: Notice | null = isJson(file) ? { kind: 'text', key: 'oneAtATime', values: { name: file.name } }
      : most === undefined ? { kind: 'text', key: 'unknownFile', values: { name: file.name, formats: characterFormats(facts) } }
      : await tried(studio, file, most, async () => take(studio, { source: file.name }, await plainBytes(file, most)));
    if (refusal) refused.push(refusal);
    else if (shown) kept.push(file.name);
    shown ||= !refusal;
  }
  if (kept.length > 0) {
    studio.store.set({ tab: 'body' }); // where they are
    studio.tellToo({ kind: 'text', key: 'alsoKept', values: { names: kept.join(', ') } });
  }
  for (const refusal of refused) studio.tellToo(refusal);
}

/** Opens a file; returns the reason if it cannot. */
async function tried(studio: Studio, { name, size }: File, most: number, open: () => Promise<Notice | null>): Promise<Notice | null> {
  if (size > most) return { kind: 'text', key: 'tooLarge', values: { name, most: Math.floor(most / 1e6) } };
  studio.store.set({ opening: name });
  try {
    return await open();
  } catch (error) {
    return noticeOf(error, name);
  } finally {
    studio.store.set({ opening: null });
  }
}

async function show(studio: Studio, spec: CharacterSpec, bytes: Uint8Array): Promise<null> {
  await openCharacter(studio, spec, bytes);
  return null;
}

/** Adds a character to the list without changing the present one; returns the reason if it cannot. */
async function shelve(studio: Studio, spec: CharacterSpec, bytes: Uint8Array): Promise<Notice | null> {
  const character = await studio.open(spec, bytes);
  return studio.shelve(newDocument(studio.facts, character)) ? null : { kind: 'text', key: 'noRoom', values: { name: spec.source } };
}

export async function openCharacter(studio: Studio, spec: CharacterSpec, bytes?: Uint8Array): Promise<void> {
  const character = await studio.open(spec, bytes);
  const old = studio.document;
  const fresh = newDocument(studio.facts, character);
  // of the same body in another size or map, goals stay
  const same = old !== null && old.character.spec.source === spec.source && old.character.bytes === bytes;
  const document: Document = same ? { ...fresh, goals: old.goals, weights: old.weights, settings: old.settings } : fresh;
  if (!same && character.description.stature_guessed === true) studio.store.set({ tab: 'body' }); // where it is asked for
  void studio.begin(document).catch((error: unknown) => studio.fail(error));
}

async function openJson(studio: Studio, name: string, text: string, beside: readonly File[]): Promise<Notice | null> {
  const value: unknown = JSON.parse(text);
  if (typeof value !== 'object' || value === null) throw new SyntaxError('no result and no task');
  if (isLibrary(value)) {
    if (text.length > kMostLibraryBytes) return { kind: 'text', key: 'tooLarge', values: { name, most: kMostLibraryBytes / 1e6 } };
    const entries = readLibrary(text);
    await studio.library.add(entries);
    studio.store.set({ tab: 'goals' }); // where it is
    studio.tell({ kind: 'text', key: 'importedLibrary', values: { n: entries.length } });
  } else if (Array.isArray((value as Summary).candidates)) {
    const changed = await changedFile(value as Summary, beside);
    if (changed !== undefined) return { kind: 'text', key: 'changedFile', values: { name: changed } };
    await openResult(studio, value as Summary, beside);
  } else if (Array.isArray((value as Task).goals)) await openTask(studio, value);
  else throw new SyntaxError('neither a result ("candidates") nor a task ("goals")');
  return null;
}

/** The name of a file that came with a result and is not the one that it describes. */
async function changedFile(summary: Summary, beside: readonly File[]): Promise<string | undefined> {
  for (const { files, sha256 } of summary.candidates) {
    for (const [format, name] of Object.entries(files ?? {})) {
      const file = beside.find((other) => other.name === name);
      const told = sha256?.[format];
      if (file === undefined || told === undefined) continue;
      const digest = await digestOf(new Uint8Array(await file.arrayBuffer()));
      if (digest !== '' && digest !== told) return name;
    }
  }
  return undefined;
}

export async function openResult(studio: Studio, summary: Summary, beside: readonly File[] = []): Promise<void> {
  const work = workOfResult(summary);
  if (work) return openWork(studio, work, beside);
  const task = summary['task'] as Task;
  const character = (await characterBeside(studio, task.character, beside)) ?? (await characterOf(studio, task.character));
  const result: Generated = await studio.restore(character, summary);
  await studio.begin({ ...documentOf(studio.facts, character, task), result });
}

export async function openTask(studio: Studio, task: Task): Promise<void> {
  const character = await characterOf(studio, task.character);
  // a search reports its own outcome
  void studio.begin(await checkedDocumentOf(studio, character, task));
}

/** The character of a result by its own file, where that came with it. */
async function characterBeside(
  studio: Studio, named: CharacterSpec | string | undefined, beside: readonly File[],
): Promise<Document['character'] | undefined> {
  if (typeof named !== 'object') return undefined;
  const format = characterFormat(studio.facts, named.source);
  const file = beside.find(({ name }) => name === named.source);
  if (file === undefined || format === undefined) return undefined;
  // as it was read then; what was measured of it is in the file
  const said = Object.entries(named).filter(([key]) => kOfTheFile.has(key));
  return studio.open(Object.fromEntries(said) as unknown as CharacterSpec, await plainBytes(file, format.max_bytes));
}

/** The character of a task: the one at hand where it is of the same file, as that has its mesh. */
async function characterOf(studio: Studio, named: CharacterSpec | string | undefined): Promise<Document['character']> {
  const spec: CharacterSpec = typeof named === 'string' ? { source: named } : (named ?? { source: studio.facts.default_body });
  const now = studio.document?.character;
  if (now?.bytes && now.spec.source === spec.source) return now;
  if (now && JSON.stringify(now.spec) === JSON.stringify(spec) && isBuiltIn(studio.facts, spec)) return now;
  return studio.open(spec);
}
