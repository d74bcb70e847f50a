// SPDX-License-Identifier: MIT
// The View menu: a button in the corner of the picture, and what it opens.
import { t } from '../i18n';
import type { Studio } from '../state/studio';
import { kMostGhosts, type ViewSettings } from '../state/view_settings';
import { h, icon, type Panel } from './dom';

const kGap = 6; // px between the button and the menu, and between the menu and the page's edges
const kUsualGhosts = 5;

export function setView(studio: Studio, patch: Partial<ViewSettings>): void {
  studio.store.set({ view: { ...studio.store.state.view, ...patch } });
}

/** What a key of the View menu does; undefined where it is none of them. */
export function viewKey(studio: Studio, event: KeyboardEvent): (() => void) | undefined {
  const { view } = studio.store.state;
  switch (event.key.toLowerCase()) {
    case 'g':
      return () => setView(studio, { ghosts: view.ghosts > 0 ? 0 : kUsualGhosts });
    case 'p':
      return () => setView(studio, { path: !view.path });
  }
}

export class ViewMenu implements Panel {
  readonly element: HTMLElement;
  private readonly menu: HTMLElement;
  private readonly opener: HTMLButtonElement;
  private readonly updates: (() => void)[] = [];
  private readonly end: () => void;

  constructor(private readonly studio: Studio) {
    this.menu = h('div', { id: 'view-menu', class: 'view-menu', popover: 'auto', role: 'dialog', 'aria-label': t('view') },
      h('section', {}, h('h3', {}, t('viewMotion')), this.ghosts(), this.switch('path', t('viewPath'), 'P')));
    this.opener = h('button', { type: 'button', class: 'view-opener', 'aria-haspopup': 'dialog', popovertarget: 'view-menu' }, icon('eye'), h('span', {}, t('view')));
    this.menu.addEventListener('toggle', () => this.place());
    // Escape closes the menu alone
    this.menu.addEventListener('keydown', (event) => {
      if (event.key === 'Escape') event.stopPropagation();
    });
    window.addEventListener('resize', this.place);
    this.element = h('div', { class: 'view-corner' }, this.opener, this.menu);
    this.end = studio.store.subscribe((state, previous) => {
      if (state.view !== previous.view) this.update();
    });
    this.update();
  }

  /** Above its button where there is room, always inside the page. */
  private readonly place = (): void => {
    if (!this.menu.matches(':popover-open')) return;
    const from = this.opener.getBoundingClientRect();
    const { style } = this.menu;
    style.maxHeight = `${window.innerHeight - 2 * kGap}px`;
    const { offsetWidth: width, offsetHeight: height } = this.menu;
    const inside = (value: number, most: number): number => Math.max(Math.min(value, most - kGap), kGap);
    style.left = `${inside(from.right - width, window.innerWidth - width)}px`;
    style.top = `${inside(from.top - kGap - height, window.innerHeight - height)}px`;
  };

  private ghosts(): HTMLElement {
    const count = h('output', {});
    const range = h('input', {
      type: 'range', min: '0', max: String(kMostGhosts), step: '1', 'data-view': 'ghosts',
      onInput: () => setView(this.studio, { ghosts: Number(range.value) }),
    });
    this.updates.push(() => {
      const { ghosts } = this.studio.store.state.view;
      range.value = String(ghosts);
      count.textContent = String(ghosts);
    });
    return h('label', { class: 'view-row', title: t('viewGhostsTitle') }, h('span', {}, t('viewGhosts')), range, count, h('kbd', {}, 'G'));
  }

  private switch(name: 'path', label: string, key: string): HTMLElement {
    const box = h('input', { type: 'checkbox', 'data-view': name, onChange: () => setView(this.studio, { [name]: box.checked }) });
    this.updates.push(() => {
      box.checked = this.studio.store.state.view[name];
    });
    return h('label', { class: 'view-row' }, box, h('span', {}, label), h('kbd', {}, key));
  }

  private update(): void {
    for (const update of this.updates) update();
  }

  dispose(): void {
    window.removeEventListener('resize', this.place);
    this.end();
  }
}
