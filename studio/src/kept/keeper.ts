// SPDX-License-Identifier: MIT
// Which project is on the table: the last one comes back, others are opened, begun and renamed.
import { t } from '../i18n';
import { openCharacter } from '../state/files';
import { type Noted, noted, strike } from './journal';
import { whileFree } from './lock';
import { forget, recall } from './memory';
import { openWork } from './pack';
import { freshProject, type Project, type ProjectStore, type Removed } from './projects';
import { kRemembered, Saver } from './saver';
import { readWork } from './work';

const kCloses = 500; // ms until a tab that was closed has let go of its project
const kReloads = 1500; // ms until a page that is loaded anew has let go of its project

export class Keeper extends Saver {
  /** Restores the work of this tab, else the last saved one; if there is none, or it is damaged, calls `openFirst`. */
  async openLast(openFirst: () => Promise<void>): Promise<void> {
    const own = recall(kRemembered, 'sessionStorage');
    const id = own ?? recall(kRemembered);
    if (id === null) return openFirst();
    await this.ready;
    const kept = await this.projects?.load(id).catch(() => null);
    const last = noted(id, kept?.project.revision ?? 0);
    const project = kept?.project ?? (last && { ...last.project, revision: 0 });
    if (!project) return openFirst();
    const isFree = await this.lock.take(id, own === null ? kCloses : kReloads);
    try {
      await this.openEither(last, kept?.work);
    } catch (error) {
      this.lock.drop();
      await openFirst();
      return this.studio.fail(error, project.name);
    }
    // a work that waits for its character's file stays as it is kept
    if (!this.studio.document) return openFirst();
    this.studio.store.set({ start: false });
    this.isPut(project, isFree);
    if (last) this.changed();
  }

  /** What was noted last, else what is kept. */
  private async openEither(last: Noted | null, kept: unknown): Promise<void> {
    if (!last) return this.open(kept);
    try {
      await this.open(last.work);
    } catch (error) {
      if (kept === undefined) throw error;
      await this.open(kept);
    }
  }

  private async open(work: unknown): Promise<void> {
    const checked = readWork(work);
    const { spec, sha256 } = checked.character;
    const bytes = sha256 ? await this.projects?.file(sha256) : undefined;
    const files = bytes ? [new File([bytes as BlobPart], spec.source)] : [];
    await this.quietly(() => openWork(this.studio, checked, files));
  }

  /** A project is on the table; where another tab has it, a copy. */
  private isPut(project: Project, isFree: boolean): void {
    if (!isFree) return this.goOnAsCopy(project.name);
    this.project = project;
    this.opened = true;
    this.tell('saved');
  }

  /** Opens what a person came with in a project of its own; whether it is kept. */
  async openAsNew(open: () => Promise<void>): Promise<boolean> {
    await this.write();
    await this.quietly(open);
    this.studio.forgetSteps();
    this.project = freshProject(await this.freeName(t('untitled')));
    this.opened = true;
    this.changed(true);
    const { changes } = this;
    await this.write();
    return this.saved >= changes; // there may be later changes, such as its search's result
  }

  // ---- What the list of projects does ------------------------------------------------------------

  get present(): Project {
    return { ...this.project, picture: this.picture() ?? this.project.picture };
  }

  async list(): Promise<Project[]> {
    await this.ready;
    return (await this.projects?.list()) ?? [];
  }

  /** Of files that no project used. */
  get freedBytes(): number {
    return this.freed;
  }

  /** The database with all of the present work; null where the browser keeps nothing, or not all, which is told. */
  async settledStore(): Promise<ProjectStore | null> {
    if (this.project.revision > 0 && this.project.picture === undefined && this.picture() !== null) this.changed();
    await this.write();
    return this.saved === this.changes ? this.projects : null;
  }

  /** Puts another project on the table. */
  async openKept(id: string): Promise<void> {
    const kept = await (await this.settledStore())?.load(id);
    if (!kept) return;
    const before = this.project.id;
    const isFree = await this.lock.take(id, 0);
    try {
      await this.open(kept.work);
    } catch (error) {
      await this.lock.take(before, 0);
      return this.studio.fail(error, kept.project.name);
    }
    this.studio.forgetSteps();
    this.saved = this.changes;
    this.isPut(kept.project, isFree);
  }

  /** An empty project, with the person to begin with; it is kept once something is done. */
  async openNew(): Promise<void> {
    if (await this.settledStore()) await this.openEmpty();
  }

  private async openEmpty(): Promise<void> {
    await this.quietly(() => openCharacter(this.studio, { source: 'human' }));
    this.studio.forgetSteps();
    this.lock.drop();
    for (const memory of ['sessionStorage', 'localStorage'] as const) forget(kRemembered, memory);
    this.project = freshProject(await this.freeName(t('untitled')));
    this.opened = false;
    this.saved = this.changes;
    this.tell('none');
  }

  /** Deletes a project; null where another tab has it, or it is gone. The one on the table makes room for the last changed one. */
  async remove(id: string): Promise<Removed | null> {
    const store = await this.settledStore();
    if (!store) return null;
    let removed: Removed | null = null;
    const act = async (): Promise<void> => {
      removed = await store.remove(id);
      strike(id);
    };
    if (id !== this.project.id) {
      await whileFree(id, act);
      return removed;
    }
    await act();
    const [next] = await store.list();
    if (next) await this.openKept(next.id);
    if (this.project.id === id) await this.openEmpty();
    return removed;
  }

  async rename(id: string, name: string): Promise<boolean> {
    if (id !== this.project.id) return whileFree(id, async () => this.projects?.rename(id, name));
    await this.renamePresent(name);
    return true;
  }

  private async renamePresent(name: string): Promise<void> {
    this.project = { ...this.project, name };
    this.opened = true;
    this.changed(true);
    await this.write();
  }

  /** A name that no project has: "Untitled", "Untitled 2", … */
  async freeName(name: string): Promise<string> {
    const all = new Set((await this.projects?.list().catch(() => []))?.map((project) => project.name));
    for (let k = 2, free = name; ; ++k) {
      if (!all.has(free)) return free;
      free = `${name} ${k}`;
    }
  }
}
