// SPDX-License-Identifier: MIT
// Keeps the work in the browser while it goes on, and brings the last one back.
import { t } from '../i18n';
import type { Saving, State } from '../state/model';
import type { Studio } from '../state/studio';
import { isQuota, openDatabase } from './database';
import { digestOf } from './digest';
import { hasLocks, ProjectLock } from './lock';
import { recall, remember } from './memory';
import { openWork, workNow, workOf } from './pack';
import { Conflict, freshProject, type KeptFile, type Project, ProjectStore } from './projects';
import { readWork, type Work } from './work';

const kEvery = 500; // ms; a crash loses no more
const kPatience = 8000; // ms until a database that does not answer is taken for none
const kCloses = 500; // ms until a tab that was closed has let go of its project
const kReloads = 1500; // ms until a page that is loaded anew has let go of its project
const kRemembered = 'project';

/** Changes of these are changes of the work. */
const kKept: readonly (keyof State)[] = ['document', 'tab', 'selected', 'compareMode', 'overlays', 'view', 'speed', 'fps'];

export class Keeper {
  private readonly ready: Promise<void>;
  private readonly lock = new ProjectLock();
  private projects: ProjectStore | null = null;
  private project: Project = freshProject(t('untitled'));
  private opened = false; // by a person, as a link is
  private opening = 0;
  private changes = 0;
  private saved = 0; // of the changes
  private timer = 0;
  private writing: Promise<void> = Promise.resolve();
  private readonly files = new Set<string>(); // SHA-256 of those that are kept, or do not fit …
  private readonly tooLarge = new Set<string>(); // … and of those that do not

  constructor(private readonly studio: Studio) {
    this.ready = Promise.race([this.openDatabase(), new Promise<void>((late) => void setTimeout(late, kPatience))]);
    studio.store.subscribe((state, previous) => {
      if (kKept.some((key) => state[key] !== previous[key])) this.changed();
    });
    studio.eye?.onLook(() => this.changed());
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

  private async openDatabase(): Promise<void> {
    const database = await openDatabase();
    if (!database) return;
    this.projects = new ProjectStore(database);
    // it may have come late
    if (this.studio.store.state.saving === 'off') this.changed();
  }

  // ---- Which project -----------------------------------------------------------------------------

  /** Brings back the work of this tab, else the one last saved; where there is none, or a damaged one, `openFirst`. */
  async openLast(openFirst: () => Promise<void>): Promise<void> {
    const own = recall(kRemembered, 'sessionStorage');
    const id = own ?? recall(kRemembered);
    if (id === null) return openFirst();
    await this.ready;
    const kept = await this.projects?.load(id).catch(() => null);
    if (!kept) return openFirst();
    const isFree = await this.lock.take(id, own === null ? kCloses : kReloads);
    const { name } = kept.project;
    try {
      await this.open(kept.work, kept.bytes);
    } catch (error) {
      this.lock.drop();
      await openFirst();
      return this.studio.fail(error, name);
    }
    // a work that waits for its character's file stays as it is kept
    if (!this.studio.document) return openFirst();
    this.studio.store.set({ start: false });
    if (!isFree) return this.goOnAsCopy(name);
    this.project = kept.project;
    this.tell('saved');
  }

  private open(work: unknown, bytes?: Uint8Array): Promise<void> {
    const checked = readWork(work);
    const files = bytes ? [new File([bytes as BlobPart], checked.character.spec.source)] : [];
    return this.quietly(() => openWork(this.studio, checked, files));
  }

  /** Opens what a person came with in a project of its own; whether it is kept. */
  async openAsNew(open: () => Promise<void>): Promise<boolean> {
    await this.write();
    await this.quietly(open);
    this.project = freshProject(t('untitled'));
    this.opened = true;
    this.changed();
    const { changes } = this;
    await this.write();
    return this.saved >= changes; // more may have come meanwhile, as what its search found
  }

  /** Nothing that `open` does is a change of the project that is on the table. */
  private async quietly(open: () => Promise<void>): Promise<void> {
    ++this.opening;
    try {
      await open();
    } finally {
      --this.opening;
    }
  }

  /** Another tab has the project. */
  private goOnAsCopy(name: string): void {
    this.project = freshProject(t('copyOf', { name }));
    this.opened = true;
    this.studio.tell({ kind: 'text', key: 'openElsewhere', values: { name, copy: this.project.name } });
  }

  // ---- Saving ------------------------------------------------------------------------------------

  private changed(): void {
    const { document, canUndo } = this.studio.store.state;
    // what opens by itself is nobody's work
    if (this.opening > 0 || !document) return;
    const isWork = this.opened || canUndo || this.project.revision > 0 || document.character.bytes !== undefined;
    if (!isWork) return;
    if (document.character.bytes) void digestOf(document.character.bytes);
    ++this.changes;
    this.tell('unsaved');
    if (this.timer === 0) this.timer = window.setTimeout(() => void this.write(), kEvery);
  }

  /** Saves what is not saved yet, one after the other. */
  private write(): Promise<void> {
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
      await this.save(this.projects, work, this.fileOf(work));
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
    const { project } = this;
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

  private fileOf({ character: { sha256 } }: Work): KeptFile | undefined {
    const bytes = this.studio.document?.character.bytes;
    return sha256 && bytes && !this.files.has(sha256) ? { sha256, bytes } : undefined;
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
      await this.send(projects, work, this.fileOf(work), hasLocks());
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
    this.tell(this.changes > changes ? 'unsaved' : whole ? 'saved' : 'incomplete');
  }

  private keepNothing(): void {
    if (this.studio.store.state.saving !== 'off') this.studio.tell({ kind: 'text', key: 'keepsNothing' });
    this.tell('off');
  }

  private tell(saving: Saving): void {
    this.studio.store.set({ saving, project: this.project.name });
  }
}
