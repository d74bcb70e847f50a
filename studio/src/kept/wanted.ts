// SPDX-License-Identifier: MIT
// The file of a work's character, where the work came without it. As measured, the person moves without the file;
// their own skeleton and mesh come with it.
import { plainBytes } from '../plain_gltf/packed';
import { characterFormat } from '../state/formats';
import type { State, Wanted } from '../state/model';
import type { Studio } from '../state/studio';
import { digestOf } from './digest';
import { openWork, workOf } from './pack';
import type { Work } from './work';

/** The missing file of the open document. */
export function wantedNow({ wanted, document }: State): Wanted | null {
  return wanted && (wanted.character === null || wanted.character === document?.character) ? wanted : null;
}

async function isWanted({ character: { spec, sha256 } }: Work, file: File, most: number): Promise<boolean> {
  if (!sha256) return file.name === spec.source;
  const digests = [await digestOf(new Uint8Array(await file.arrayBuffer())), await digestOf(await plainBytes(file, most))];
  return digests.includes(sha256);
}

/** Brings in the file that is wanted, and returns it; null where it is not among these. */
export async function takeWanted(studio: Studio, files: readonly File[]): Promise<File | null> {
  const wanted = wantedNow(studio.store.state);
  if (!wanted) return null;
  for (const file of files) {
    const format = characterFormat(studio.facts, file.name);
    if (!format || file.size > format.max_bytes || !(await isWanted(wanted.work, file, format.max_bytes).catch(() => false))) continue;
    studio.store.set({ opening: file.name, notice: null });
    try {
      const { document } = studio;
      const work = document && wanted.character ? await workOf(studio, document) : wanted.work;
      await openWork(studio, work, [file]);
    } catch (error) {
      studio.fail(error, file.name);
    } finally {
      studio.store.set({ opening: null });
    }
    return file;
  }
  return null;
}
