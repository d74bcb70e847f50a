// SPDX-License-Identifier: MIT
// The list of projects: a button in the top bar that shows the open project and whether it is saved, and its menu.
import { spokenLanguage, t } from '../i18n';
import { button, fill, h, icon, iconButton, type Panel } from '../panels/dom';
import { keepPlaced } from '../panels/popover';
import type { Studio } from '../state/studio';
import type { Keeper } from './keeper';
import type { Project, Removed } from './projects';
import { SavingPanel } from './saving_panel';

const kLongestName = 80;

const megabytes = (bytes: number): string => (bytes / 1e6).toFixed(bytes < 1e7 ? 1 : 0);

export class ProjectMenu implements Panel {
  readonly element: HTMLElement;
  private readonly menu: HTMLElement;
  private readonly opener: HTMLButtonElement;
  private readonly list = h('ul', { class: 'projects', 'aria-label': t('projects') });
  private readonly said = h('div', { class: 'said', role: 'status' });
  private readonly room = h('p', { class: 'quiet' });
  private readonly saving: SavingPanel;
  private renaming: string | null = null; // a project's id
  private refreshes = 0;
  private readonly ends: (() => void)[];

  constructor(private readonly studio: Studio, private readonly keeper: Keeper) {
    this.saving = new SavingPanel(studio);
    this.menu = h('div', { id: 'project-menu', class: 'view-menu project-menu', popover: 'auto', role: 'dialog', 'aria-label': t('projects') },
      h('header', {}, h('h3', {}, t('projects')), button(t('newProject'), () => void this.act(() => keeper.openNew()), { 'data-project': 'new' })),
      this.list, this.said, h('p', { class: 'quiet' }, t('savingWhere')), this.room);
    this.opener = h('button', { type: 'button', class: 'project-opener', 'aria-haspopup': 'dialog', popovertarget: 'project-menu', title: t('projects') },
      icon('folder'), h('span', { class: 'unseen' }, t('projects')), this.saving.element);
    this.menu.addEventListener('toggle', () => {
      this.renaming = null;
      if (this.isOpen) void this.refresh();
    });
    this.element = h('div', { class: 'project-corner' }, this.opener, this.menu);
    this.ends = [
      keepPlaced(this.menu, this.opener, 'below'),
      studio.store.subscribe((state, previous) => {
        if (this.isOpen && this.renaming === null && (state.saving !== previous.saving || state.project !== previous.project)) void this.refresh();
      }),
    ];
  }

  private get isOpen(): boolean {
    return this.menu.matches(':popover-open');
  }

  /** Does something to the projects and shows what is there then. */
  private async act(action: () => Promise<void>): Promise<void> {
    this.renaming = null;
    fill(this.said);
    try {
      await action();
    } catch (error) {
      this.studio.fail(error);
    }
    await this.refresh();
  }

  private async refresh(): Promise<void> {
    const turn = ++this.refreshes;
    const { present } = this.keeper;
    const kept = await this.keeper.list();
    if (turn !== this.refreshes) return; // a later refresh shows the present state
    if (this.renaming !== null && this.list.querySelector(`[data-naming="${this.renaming}"]`)) return; // what is being typed stays
    const isKept = kept.some(({ id }) => id === present.id);
    const focused = this.list.contains(document.activeElement) ? (document.activeElement as HTMLElement).dataset['project'] : undefined;
    fill(this.list, ...(isKept ? kept : [present, ...kept]).map((project) => {
      const isPresent = project.id === present.id;
      return this.row(project, isPresent, (isPresent ? present : project).picture);
    }));
    if (focused) this.list.querySelector<HTMLElement>(`[data-project="${focused}"]`)?.focus();
    const { freedBytes } = this.keeper;
    this.room.hidden = freedBytes === 0;
    this.room.textContent = t('freed', { mb: megabytes(freedBytes) });
  }

  private row(project: Project, isPresent: boolean, picture: string | undefined): HTMLElement {
    const { id, name, revision } = project;
    if (this.renaming === id) return this.nameField(project);
    const date = new Date(project.changed_ms).toLocaleString(spokenLanguage(), { dateStyle: 'medium', timeStyle: 'short' });
    const pick = h('button', { type: 'button', class: 'pick-character', 'aria-pressed': String(isPresent), 'data-project': id, onClick: () => this.open(id) },
      picture ? h('img', { class: 'portrait', src: picture, alt: '' }) : h('span', { class: 'portrait' }),
      h('span', { class: 'about-character' }, h('b', {}, name), h('span', { class: 'quiet' }, revision > 0 ? date : t('saving_none'))));
    const tools = h('div', { class: 'row-tools' }, iconButton('pencil', t('renameOf', { name }), () => this.edit(id)),
      ...(revision > 0 ? [
        iconButton('copy', t('duplicateOf', { name }), () => void this.duplicate(project)),
        iconButton('bin', t('deleteOf', { name }), () => void this.remove(project, isPresent)),
      ] : []));
    return h('li', {}, pick, tools);
  }

  private open(id: string): void {
    if (id === this.keeper.present.id) return;
    void this.act(async () => {
      await this.keeper.openKept(id);
      this.menu.hidePopover();
    });
  }

  private edit(id: string): void {
    this.renaming = id;
    void this.refresh().then(() => this.list.querySelector('input')?.select());
  }

  private nameField({ id, name }: Project): HTMLElement {
    const done = (text: string): void => {
      if (this.renaming !== id) return;
      const typed = text.trim();
      void this.act(async () => {
        if (typed !== '' && typed !== name && !(await this.keeper.rename(id, typed))) this.tellBusy(name);
      });
    };
    const field: HTMLInputElement = h('input', {
      type: 'text', value: name, maxlength: String(kLongestName), 'aria-label': t('renameOf', { name }), onBlur: () => done(field.value),
      onKeydown: (event: KeyboardEvent) => {
        if (event.key === 'Enter') done(field.value);
        if (event.key !== 'Escape') return;
        event.preventDefault(); // the menu stays
        done(name);
      },
    });
    return h('li', { class: 'naming', 'data-naming': id }, field);
  }

  private duplicate({ id, name }: Project): Promise<void> {
    return this.act(async () => {
      const store = await this.keeper.settledStore();
      await store?.duplicate(id, await this.keeper.freeName(t('copyOf', { name })));
    });
  }

  private remove({ id, name }: Project, isPresent: boolean): Promise<void> {
    return this.act(async () => {
      const removed = await this.keeper.remove(id);
      if (!removed) return this.tellBusy(name);
      const text = removed.bytes > 0 ? t('deletedFreed', { name, mb: megabytes(removed.bytes) }) : t('deleted', { name });
      fill(this.said, h('span', {}, text), button(t('undo'), () => void this.bringBack(removed, isPresent), { 'data-project': 'undo' }));
    });
  }

  private bringBack(removed: Removed, isPresent: boolean): Promise<void> {
    return this.act(async () => {
      await (await this.keeper.settledStore())?.restore(removed);
      if (isPresent) await this.keeper.openKept(removed.project.id);
    });
  }

  private tellBusy(name: string): void {
    fill(this.said, h('span', {}, t('openInTab', { name })));
  }

  dispose(): void {
    for (const end of this.ends) end();
    this.saving.dispose();
  }
}
