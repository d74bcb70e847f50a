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
  readonly picture?: string; // the chosen motion, small, as a data URL
}

export interface KeptFile {
  readonly sha256: string;
  readonly bytes: Uint8Array;
}

/** A project that was deleted, with all that brings it back. */
export interface Removed {
  readonly project: Project;
  readonly work: unknown;
  readonly files: readonly KeptFile[]; // its character's, where no other project uses it
  readonly bytes: number; // of those
}

/** Somebody else has saved the project meanwhile. */
export class Conflict extends Error {}

export function freshId(): string {
  return [...crypto.getRandomValues(new Uint8Array(12))].map((byte) => byte.toString(16).padStart(2, '0')).join('');
}

export function freshProject(name: string): Project {
  return { id: freshId(), name, revision: 0, changed_ms: Date.now() };
}

export class ProjectStore {
  constructor(private readonly database: IDBDatabase) {}

  private begin(mode: IDBTransactionMode, ...stores: StoreName[]): { transaction: IDBTransaction; of: (name: StoreName) => IDBObjectStore } {
    const transaction = this.database.transaction(stores, mode);
    return { transaction, of: (name) => transaction.objectStore(name) };
  }

  /** A project and its work, which must be validated; null if there is none. */
  async load(id: string): Promise<{ project: Project; work: unknown } | null> {
    const { of } = this.begin('readonly', 'projects', 'works');
    const project = await answer<Project | undefined>(of('projects').get(id));
    const kept = await answer<{ work: unknown } | undefined>(of('works').get(id));
    return project && kept ? { project, work: kept.work } : null;
  }

  async file(sha256: string): Promise<Uint8Array | undefined> {
    const { of } = this.begin('readonly', 'files');
    const file = await answer<KeptFile | undefined>(of('files').get(sha256));
    return file?.bytes instanceof Uint8Array ? file.bytes : undefined;
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
      if (file && (last || (await answer(of('files').count(file.sha256))) === 0)) of('files').put(file);
      if (last) transaction.commit();
    } catch (error) {
      end.catch(() => undefined);
      transaction.abort();
      throw error;
    }
    await end;
  }

  /** All projects, the last changed one first. */
  async list(): Promise<Project[]> {
    const { of } = this.begin('readonly', 'projects');
    const all = await answer<Project[]>(of('projects').getAll());
    return all.sort((a, b) => b.changed_ms - a.changed_ms);
  }

  async rename(id: string, name: string): Promise<void> {
    const { transaction, of } = this.begin('readwrite', 'projects');
    const end = completed(transaction);
    const project = await answer<Project | undefined>(of('projects').get(id));
    if (project) of('projects').put({ ...project, name });
    await end;
  }

  /** A second one of the same work; the file of its character is kept once. */
  async duplicate(id: string, name: string): Promise<void> {
    const { transaction, of } = this.begin('readwrite', 'projects', 'works');
    const end = completed(transaction);
    const project = await answer<Project | undefined>(of('projects').get(id));
    const kept = await answer<{ work: unknown } | undefined>(of('works').get(id));
    if (project && kept) {
      const copy: Project = { ...project, ...freshProject(name), revision: 1 };
      of('projects').put(copy);
      of('works').put({ id: copy.id, work: kept.work });
    }
    await end;
  }

  /** Deletes a project, and its character's file if no other project uses it; null if there is none. */
  async remove(id: string): Promise<Removed | null> {
    const { transaction, of } = this.begin('readwrite', 'projects', 'works', 'files');
    const end = completed(transaction);
    const project = await answer<Project | undefined>(of('projects').get(id));
    const kept = await answer<{ work: unknown } | undefined>(of('works').get(id));
    of('projects').delete(id);
    of('works').delete(id);
    const files: KeptFile[] = [];
    for (const sha256 of await this.unused(of)) {
      if (sha256 !== project?.sha256) continue;
      files.push(await answer<KeptFile>(of('files').get(sha256)));
      of('files').delete(sha256);
    }
    await end;
    return project ? { project, work: kept?.work, files, bytes: bytesOf(files) } : null;
  }

  async restore({ project, work, files }: Removed): Promise<void> {
    const { transaction, of } = this.begin('readwrite', 'projects', 'works', 'files');
    const end = completed(transaction);
    of('projects').put(project);
    of('works').put({ id: project.id, work });
    for (const file of files) of('files').put(file);
    await end;
  }

  /** Deletes the files of characters that no project uses; how many bytes they had. */
  async sweep(): Promise<number> {
    const { transaction, of } = this.begin('readwrite', 'projects', 'files');
    const end = completed(transaction);
    const swept: KeptFile[] = [];
    for (const sha256 of await this.unused(of)) {
      swept.push(await answer<KeptFile>(of('files').get(sha256)));
      of('files').delete(sha256);
    }
    await end;
    return bytesOf(swept);
  }

  private async unused(of: (name: StoreName) => IDBObjectStore): Promise<string[]> {
    const used = new Set((await answer<Project[]>(of('projects').getAll())).map(({ sha256 }) => sha256));
    const all = await answer(of('files').getAllKeys());
    return all.filter((key): key is string => typeof key === 'string' && !used.has(key));
  }
}

const bytesOf = (files: readonly KeptFile[]): number => files.reduce((sum, { bytes }) => sum + bytes.length, 0);
