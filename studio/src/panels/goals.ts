// SPDX-License-Identifier: MIT
// The goals as numbers, and how motions for them are searched.
import type { HabitName } from '../../../bindings/wasm/src/types';
import { engineWord, t } from '../i18n';
import { habitTip } from '../i18n/tips';
import { chosenCandidate, type Document, type SearchSettings } from '../state/model';
import { effectorsOf, jointsOf } from '../state/start';
import type { Studio } from '../state/studio';
import { hasBothHands } from '../state/symmetry';
import { withPreset } from '../state/task';
import type { View } from '../view/view';
import { button, fill, h, type Panel, select } from './dom';
import { GoalRow } from './goal_row';
import { LookRow } from './look_row';
import { NumberInput, writeNumber } from './number_input';
import { LibrarySection } from './library';
import { ThingList } from './things';
import { giveTip } from './tooltip';
import { VerdictBox } from './verdict';

/** How many times as many motions a search scores as the preset would by itself. */
const kEfforts = { effortQuick: 1 / 3, effortNormal: 1, effortThorough: 10 / 3 } as const;
type Effort = keyof typeof kEfforts;
const kSeconds = 0.05; // a step of the duration that is dragged
const efforts = Object.keys(kEfforts) as Effort[];

export class GoalsPanel implements Panel {
  readonly element: HTMLElement;
  private readonly list = h('div', { class: 'goal-list' });
  private readonly rest = h('details', { hidden: true }, h('summary', {}, t('restOfBody')));
  private readonly restList = h('div');
  private readonly symmetric: HTMLInputElement;
  private readonly symmetricLabel: HTMLElement;
  private readonly snap: HTMLInputElement;
  private readonly library: LibrarySection;
  private readonly look: LookRow;
  private readonly things: ThingList;
  private readonly verdict: VerdictBox;
  private readonly duration: NumberInput;
  private readonly method: HTMLSelectElement;
  private readonly habit: HTMLSelectElement;
  private readonly learned = h('option', { value: 'learned' }, t('learned'));
  private readonly effort: HTMLSelectElement;
  private readonly seed: HTMLInputElement;
  private rows: GoalRow[] = [];
  private character: Document['character'] | null = null;
  private effectors = '';
  private goals = 0; // their number
  private readonly end: () => void;

  constructor(private readonly studio: Studio, view: View) {
    const [least, most] = studio.facts.ranges.duration_s;
    const durationName = h('span', { title: t('scrubAbout') }, t('duration'));
    this.duration = new NumberInput({
      key: 'duration', low: least, high: most, step: kSeconds, words: (seconds) => String(Number(seconds.toFixed(3))),
      begin: () => studio.chosen()?.summary.duration_s ?? null,
      keep: (duration_s) => this.change({ duration_s }), empty: () => this.change({ duration_s: null }),
    }, durationName);
    this.duration.element.placeholder = t('auto');
    const presets = studio.facts.presets.map(({ name }) => [name, engineWord('presets', name)] as const);
    this.method = select(t('method'), presets, studio.facts.default_preset, (value) => this.search(value));
    const habits = studio.facts.habits.map(({ name }) => [name, engineWord('habits', name)] as const);
    this.habit = select(t('habit'), habits, habits[0]![0], (name) => this.moveBy(name));
    this.habit.append(this.learned);
    this.effort = select(t('effort'), efforts.map((key) => [key, t(key)] as const), 'effortNormal', (key) =>
      this.change({ evaluations: this.evaluations(this.method.value, key) }));
    this.seed = h('input', { type: 'text', inputmode: 'numeric', 'data-key': 'seed', onChange: () => this.reseed() });
    this.verdict = new VerdictBox(studio);
    this.symmetric = h('input', { type: 'checkbox', 'data-key': 'symmetric', onChange: () => void studio.setSymmetric(this.symmetric.checked) });
    this.symmetricLabel = h('label', {}, this.symmetric, t('symmetric'));
    this.snap = h('input', { type: 'checkbox', 'data-key': 'snap', onChange: () => studio.store.set({ snap: this.snap.checked }) });
    this.library = new LibrarySection(studio, view);
    this.look = new LookRow(studio);
    this.things = new ThingList(studio);
    this.rest.append(this.restList);
    this.element = h('div', { class: 'panel' }, h('p', { class: 'quiet' }, t('goalsIntro')), this.verdict.element,
      h('div', { class: 'goal-ways' }, this.symmetricLabel, h('label', { title: t('snapAbout') }, this.snap, t('snap'))), this.list, this.rest, this.look.element, this.things.element,
      h('div', { class: 'fields' },
        h('label', {}, durationName, this.duration.element, t('s')),
        h('label', {}, h('span', {}, t('method')), this.method),
        this.habitRow(),
        h('label', {}, h('span', {}, t('effort')), this.effort),
        h('label', {}, h('span', {}, t('seedNumber')), this.seed),
        button(t('seed'), () => void studio.searchAgain())),
      this.library.element);
    this.end = studio.store.subscribe((state, previous) => {
      if (state.document !== previous.document || state.undrawn !== previous.undrawn || state.trial !== previous.trial || state.selected !== previous.selected || state.symmetric !== previous.symmetric || state.snap !== previous.snap || state.rings !== previous.rings) this.update();
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

  private habitRow(): HTMLElement {
    const name = h('span', {}, t('habit'));
    const row = h('label', {}, name, this.habit);
    giveTip(row, name, this.habit, () => ({ text: [...this.habit.options].filter(({ hidden }) => !hidden).map(({ value }) => habitTip(value)).join('\n') }));
    return row;
  }

  private moveBy(name: HabitName): void {
    const { habit: _, ...more } = this.studio.document!.settings.more;
    this.change({ more: name === this.studio.facts.habits[0]!.name ? more : { ...more, habit: name } });
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

  /** Rows stay while the same effectors can have goals. */
  private listRows(document: Document): void {
    const { character, goals } = document;
    const first = effectorsOf(character);
    const joints = jointsOf(character);
    // a task may have goals for any joint
    const others = goals.map(({ effector }) => effector).filter((effector) => ![...first, ...joints].includes(effector));
    const rest = [...joints, ...others];
    const effectors = JSON.stringify([first, rest]);
    if (character === this.character && effectors === this.effectors) return;
    this.character = character;
    this.effectors = effectors;
    const rows = (names: readonly string[]): GoalRow[] => names.map((effector) => new GoalRow(this.studio, effector));
    const [ofFirst, ofRest] = [rows(first), rows(rest)];
    this.rows = [...ofFirst, ...ofRest];
    fill(this.list, ...ofFirst.map(({ element }) => element));
    fill(this.restList, ...ofRest.map(({ element }) => element));
    this.rest.hidden = rest.length === 0;
    this.rest.open = goals.some(({ effector }) => rest.includes(effector));
  }

  private update(): void {
    const { trial, document, selected } = this.studio.store.state;
    if (!document) return;
    this.listRows(trial ?? document);
    if (document.goals.length > this.goals && document.goals.some(({ effector }) => !effectorsOf(document.character).includes(effector))) this.rest.open = true;
    this.goals = document.goals.length;
    this.verdict.update(document, chosenCandidate(document));
    for (const row of this.rows) row.update(trial ?? document, selected);
    this.look.update(trial ?? document, selected);
    this.things.update(trial ?? document, selected);
    this.symmetric.checked = this.studio.store.state.symmetric;
    this.symmetricLabel.hidden = !hasBothHands(document);
    this.snap.checked = this.studio.store.state.snap;
    const { settings } = document;
    this.duration.show(settings.duration_s);
    // as people move, or as the task says
    for (const [index, { name, natural }] of this.studio.facts.presets.entries()) {
      this.method.options[index]!.hidden = this.method.options[index]!.disabled = !natural && name !== settings.preset;
      if (name === settings.preset) this.habit.disabled = !natural;
    }
    this.method.value = settings.preset;
    const { habit = this.studio.facts.habits[0]!.name } = settings.more;
    this.learned.hidden = this.learned.disabled = typeof habit === 'string';
    this.habit.value = typeof habit === 'string' ? habit : this.learned.value;
    writeNumber(this.seed, String(settings.seed));
    this.effort.value = this.effortOf(settings) ?? 'effortNormal';
  }

  dispose(): void {
    this.library.dispose();
    this.end();
  }
}
