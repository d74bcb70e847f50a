// SPDX-License-Identifier: MIT
// Keeps the project on the table in the browser while it goes on.
import { t } from '../i18n';
import type { Document, Saving, State } from '../state/model';
import type { Studio } from '../state/studio';
import type { Eye } from '../state/workbench';
import { isQuota, openDatabase } from './database';
import { digestOf } from './digest';
import { note, strike } from './journal';
import { hasLocks, ProjectLock } from './lock';
import { remember } from './memory';
import { workNow, workOf } from './pack';
import { Conflict, freshProject, type KeptFile, type Project, ProjectStore } from './projects';
import type { Work } from './work';

const kEvery = 500; // ms
const kPatience = 8000; // ms until a database that does not answer is taken for none
/** By which the browser remembers the project last worked on. */
export const kRemembered = 'project';

/** Changes of these are changes of the work. */
const kKept: readonly (keyof State)[] = ['document', 'tab', 'selected', 'compareMode', 'overlays', 'view', 'speed', 'fps', 'snap', 'symmetric'];

export class Saver {
  protected readonly ready: Promise<void>;
  protected readonly lock = new ProjectLock();
  protected projects: ProjectStore | null = null;
  protected project: Project = freshProject(t('untitled'));
  protected opened = false; // by a person, as a link is
  private opening = 0;
  protected changes = 0;
  protected saved = 0; // of the changes
  private timer = 0;
  private writing: Promise<void> = Promise.resolve();
  protected freed = 0; // bytes of files that no project used
  protected picture: () => string | null = () => null;
  private readonly files = new Set<string>(); // SHA-256 of those that are kept, or do not fit …
  private readonly tooLarge = new Set<string>(); // … and of those that do not

  constructor(protected readonly studio: Studio) {
    this.ready = Promise.race([this.openDatabase(), new Promise<void>((late) => void setTimeout(late, kPatience))]);
    studio.store.subscribe((state, previous) => {
      if (kKept.some((key) => state[key] !== previous[key])) this.changed(true);
    });
    document.addEventListener('visibilitychange', () => {
      if (document.visibilityState === 'hidden') void this.flush();
    });
    window.addEventListener('pagehide', () => void this.flush());
    window.addEventListener('beforeunload', (event) => {
      void this.flush();
      const { saving } = this.studio.store.state;
      if (saving === 'off' || saving === 'failed') event.preventDefault();
    });
  }

  /** Where the work is seen from is part of it; `picture`: the chosen motion, small, as a data URL. */
  follow(eye: Eye, picture: () => string | null): void {
    eye.onLook(() => this.changed());
    this.picture = picture;
  }

  private async openDatabase(): Promise<void> {
    const database = await openDatabase();
    if (!database) return;
    this.projects = new ProjectStore(database);
    this.projects.sweep().then((bytes) => (this.freed += bytes)).catch(() => undefined); // they only take room
    // it may have come late
    if (this.studio.store.state.saving === 'off') this.changed();
  }

  /** Nothing that `open` does is a change of the project that is on the table. */
  protected async quietly(open: () => Promise<void>): Promise<void> {
    ++this.opening;
    try {
      await open();
    } finally {
      --this.opening;
    }
  }

  /** Another tab has the project. */
  protected goOnAsCopy(name: string): void {
    this.project = freshProject(t('copyOf', { name }));
    this.opened = true;
    this.tell('none');
    this.studio.tell({ kind: 'text', key: 'openElsewhere', values: { name, copy: this.project.name } });
  }

  /** `atOnce`: noted for the case that the page ends before all is saved. */
  protected changed(atOnce = false): void {
    const { document, canUndo } = this.studio.store.state;
    // a document opened automatically is not the user's work
    if (this.opening > 0 || !document) return;
    const isWork = this.opened || canUndo || this.project.revision > 0 || document.character.bytes !== undefined;
    if (!isWork) return;
    if (document.character.bytes) void digestOf(document.character.bytes);
    ++this.changes;
    this.tell('unsaved');
    if (atOnce) this.note(document);
    if (this.timer === 0) this.timer = window.setTimeout(() => void this.write(), kEvery);
  }

  private note(document: Document): void {
    const work = this.projects && workNow(this.studio, document);
    if (!work) return;
    this.remember();
    note(this.project, work);
  }

  /** Saves all unsaved work, one project after the other. */
  protected write(): Promise<void> {
    window.clearTimeout(this.timer);
    this.timer = 0;
    this.writing = this.writing.then(() => this.writeOnce());
    return this.writing;
  }

  private async writeOnce(): Promise<void> {
    await this.ready;
    const { document } = this.studio;
    const { changes } = this;
    if (!document || this.opening > 0 || this.saved === changes) return;
    if (!this.projects) return this.keepNothing();
    const work = await workOf(this.studio, document);
    try {
      if (this.project.revision === 0) await this.lock.take(this.project.id, 0);
      this.remember();
      await this.save(this.projects, work, this.fileOf(work, this.tooLarge));
      this.done(changes, work);
    } catch (error) {
      if (error instanceof Conflict) {
        this.goOnAsCopy(this.project.name);
        return this.changed();
      }
      this.tell('failed');
      const why = error instanceof Error ? error.message : String(error);
      this.studio.tell({ kind: 'text', key: isQuota(error) ? 'storageFull' : 'storageFailed', values: { why } });
    }
  }

  /** Saves, without the character's file where that does not fit. */
  private async save(projects: ProjectStore, work: Work, file: KeptFile | undefined): Promise<void> {
    try {
      await this.send(projects, work, file);
    } catch (error) {
      if (!isQuota(error) || !file) throw error;
      await this.send(projects, work);
      this.studio.tell({ kind: 'text', key: 'fileTooLarge', values: { name: work.character.spec.source } });
      this.tooLarge.add(file.sha256);
    }
    if (file) this.files.add(file.sha256);
  }

  private async send(projects: ProjectStore, work: Work, file?: KeptFile, last = false): Promise<void> {
    const project = { ...this.project, picture: this.picture() ?? this.project.picture };
    const saved = projects.save(project, work, file, last);
    // the next one may go out before the answer to this one
    this.project = { ...project, revision: project.revision + 1 };
    try {
      await saved;
    } catch (error) {
      if (error instanceof Conflict) throw error;
      const revision = await projects.revision(project.id);
      if (this.project.id === project.id) this.project = { ...this.project, revision };
      throw error;
    }
  }

  /** The character's file, but for those that are `done` with. */
  private fileOf({ character: { sha256 } }: Work, done: ReadonlySet<string>): KeptFile | undefined {
    const bytes = this.studio.document?.character.bytes;
    return sha256 && bytes && !done.has(sha256) ? { sha256, bytes } : undefined;
  }

  /** The page may end now: all that is not saved goes out at once. Where it does not end, its timer tries again. */
  private async flush(): Promise<void> {
    const { document } = this.studio;
    const { changes, projects } = this;
    if (this.saved === changes || this.opening > 0 || !document || !projects) return;
    const work = workNow(this.studio, document);
    if (!work) return;
    this.remember();
    try {
      note(this.project, work);
      await this.send(projects, work, this.fileOf(work, this.files), hasLocks());
      this.done(changes, work);
    } catch {
      // told by the timer's try
    }
  }

  private remember(): void {
    remember(kRemembered, this.project.id, 'sessionStorage');
    remember(kRemembered, this.project.id);
  }

  private done(changes: number, { character: { sha256 } }: Work): void {
    this.saved = Math.max(this.saved, changes);
    const whole = sha256 === undefined || !this.tooLarge.has(sha256);
    if (this.changes === changes) strike(this.project.id);
    this.tell(this.changes > changes ? 'unsaved' : whole ? 'saved' : 'incomplete');
  }

  private keepNothing(): void {
    if (this.studio.store.state.saving !== 'off') this.studio.tell({ kind: 'text', key: 'keepsNothing' });
    this.tell('off');
  }

  protected tell(saving: Saving): void {
    this.studio.store.set({ saving, project: this.project.name });
  }
}
