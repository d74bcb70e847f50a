// SPDX-License-Identifier: MIT
// The legend of the paths' colours, m/s.
import { t } from '../i18n';
import { candidateAt } from '../state/model';
import { speedScale } from '../state/speed';
import type { Studio } from '../state/studio';
import { palettes, shownTheme } from '../view/palette';
import { h, type Panel, round } from './dom';

export class SpeedLegend implements Panel {
  readonly element: HTMLElement;
  private readonly bar = h('i', {});
  private readonly numbers = [h('span', {}), h('span', {}), h('span', {})] as const;
  private readonly scheme = matchMedia('(prefers-color-scheme: dark)');
  private readonly end: () => void;

  constructor(private readonly studio: Studio) {
    this.element = h('div', { class: 'speed-legend', role: 'img' }, h('span', { class: 'speed-title' }, t('viewSpeed')), this.bar,
      h('div', { class: 'speed-numbers' }, ...this.numbers));
    this.end = studio.store.subscribe(this.update);
    this.scheme.addEventListener('change', this.update);
    this.update();
  }

  private readonly update = (): void => {
    const { document, view, theme, dragging, preview } = this.studio.store.state;
    const shown = document && !dragging && !preview ? [document.chosen, document.compared ?? document.chosen] : [];
    const candidates = shown.map((index) => candidateAt(document!, index)).filter((candidate) => candidate !== null);
    this.element.hidden = !view.path || candidates.length === 0;
    if (this.element.hidden) return;
    const most = speedScale(candidates);
    const colours = palettes[shownTheme(theme)].speed.map((colour) => `#${colour.getHexString()}`);
    this.bar.style.background = `linear-gradient(to right, ${colours.join(', ')})`;
    this.numbers.forEach((number, k) => {
      number.textContent = round((most * k) / 2, k === 0 ? 0 : 2).replace(/(\.\d)0$/, '$1');
    });
    this.element.setAttribute('aria-label', t('viewSpeedLabel', { most }));
  };

  dispose(): void {
    this.end();
    this.scheme.removeEventListener('change', this.update);
  }
}
