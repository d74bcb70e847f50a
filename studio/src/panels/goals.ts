// SPDX-License-Identifier: MIT
// The goals as numbers, and how motions for them are searched.
import { t } from '../i18n';
import type { Document, SearchSettings } from '../state/model';
import { effectorsOf } from '../state/start';
import type { Studio } from '../state/studio';
import { withPreset } from '../state/task';
import type { View } from '../view/view';
import { button, fill, h, type Panel, select } from './dom';
import { GoalRow } from './goal_row';

/** Motions of a search: of the preset's own, or a number. */
const kEfforts: Record<string, number | null> = { effortQuick: 600, effortNormal: null, effortThorough: 6000 };
const kDurations = [0.2, 20] as const; // s

export class GoalsPanel implements Panel {
  readonly element: HTMLElement;
  private readonly list = h('div', { class: 'goal-list' });
  private readonly duration: HTMLInputElement;
  private readonly method: HTMLSelectElement;
  private readonly effort: HTMLSelectElement;
  private readonly seed: HTMLInputElement;
  private rows: GoalRow[] = [];
  private character: Document['character'] | null = null;
  private readonly end: () => void;

  constructor(private readonly studio: Studio, private readonly view: View) {
    this.duration = h('input', {
      type: 'number', min: String(kDurations[0]), max: String(kDurations[1]), step: '0.1', placeholder: t('auto'), 'data-key': 'duration',
      onChange: () => this.change({
        duration_s: this.duration.value === '' ? null : Math.min(Math.max(Number(this.duration.value), kDurations[0]), kDurations[1]),
      }),
    });
    this.method = select(t('method'), [['flat', t('flat')], ['human', t('human')]], 'flat', (value) =>
      this.change(withPreset(this.studio.document!.settings, value as SearchSettings['preset'])));
    this.effort = select(t('effort'), (['effortQuick', 'effortNormal', 'effortThorough'] as const).map((key) => [key, t(key)] as const), 'effortNormal', (key) =>
      this.change({ evaluations: kEfforts[key] ?? null }));
    this.seed = h('input', { type: 'text', inputmode: 'numeric', 'data-key': 'seed', onChange: () => this.reseed() });
    this.element = h('div', { class: 'panel' }, h('p', { class: 'quiet' }, t('goalsIntro')), this.list,
      h('div', { class: 'fields' },
        h('label', {}, h('span', {}, t('duration')), this.duration, t('s')),
        h('label', {}, h('span', {}, t('method')), this.method),
        h('label', {}, h('span', {}, t('effort')), this.effort),
        h('label', {}, h('span', {}, t('seedNumber')), this.seed),
        button(t('seed'), () => void studio.searchAgain())));
    this.end = studio.store.subscribe((state, previous) => {
      if (state.document !== previous.document || state.selected !== previous.selected) this.update();
    });
    this.update();
  }

  private change(more: Partial<SearchSettings>): void {
    const { document } = this.studio;
    if (!document) return;
    this.studio.commit({ ...document, settings: { ...document.settings, ...more } });
    void this.studio.search();
  }

  private reseed(): void {
    const text = this.seed.value.trim();
    if (/^\d+$/.test(text) && Number.isSafeInteger(Number(text))) return this.change({ seed: Number(text) });
    this.seed.value = String(this.studio.document?.settings.seed ?? 0);
    this.studio.tell({ kind: 'text', key: 'badSeed', values: { value: text, most: Number.MAX_SAFE_INTEGER } });
  }

  private update(): void {
    const { document } = this.studio;
    if (!document) return;
    if (document.character !== this.character) {
      this.character = document.character;
      this.rows = effectorsOf(document.character).map((effector) => new GoalRow(this.studio, this.view, effector));
      fill(this.list, ...this.rows.map((row) => row.element));
    }
    for (const row of this.rows) row.update(document, this.studio.store.state.selected);
    const { settings, character } = document;
    this.duration.value = settings.duration_s === null ? '' : String(settings.duration_s);
    // the layers of people are those of a whole person
    this.method.options[1]!.hidden = this.method.options[1]!.disabled = ['half_body', 'full_body'].includes(character.spec.source);
    this.method.value = settings.preset;
    this.seed.value = String(settings.seed);
    this.effort.value = Object.keys(kEfforts).find((key) => kEfforts[key] === settings.evaluations) ?? 'effortNormal';
  }

  dispose(): void {
    this.end();
  }
}
