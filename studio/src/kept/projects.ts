// SPDX-License-Identifier: MIT
// Projects in the browser's database: names beside the works, and the files of their characters once each.
import { answer, completed, type StoreName } from './database';
import type { Work } from './work';

export interface Project {
  readonly id: string;
  readonly name: string;
  readonly revision: number; // 0: not kept yet
  readonly changed_ms: number; // since 1970
  readonly sha256?: string; // of the character's file
}

export interface KeptFile {
  readonly sha256: string;
  readonly bytes: Uint8Array;
}

/** Somebody else has saved the project meanwhile. */
export class Conflict extends Error {}

export function freshProject(name: string): Project {
  const digits = [...crypto.getRandomValues(new Uint8Array(12))].map((byte) => byte.toString(16).padStart(2, '0'));
  return { id: digits.join(''), name, revision: 0, changed_ms: Date.now() };
}

export class ProjectStore {
  constructor(private readonly database: IDBDatabase) {}

  private begin(mode: IDBTransactionMode, ...stores: StoreName[]): { transaction: IDBTransaction; of: (name: StoreName) => IDBObjectStore } {
    const transaction = this.database.transaction(stores, mode);
    return { transaction, of: (name) => transaction.objectStore(name) };
  }

  /** A project and its work, which is to be read with care; null where there is none. */
  async load(id: string): Promise<{ project: Project; work: unknown; bytes?: Uint8Array } | null> {
    const { of } = this.begin('readonly', 'projects', 'works', 'files');
    const project = await answer<Project | undefined>(of('projects').get(id));
    const kept = await answer<{ work: unknown } | undefined>(of('works').get(id));
    if (!project || !kept) return null;
    const file = project.sha256 ? await answer<KeptFile | undefined>(of('files').get(project.sha256)) : undefined;
    return { project, work: kept.work, ...(file?.bytes instanceof Uint8Array && { bytes: file.bytes }) };
  }

  /** 0 of one that is not kept. */
  async revision(id: string): Promise<number> {
    const { of } = this.begin('readonly', 'projects');
    return (await answer<Project | undefined>(of('projects').get(id)))?.revision ?? 0;
  }

  /** Keeps all of it or nothing, as the project's next revision. Throws a Conflict where what is kept is not at the
   *  project's own. `last`: the page is about to end and waits for no answer, so nothing is asked. */
  async save(project: Project, work: Work, file?: KeptFile, last = false): Promise<void> {
    const { sha256 } = work.character;
    const { transaction, of } = this.begin('readwrite', 'projects', 'works', 'files');
    const end = completed(transaction);
    const next: Project = { ...project, revision: project.revision + 1, changed_ms: Date.now(), sha256 };
    try {
      if (!last && ((await answer<Project | undefined>(of('projects').get(project.id)))?.revision ?? 0) !== project.revision) {
        throw new Conflict(`${project.id} was saved elsewhere`);
      }
      of('projects').put(next);
      of('works').put({ id: project.id, work });
      if (file) of('files').put(file);
      if (last) transaction.commit();
    } catch (error) {
      end.catch(() => undefined);
      transaction.abort();
      throw error;
    }
    await end;
  }
}
