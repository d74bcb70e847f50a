// SPDX-License-Identifier: MIT
// The library under the goals: what is kept of goals and start postures, with pictures; a click uses it.
import { t } from '../i18n';
import { type Entry, kMostLibraryBytes, libraryText, type NewEntry, readLibrary } from '../kept/library';
import { startOfSpec, useEntry } from '../kept/use_entry';
import { thingsOf } from '../state/places';
import type { Studio } from '../state/studio';
import { save } from '../state/take_away';
import type { View } from '../view/view';
import { button, fill, h, iconButton } from './dom';

const kLongestName = 80;

export class LibrarySection {
  readonly element: HTMLElement;
  private readonly list = h('ul', { class: 'library', 'aria-label': t('library') });
  private readonly said = h('div', { class: 'said', role: 'status' });
  private readonly send: HTMLButtonElement;
  private entries: readonly Entry[] = [];
  private renaming: string | null = null;
  private refreshes = 0;
  private readonly library: Studio['library'];
  private readonly end: () => void;

  constructor(private readonly studio: Studio, private readonly view: View) {
    this.library = studio.library;
    const input = h('input', {
      type: 'file', accept: '.json', hidden: true, 'data-library': 'file',
      onChange: () => {
        const file = input.files?.[0];
        if (file) void this.takeIn(file);
        input.value = '';
      },
    });
    this.send = button(t('exportLibrary'), () => this.export(), { 'data-library': 'export' });
    this.element = h('section', { class: 'things', 'aria-label': t('library') }, h('h3', {}, t('library')), h('p', { class: 'quiet' }, t('libraryIntro')),
      h('div', { class: 'buttons' }, button(t('keepGoals'), () => this.keepGoals(), { 'data-library': 'keep goals' }),
        button(t('keepStart'), () => this.keepStart(), { 'data-library': 'keep start' })),
      this.list, this.said,
      h('div', { class: 'buttons' }, this.send, button(t('importLibrary'), () => input.click()), input));
    this.end = this.library.subscribe(() => void this.refresh());
    void this.refresh();
  }

  private async act(action: () => Promise<void>, about?: string): Promise<void> {
    this.renaming = null;
    fill(this.said);
    try {
      await action();
    } catch (error) {
      this.studio.fail(error, about);
    }
    await this.refresh();
  }

  private keepGoals(): void {
    const { document } = this.studio;
    if (document) this.keep({ kind: 'goals', goals: document.goals, things: thingsOf(document), name: this.freeName(t('goals')), picture: this.view.smallPicture() });
  }

  private keepStart(): void {
    const { document } = this.studio;
    if (document) this.keep({ kind: 'start', start: startOfSpec(document.character), name: this.freeName(t('startPostureName')), picture: this.view.smallPicture(0) });
  }

  private keep(entry: NewEntry): void {
    void this.act(() => this.library.add([entry]));
  }

  private freeName(name: string): string {
    const all = new Set(this.entries.map((entry) => entry.name));
    for (let k = 1; ; ++k) {
      if (!all.has(`${name} ${k}`)) return `${name} ${k}`;
    }
  }

  private export(): void {
    const file = { name: 'shigusa-library.json', bytes: new TextEncoder().encode(libraryText(this.entries)), type: 'application/json' };
    save(file);
    this.studio.tell({ kind: 'text', key: 'saved', values: { name: file.name } });
  }

  private takeIn(file: File): Promise<void> {
    if (file.size > kMostLibraryBytes) {
      this.studio.tell({ kind: 'text', key: 'tooLarge', values: { name: file.name, most: kMostLibraryBytes / 1e6 } });
      return Promise.resolve();
    }
    return this.act(async () => {
      const entries = readLibrary(await file.text());
      await this.library.add(entries);
      fill(this.said, h('span', {}, t('importedLibrary', { n: entries.length })));
    }, file.name);
  }

  private async refresh(): Promise<void> {
    const turn = ++this.refreshes;
    const entries = await this.library.list().catch(() => []);
    if (turn !== this.refreshes) return; // a later refresh shows the present state
    this.entries = entries;
    if (this.renaming !== null && this.list.querySelector(`[data-naming="${this.renaming}"]`)) return; // what is being typed stays
    fill(this.list, ...this.entries.map((entry) => this.row(entry)));
    this.send.disabled = this.entries.length === 0;
  }

  private row(entry: Entry): HTMLElement {
    const { name, picture, kind } = entry;
    if (this.renaming === entry.id) return this.nameField(entry);
    const use = h('button', { type: 'button', class: 'pick-character', 'data-entry': name, onClick: () => void this.act(() => useEntry(this.studio, entry), name) },
      picture ? h('img', { class: 'portrait', src: picture, alt: '' }) : h('span', { class: 'portrait' }),
      h('span', { class: 'about-character' }, h('b', {}, name), h('span', { class: 'quiet' }, kind === 'goals' ? t('goalsCount', { n: entry.goals.length }) : t('startPostureName'))));
    return h('li', {}, use, h('div', { class: 'row-tools' },
      iconButton('pencil', t('renameOf', { name }), () => this.edit(entry)),
      iconButton('bin', t('deleteOf', { name }), () => void this.remove(entry))));
  }

  private edit({ id }: Entry): void {
    this.renaming = id;
    void this.refresh().then(() => this.list.querySelector('input')?.select());
  }

  private nameField(entry: Entry): HTMLElement {
    const done = (text: string): void => {
      if (this.renaming !== entry.id) return;
      const name = text.trim() || entry.name;
      void this.act(() => this.library.put([{ ...entry, name }]));
    };
    const field: HTMLInputElement = h('input', {
      type: 'text', value: entry.name, maxlength: String(kLongestName), 'aria-label': t('renameOf', { name: entry.name }), onBlur: () => done(field.value),
      onKeydown: (event: KeyboardEvent) => {
        if (event.key === 'Enter') done(field.value);
        else if (event.key === 'Escape') done(entry.name);
      },
    });
    return h('li', { class: 'naming', 'data-naming': entry.id }, field);
  }

  private remove(entry: Entry): Promise<void> {
    return this.act(async () => {
      await this.library.remove(entry.id);
      const bringBack = (): void => void this.act(() => this.library.put([entry]));
      fill(this.said, h('span', {}, t('deleted', { name: entry.name })), button(t('undo'), bringBack, { 'data-library': 'undo' }));
    });
  }

  dispose(): void {
    this.end();
  }
}
