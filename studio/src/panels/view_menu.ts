// SPDX-License-Identifier: MIT
// The View menu: a button in the corner of the picture, and its menu.
import { t } from '../i18n';
import { lengthUnits } from '../i18n/lengths';
import type { Studio } from '../state/studio';
import { kLongestFocal_mm, kMostGhosts, kShortestFocal_mm, kUsualFocal_mm, type ViewSettings } from '../state/view_settings';
import { type Preset, presets } from '../view/camera';
import type { View } from '../view/view';
import { button, h, icon, type Panel, select } from './dom';
import { keepPlaced } from './popover';

const kUsualGhosts = 5;

type Switch = 'orthographic' | 'ruler' | 'path';

/** Keys that Blender's users know, on the number pad. */
const kPadSides: Readonly<Record<string, Preset>> = { Numpad1: 'front', Numpad3: 'side', Numpad7: 'top', Numpad0: 'threeQuarters' };
const kSwitchKeys: Readonly<Record<string, Switch>> = { o: 'orthographic', u: 'ruler', p: 'path' };

export class ViewMenu implements Panel {
  readonly element: HTMLElement;
  private readonly menu: HTMLElement;
  private readonly opener: HTMLButtonElement;
  private readonly updates: (() => void)[] = [];
  private last = presets.indexOf('threeQuarters'); // side that was looked from
  private readonly unplace: () => void;
  private readonly end: () => void;

  constructor(private readonly studio: Studio, private readonly view: View) {
    this.menu = h('div', { id: 'view-menu', class: 'view-menu', popover: 'auto', role: 'dialog', 'aria-label': t('view') },
      h('section', {}, h('h3', {}, t('camera')),
        h('div', { class: 'view-sides' }, ...presets.map((preset) => button(t(preset), () => this.lookFromSide(preset), { 'data-side': preset })),
          button(t('approach'), () => view.approachSelected(), { 'data-view': 'approach' }), button(t('resetCamera'), () => this.reset(), { 'data-view': 'reset' })),
        this.focal(), this.switch('orthographic', t('orthographic'), 'O')),
      h('section', {}, h('h3', {}, t('viewMotion')), this.ghosts(), this.switch('path', t('viewPath'), 'P'), this.switch('ruler', t('ruler'), 'U'), this.units()));
    this.opener = h('button', { type: 'button', class: 'view-opener', 'aria-haspopup': 'dialog', popovertarget: 'view-menu' }, icon('eye'), h('span', {}, t('view')));
    this.unplace = keepPlaced(this.menu, this.opener, 'above');
    this.element = h('div', { class: 'view-corner' }, this.opener, this.menu);
    this.end = studio.store.subscribe((state, previous) => {
      if (state.view !== previous.view) this.update();
    });
    this.update();
  }

  /** What a key does here; undefined where it does nothing. */
  actionOf(event: KeyboardEvent): (() => void) | undefined {
    const { view } = this.studio.store.state;
    const pad = kPadSides[event.code];
    if (pad && event.location === KeyboardEvent.DOM_KEY_LOCATION_NUMPAD && event.key.length === 1) return () => this.lookFromSide(pad);
    const key = event.key.toLowerCase();
    const name = kSwitchKeys[key] ?? (event.code === 'Numpad5' ? 'orthographic' : undefined);
    if (name) return () => this.set({ [name]: !view[name] });
    switch (key) {
      case 'g':
        return () => this.set({ ghosts: view.ghosts > 0 ? 0 : kUsualGhosts });
      case 'v':
        return () => this.lookFromSide(presets[(this.last + (event.shiftKey ? presets.length - 1 : 1)) % presets.length]!);
      case 'f':
        return () => this.view.approachSelected();
      case 'home':
        // fields and lists have a use for it
        return event.target instanceof Element && event.target.closest('input, select, .side, .gallery') ? undefined : () => this.reset();
    }
  }

  private set(patch: Partial<ViewSettings>): void {
    this.studio.store.set({ view: { ...this.studio.store.state.view, ...patch } });
  }

  private lookFromSide(preset: Preset): void {
    this.last = presets.indexOf(preset);
    this.view.lookFromSide(preset);
  }

  private reset(): void {
    this.set({ orthographic: false, focal_mm: kUsualFocal_mm });
    this.lookFromSide('threeQuarters');
  }

  private focal(): HTMLElement {
    const text = h('output', { class: 'focal' });
    const range = h('input', {
      type: 'range', min: String(kShortestFocal_mm), max: String(kLongestFocal_mm), step: '1', 'data-view': 'focal_mm',
      onInput: () => this.set({ focal_mm: Number(range.value) }),
    });
    this.updates.push(() => {
      const { focal_mm, orthographic } = this.studio.store.state.view;
      range.value = String(focal_mm);
      range.disabled = orthographic;
      text.textContent = t('mm', { mm: Math.round(focal_mm) });
      range.setAttribute('aria-valuetext', text.textContent);
    });
    return h('label', { class: 'view-row' }, h('span', {}, t('focal')), range, text);
  }

  private ghosts(): HTMLElement {
    const count = h('output', {});
    const range = h('input', {
      type: 'range', min: '0', max: String(kMostGhosts), step: '1', 'data-view': 'ghosts',
      onInput: () => this.set({ ghosts: Number(range.value) }),
    });
    this.updates.push(() => {
      const { ghosts } = this.studio.store.state.view;
      range.value = String(ghosts);
      count.textContent = String(ghosts);
    });
    return h('label', { class: 'view-row', title: t('viewGhostsTitle') }, h('span', {}, t('viewGhosts')), range, count, h('kbd', {}, 'G'));
  }

  private units(): HTMLElement {
    const { store } = this.studio;
    const list = select(t('units'), lengthUnits.map((unit) => [unit, t(`unit_${unit}`)] as const), store.state.lengths, (lengths) => store.set({ lengths }));
    list.dataset['view'] = 'lengths';
    return h('label', { class: 'view-row' }, h('span', {}, t('units')), list);
  }

  private switch(name: Switch, label: string, key: string): HTMLElement {
    const box = h('input', { type: 'checkbox', 'data-view': name, onChange: () => this.set({ [name]: box.checked }) });
    this.updates.push(() => {
      box.checked = this.studio.store.state.view[name];
    });
    return h('label', { class: 'view-row' }, box, h('span', {}, label), h('kbd', {}, key));
  }

  private update(): void {
    for (const update of this.updates) update();
  }

  dispose(): void {
    this.unplace();
    this.end();
  }
}
