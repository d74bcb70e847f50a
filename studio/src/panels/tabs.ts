// SPDX-License-Identifier: MIT
// The panels at the right, one at a time.
import { t } from '../i18n';
import type { Tab } from '../state/model';
import type { Studio } from '../state/studio';
import { button, fill, h, type Panel } from './dom';

/** A panel, or a function that loads it when it is first shown. */
export type TabPanel = Panel | (() => Promise<Panel>);

export class Tabs implements Panel {
  readonly element: HTMLElement;
  private readonly tabs = new Map<Tab, HTMLButtonElement>();
  private readonly elements = new Map<Tab, HTMLElement>();
  private readonly made: Panel[] = [];
  private readonly wanted = new Map<Tab, () => Promise<Panel>>(); // not fetched yet
  private disposed = false;
  private readonly end: () => void;

  constructor(private readonly studio: Studio, panels: Record<Tab, TabPanel>) {
    const names = Object.keys(panels) as Tab[];
    const list = h('div', { class: 'tabs', role: 'tablist', 'aria-label': t('panels'), onKeydown: (event: KeyboardEvent) => this.key(event, names) });
    for (const name of names) {
      const tab = h('button', {
        type: 'button', role: 'tab', id: `tab-${name}`, 'aria-controls': `panel-${name}`, onClick: () => studio.store.set({ tab: name }),
      }, t(name));
      this.tabs.set(name, tab);
      list.append(tab);
    }
    this.element = h('aside', { class: 'side', 'aria-label': t('panels') }, list);
    for (const name of names) {
      const panel = panels[name];
      if (typeof panel === 'function') this.wanted.set(name, panel);
      else this.made.push(panel);
      const element = typeof panel === 'function' ? h('div', { class: 'panel' }) : panel.element;
      this.place(name, element);
      this.element.append(element);
    }
    this.end = studio.store.subscribe((state, previous) => {
      if (state.tab !== previous.tab) this.update();
    });
    this.update();
  }

  private place(name: Tab, element: HTMLElement): void {
    element.id = `panel-${name}`;
    element.setAttribute('role', 'tabpanel');
    element.setAttribute('aria-labelledby', `tab-${name}`);
    element.tabIndex = 0;
    element.hidden = name !== this.studio.store.state.tab;
    this.elements.set(name, element);
  }

  private update(): void {
    const { tab: now } = this.studio.store.state;
    for (const [name, tab] of this.tabs) {
      tab.setAttribute('aria-selected', String(name === now));
      tab.tabIndex = name === now ? 0 : -1;
      this.elements.get(name)!.hidden = name !== now;
    }
    void this.fetch(now);
  }

  /** Puts a panel in its place that was not there yet. */
  private async fetch(name: Tab): Promise<void> {
    const wanted = this.wanted.get(name);
    if (!wanted) return;
    this.wanted.delete(name);
    const place = this.elements.get(name)!;
    try {
      const panel = await wanted();
      if (this.disposed) return panel.dispose();
      this.made.push(panel);
      this.place(name, panel.element);
      const focused = place.contains(document.activeElement);
      place.replaceWith(panel.element);
      if (focused) panel.element.focus();
    } catch {
      this.wanted.set(name, wanted);
      fill(place, h('p', { role: 'alert' }, t('partFailed')), button(t('tryAgain'), () => void this.fetch(name)));
    }
  }

  private key(event: KeyboardEvent, names: readonly Tab[]): void {
    const step = { ArrowRight: 1, ArrowLeft: -1, Home: -names.length, End: names.length }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    const now = names.indexOf(this.studio.store.state.tab);
    const next = Math.abs(step) === 1 ? (now + step + names.length) % names.length : step < 0 ? 0 : names.length - 1;
    const name = names[next]!;
    this.studio.store.set({ tab: name });
    this.tabs.get(name)!.focus();
  }

  dispose(): void {
    this.end();
    this.disposed = true;
    for (const panel of this.made) panel.dispose();
  }
}
