// SPDX-License-Identifier: MIT
// The panels at the right, one at a time.
import { t } from '../i18n';
import type { Tab } from '../state/model';
import type { Studio } from '../state/studio';
import { h, type Panel } from './dom';

export class Tabs implements Panel {
  readonly element: HTMLElement;
  private readonly tabs = new Map<Tab, HTMLButtonElement>();
  private readonly end: () => void;

  constructor(private readonly studio: Studio, private readonly panels: Record<Tab, Panel>) {
    const names = Object.keys(panels) as Tab[];
    const list = h('div', { class: 'tabs', role: 'tablist', 'aria-label': t('panels'), onKeydown: (event: KeyboardEvent) => this.key(event, names) });
    for (const name of names) {
      const tab = h('button', {
        type: 'button', role: 'tab', id: `tab-${name}`, 'aria-controls': `panel-${name}`, onClick: () => studio.store.set({ tab: name }),
      }, t(name));
      this.tabs.set(name, tab);
      list.append(tab);
      const { element } = panels[name];
      element.id = `panel-${name}`;
      element.setAttribute('role', 'tabpanel');
      element.setAttribute('aria-labelledby', tab.id);
      element.tabIndex = 0;
    }
    this.element = h('aside', { class: 'side', 'aria-label': t('panels') }, list, ...names.map((name) => panels[name].element));
    this.end = studio.store.subscribe((state, previous) => {
      if (state.tab !== previous.tab) this.update();
    });
    this.update();
  }

  private update(): void {
    const { tab: now } = this.studio.store.state;
    for (const [name, tab] of this.tabs) {
      tab.setAttribute('aria-selected', String(name === now));
      tab.tabIndex = name === now ? 0 : -1;
      this.panels[name].element.hidden = name !== now;
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
    for (const panel of Object.values(this.panels)) panel.dispose();
  }
}
