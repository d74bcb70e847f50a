// SPDX-License-Identifier: MIT
// The criteria: a weight for each criterion, and the chosen motion's penalty.
import { engineWord, t } from '../i18n';
import { ownMixture, sameWeights, unknownCriteria, type Weights } from '../state/criteria';
import { chosenCandidate } from '../state/model';
import type { Studio } from '../state/studio';
import { button, fill, h, type Panel, round } from './dom';
import { Slider } from './slider';
import { tipOfCriterion } from './slider_tips';
import { giveTip } from './tooltip';

export class CriteriaPanel implements Panel {
  readonly element: HTMLElement;
  private readonly atFirst: HTMLButtonElement;
  private readonly list = h('div');
  private readonly rows = new Map<string, { slider: Slider; paid: HTMLElement; bar: HTMLElement }>();
  private own: Weights | null = null; // which the sliders have marks at
  private readonly end: () => void;

  constructor(private readonly studio: Studio) {
    this.atFirst = button(t('resetWeights'), () => {
      if (studio.document && this.own) studio.commit({ ...studio.document, weights: { ...this.own } });
    });
    this.element = h('div', { class: 'panel' }, h('p', { class: 'quiet' }, t('criteriaIntro')),
      h('div', { class: 'buttons' }, button(t('searchAgain'), () => void studio.searchAgain(false), { class: 'primary' }), this.atFirst), this.list);
    this.end = studio.store.subscribe((state, previous) => {
      if (state.document !== previous.document) this.update();
    });
    this.update();
  }

  /** Those that the mixture weighs stand first. */
  private build(own: Weights): void {
    this.own = own;
    this.rows.clear();
    const names = this.studio.facts.criteria.map(({ name }) => name);
    const counts = (name: string): boolean => (own[name] ?? 0) > 0;
    fill(this.list, ...[...names.filter(counts), ...names.filter((name) => !counts(name))].map((name) => this.row(name, own[name] ?? 0)));
  }

  private row(name: string, weight: number): HTMLElement {
    const label = h('span', { class: 'row-name' }, engineWord('criteria', name));
    const slider = new Slider({
      label: engineWord('criteria', name), name: label, value: weight, low: 0, high: Math.max(1, weight), mark: weight, markTitle: t('resetWeights'),
      onInput: (value, drag) => this.studio.weigh(name, Math.round(value * 100) / 100, drag),
      onBack: (drag) => this.studio.takeBackWeight(drag),
    });
    slider.range.dataset['criterion'] = name;
    const paid = h('span', { class: 'paid' });
    const bar = h('span', { class: 'meter', 'aria-hidden': 'true' });
    this.rows.set(name, { slider, paid, bar });
    const row = h('div', { class: 'row' }, h('div', { class: 'row-head' }, label, paid, bar), slider.element);
    giveTip(row, label, slider.range, () => tipOfCriterion(this.studio, name));
    return row;
  }

  private update(): void {
    const { document } = this.studio;
    if (!document) return;
    const own = ownMixture(this.studio.facts, document);
    if (own !== this.own) this.build(own);
    const candidate = chosenCandidate(document);
    const unknown = new Set(unknownCriteria(document));
    for (const [name, row] of this.rows) {
      row.slider.show(document.weights[name] ?? 0);
      const penalty = candidate?.summary.criteria[name];
      row.paid.textContent = penalty !== undefined ? t('penalty', { value: round(penalty) }) : unknown.has(name) ? t('notScored') : '';
      row.paid.classList.toggle('bad', unknown.has(name));
      row.bar.style.setProperty('--share', String(penalty ?? 0));
    }
    this.atFirst.disabled = sameWeights(document.weights, own);
  }

  dispose(): void {
    this.end();
  }
}
