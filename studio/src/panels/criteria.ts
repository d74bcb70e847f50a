// SPDX-License-Identifier: MIT
// What counts: a weight for each criterion, and what the chosen motion pays for it.
import { criterionName, t } from '../i18n';
import { defaultWeights, sameAsDefault, unknownCriteria } from '../state/criteria';
import { chosenCandidate } from '../state/model';
import type { Studio } from '../state/studio';
import { button, h, type Panel, round } from './dom';
import { Slider } from './slider';

export class CriteriaPanel implements Panel {
  readonly element: HTMLElement;
  private readonly atFirst: HTMLButtonElement;
  private readonly rows = new Map<string, { slider: Slider; paid: HTMLElement; bar: HTMLElement }>();
  private readonly end: () => void;

  constructor(private readonly studio: Studio) {
    const rows = Object.entries(defaultWeights).map(([name, weight]) => {
      const slider = new Slider({
        label: criterionName(name), value: weight, low: 0, high: 1, mark: weight, markTitle: t('resetWeights'),
        onInput: (value, drag) => studio.weigh(name, Math.round(value * 100) / 100, drag),
      });
      slider.range.dataset['criterion'] = name;
      const paid = h('span', { class: 'paid' });
      const bar = h('span', { class: 'meter', 'aria-hidden': 'true' });
      this.rows.set(name, { slider, paid, bar });
      return h('div', { class: 'row' }, h('div', { class: 'row-head' }, h('span', { class: 'row-name' }, criterionName(name)), paid, bar), slider.element);
    });
    this.atFirst = button(t('resetWeights'), () => {
      if (studio.document) studio.commit({ ...studio.document, weights: { ...defaultWeights } });
    });
    this.element = h('div', { class: 'panel' }, h('p', { class: 'quiet' }, t('criteriaIntro')),
      h('div', { class: 'buttons' }, button(t('searchAgain'), () => void studio.searchAgain(false), { class: 'primary' }), this.atFirst), ...rows);
    this.end = studio.store.subscribe((state, previous) => {
      if (state.document !== previous.document) this.update();
    });
    this.update();
  }

  private update(): void {
    const { document } = this.studio;
    if (!document) return;
    const candidate = chosenCandidate(document);
    const unknown = new Set(unknownCriteria(document));
    for (const [name, row] of this.rows) {
      row.slider.show(document.weights[name] ?? 0);
      const penalty = candidate?.summary.criteria[name];
      row.paid.textContent = penalty !== undefined ? t('penalty', { value: round(penalty) }) : unknown.has(name) ? t('notScored') : '';
      row.paid.classList.toggle('bad', unknown.has(name));
      row.bar.style.setProperty('--share', String(penalty ?? 0));
    }
    this.atFirst.disabled = sameAsDefault(document.weights);
  }

  dispose(): void {
    this.end();
  }
}
