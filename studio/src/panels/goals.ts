// SPDX-License-Identifier: MIT
// The goals as numbers, and how motions for them are searched.
import { engineWord, t } from '../i18n';
import type { Library } from '../kept/library';
import { chosenCandidate, type Document, type SearchSettings } from '../state/model';
import { effectorsOf } from '../state/start';
import type { Studio } from '../state/studio';
import { withPreset } from '../state/task';
import type { View } from '../view/view';
import { button, fill, h, type Panel, select } from './dom';
import { GoalRow } from './goal_row';
import { LibrarySection } from './library';
import { ThingList } from './things';
import { VerdictBox } from './verdict';

/** How many times as many motions a search scores as the preset would by itself. */
const kEfforts = { effortQuick: 1 / 3, effortNormal: 1, effortThorough: 10 / 3 } as const;
type Effort = keyof typeof kEfforts;
const efforts = Object.keys(kEfforts) as Effort[];

export class GoalsPanel implements Panel {
  readonly element: HTMLElement;
  private readonly list = h('div', { class: 'goal-list' });
  private readonly things: ThingList;
  private readonly verdict: VerdictBox;
  private readonly duration: HTMLInputElement;
  private readonly method: HTMLSelectElement;
  private readonly effort: HTMLSelectElement;
  private readonly seed: HTMLInputElement;
  private rows: GoalRow[] = [];
  private character: Document['character'] | null = null;
  private readonly end: () => void;

  constructor(private readonly studio: Studio, private readonly view: View, library: Library) {
    const [least, most] = studio.facts.ranges.duration_s;
    this.duration = h('input', {
      type: 'number', min: String(least), max: String(most), step: '0.1', placeholder: t('auto'), 'data-key': 'duration',
      onChange: () => this.change({
        duration_s: this.duration.value === '' ? null : Math.min(Math.max(Number(this.duration.value), least), most),
      }),
    });
    const presets = studio.facts.presets.map(({ name }) => [name, engineWord('presets', name)] as const);
    this.method = select(t('method'), presets, studio.facts.default_preset, (value) => this.search(value));
    this.effort = select(t('effort'), efforts.map((key) => [key, t(key)] as const), 'effortNormal', (key) =>
      this.change({ evaluations: this.evaluations(this.method.value, key) }));
    this.seed = h('input', { type: 'text', inputmode: 'numeric', 'data-key': 'seed', onChange: () => this.reseed() });
    this.verdict = new VerdictBox(studio);
    this.things = new ThingList(studio);
    this.element = h('div', { class: 'panel' }, h('p', { class: 'quiet' }, t('goalsIntro')), this.verdict.element, this.list, this.things.element,
      h('div', { class: 'fields' },
        h('label', {}, h('span', {}, t('duration')), this.duration, t('s')),
        h('label', {}, h('span', {}, t('method')), this.method),
        h('label', {}, h('span', {}, t('effort')), this.effort),
        h('label', {}, h('span', {}, t('seedNumber')), this.seed),
        button(t('seed'), () => void studio.searchAgain())),
      new LibrarySection(studio, view, library).element);
    this.end = studio.store.subscribe((state, previous) => {
      if (state.document !== previous.document || state.trial !== previous.trial || state.selected !== previous.selected) this.update();
    });
    this.update();
  }

  private change(more: Partial<SearchSettings>): void {
    const { document } = this.studio;
    if (!document) return;
    this.studio.commit({ ...document, settings: { ...document.settings, ...more } });
    void this.studio.search();
  }

  /** By another preset, with the same effort. */
  private search(preset: SearchSettings['preset']): void {
    const { settings } = this.studio.document!;
    const effort = this.effortOf(settings);
    this.change({ ...withPreset(settings, preset), evaluations: effort ? this.evaluations(preset, effort) : settings.evaluations });
  }

  /** Motions that a search scores; null: as the preset has it. */
  private evaluations(preset: string, effort: Effort): number | null {
    const { presets, ranges } = this.studio.facts;
    const own = presets.find(({ name }) => name === preset);
    if (effort === 'effortNormal' || !own) return null;
    return Math.max(Math.round(own.evaluations * kEfforts[effort]), ranges.evaluations[0]);
  }

  private effortOf({ preset, evaluations }: SearchSettings): Effort | undefined {
    return efforts.find((effort) => this.evaluations(preset, effort) === evaluations);
  }

  private reseed(): void {
    const text = this.seed.value.trim();
    if (/^\d+$/.test(text) && Number.isSafeInteger(Number(text))) return this.change({ seed: Number(text) });
    this.seed.value = String(this.studio.document?.settings.seed ?? 0);
    this.studio.tell({ kind: 'text', key: 'badSeed', values: { value: text, most: Number.MAX_SAFE_INTEGER } });
  }

  private update(): void {
    const { trial, document, selected } = this.studio.store.state;
    if (!document) return;
    if (document.character !== this.character) {
      this.character = document.character;
      this.rows = effectorsOf(document.character).map((effector) => new GoalRow(this.studio, this.view, effector));
      fill(this.list, ...this.rows.map((row) => row.element));
    }
    this.verdict.update(document, chosenCandidate(document));
    for (const row of this.rows) row.update(trial ?? document, selected);
    this.things.update(trial ?? document, selected);
    const { settings } = document;
    this.duration.value = settings.duration_s === null ? '' : String(settings.duration_s);
    // as people move, or as the task says
    for (const [index, { name, natural }] of this.studio.facts.presets.entries()) {
      this.method.options[index]!.hidden = this.method.options[index]!.disabled = !natural && name !== settings.preset;
    }
    this.method.value = settings.preset;
    this.seed.value = String(settings.seed);
    this.effort.value = this.effortOf(settings) ?? 'effortNormal';
  }

  dispose(): void {
    this.end();
  }
}
