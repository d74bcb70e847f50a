// SPDX-License-Identifier: MIT
// Files and links that go out.
import type { Character, Facts, FormatFacts } from '../../../bindings/wasm/src/types';
import { studioField } from '../kept/in_result';
import { linkOf } from '../kept/link';
import { workOf } from '../kept/pack';
import { fetchPart } from '../offline/part';
import type { DrawnClip } from '../view/drawn_glb';
import { clipName } from './file_choices';
import { hasNeeded } from './formats';
import { candidateAt, type Document, withEdits } from './model';
import type { Studio } from './studio';
import { completeTask } from './task';

/** A format of the engine by its name, or one that the page itself makes. */
export type Taken = string;

/** Of any body: the page draws the GLB of one that has no mesh, and a picture of the strip. */
const kPageMakes = new Set(['glb', 'png']);
const kJsonType = 'application/json';

const formatOf = (studio: Studio, format: Taken): FormatFacts | undefined => studio.facts.formats.find(({ name }) => name === format);

const isFigure = (format: FormatFacts): boolean => format.media_type.startsWith('image/') || format.media_type === 'application/pdf';

/** What a motion can leave as: animations and tables, and figures. */
export function motionFormats({ formats }: Facts): { animations: Taken[]; figures: Taken[] } {
  const all = formats.filter(({ name, written }) => written || kPageMakes.has(name));
  const names = (figures: boolean): Taken[] => all.filter((format) => isFigure(format) === figures).map(({ name }) => name);
  return { animations: names(false), figures: names(true) };
}

/** Formats of which the character would have to be to leave in this one; none where it can. */
export function missingFiles(studio: Studio, format: Taken): readonly string[] {
  const facts = formatOf(studio, format);
  const character = studio.document?.character;
  if (!facts || !character || kPageMakes.has(format) || hasNeeded(studio.facts, facts, character)) return [];
  return facts.needs;
}

export function canTake(studio: Studio, format: Taken): boolean {
  const { document } = studio;
  if (!document) return false;
  if (format === 'task') return true;
  return document.result !== null && missingFiles(studio, format).length === 0;
}

export interface TakenFile {
  name: string;
  bytes: Uint8Array;
  type: string;
}

/** The character's name as it stands in names of files. */
export function bodyName(character: Character): string {
  return character.spec.source.replace(/\.[^.]*$/, '').replace(/[^\p{L}\p{N}_-]+/gu, '-');
}

export async function takeAway(studio: Studio, format: Taken): Promise<TakenFile> {
  const document = studio.document!;
  const body = bodyName(document.character);
  const encode = (value: unknown): Uint8Array => new TextEncoder().encode(`${JSON.stringify(value, null, 2)}\n`);
  if (format === 'task') {
    return { name: `shigusa-${body}-task.json`, bytes: encode(completeTask(studio.facts, document)), type: kJsonType };
  }
  if (format === 'result') return { name: `shigusa-${body}-result.json`, bytes: encode(await resultOf(studio)), type: kJsonType };
  const facts = formatOf(studio, format)!;
  const together = format === 'glb' && studio.store.state.files.together;
  const bytes = !facts.written || !hasNeeded(studio.facts, facts, document.character)
    ? await made(studio, document, format, together)
    : together ? await studio.exportedTogether() : await studio.exported(format);
  return { name: `shigusa-${body}-${together ? 'all' : document.chosen + 1}.${format}`, bytes, type: facts.media_type };
}

/** What the engine does not write of this character. */
async function made(studio: Studio, document: Document, format: Taken, together: boolean): Promise<Uint8Array> {
  if (format === 'png') return pngOf(await studio.exported('svg'));
  const { drawnGlb } = await fetchPart(() => import('../view/drawn_glb'));
  const { files } = studio.store.state;
  const motions = together ? document.result!.candidates.map((_, index) => index) : [document.chosen];
  const clips: DrawnClip[] = [];
  for (const index of motions) {
    clips.push({ name: clipName(files, index + 1), candidate: candidateAt(document, index)!, series: await studio.sampledNodes(index) });
  }
  const names = studio.facts.joint_names.find(({ name }) => name === files.jointNames)?.bones ?? {};
  return drawnGlb(document.character, clips, { names, inPlace: files.inPlace });
}

/** The result with edited motions in the place of those that were found, and with the page's work. */
async function resultOf(studio: Studio): Promise<unknown> {
  const document = studio.document!;
  const { summary } = document.result!;
  return { ...summary, candidates: withEdits(document), studio: studioField(await workOf(studio, document)) };
}

const kPngWidth = 1600; // px

/** A picture of a figure in SVG. */
export async function pngOf(svg: Uint8Array): Promise<Uint8Array> {
  const url = URL.createObjectURL(new Blob([svg as BlobPart], { type: 'image/svg+xml' }));
  try {
    const image = new Image();
    image.src = url;
    await image.decode();
    const canvas = globalThis.document.createElement('canvas');
    canvas.width = kPngWidth;
    canvas.height = Math.round((kPngWidth * image.naturalHeight) / image.naturalWidth);
    canvas.getContext('2d')!.drawImage(image, 0, 0, canvas.width, canvas.height);
    const blob = await new Promise<Blob | null>((done) => canvas.toBlob(done, 'image/png'));
    if (!blob) throw new Error('the picture could not be made');
    return new Uint8Array(await blob.arrayBuffer());
  } finally {
    URL.revokeObjectURL(url);
  }
}

export function save({ name, bytes, type }: TakenFile): void {
  const url = URL.createObjectURL(new Blob([bytes as BlobPart], { type }));
  const anchor = globalThis.document.createElement('a');
  anchor.href = url;
  anchor.download = name;
  anchor.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

/** Null where the work is too much for a link. */
export async function link(studio: Studio): Promise<string | null> {
  return linkOf(await workOf(studio, studio.document!), location.href);
}
