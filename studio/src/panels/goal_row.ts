// SPDX-License-Identifier: MIT
// One effector among the goals: whether it has one, where, how turned, what it holds. Its elements stay while values change, so
// that a click that begins by leaving a field ends on what it began on.
import type { Goal, Quat, Vec3 } from '../../../bindings/wasm/src/types';
import { jointName, t } from '../i18n';
import { leastHeight } from '../state/floor';
import { chosenCandidate, type Document, goalOf } from '../state/model';
import type { Studio } from '../state/studio';
import { isMet } from '../state/verdict';
import { kFarthest } from '../view/handles';
import type { View } from '../view/view';
import { fill, h, iconButton, round } from './dom';

const kAxes = ['left', 'up', 'ahead'] as const;

export class GoalRow {
  readonly element: HTMLElement;
  private readonly has: HTMLInputElement;
  private readonly reached = h('span');
  private readonly details = h('div');
  private readonly axes: readonly HTMLInputElement[];
  private readonly load: HTMLInputElement;
  private readonly turn: HTMLInputElement;
  private readonly rings: HTMLInputElement;
  private readonly ringsLabel: HTMLElement;
  private readonly remove: HTMLElement;

  constructor(private readonly studio: Studio, private readonly view: View, readonly effector: string) {
    const name = jointName(effector);
    const key = (what: string): { 'data-key': string } => ({ 'data-key': `${effector} ${what}` });
    this.has = h('input', {
      type: 'checkbox', ...key('has'), onChange: () => void (this.has.checked ? studio.addGoal(effector) : studio.removeGoal(effector)),
    });
    this.axes = kAxes.map((axis, index) => {
      const input = h('input', { type: 'number', step: '0.01', ...key(axis), onChange: () => this.place(input, index) });
      return input;
    });
    this.load = h('input', { type: 'number', min: '0', max: String(this.mostLoad), step: '0.5', ...key('load'), onChange: () => this.hold() });
    this.turn = h('input', { type: 'checkbox', ...key('turn'), onChange: () => this.askRotation() });
    this.rings = h('input', {
      type: 'checkbox', ...key('rings'), onChange: () => {
        view.rotate = this.rings.checked;
        view.stage.invalidate();
      },
    });
    this.ringsLabel = h('label', {}, this.rings, t('rings'));
    this.remove = iconButton('close', `${t('remove')}: ${name}`, () => void studio.removeGoal(effector));
    this.details.append(
      h('div', { class: 'axes' }, ...kAxes.map((axis, index) => h('label', {}, h('span', {}, t(axis)), this.axes[index]))),
      h('div', { class: 'extras' },
        effector.endsWith('hand') ? h('label', {}, t('load'), this.load, t('kg')) : null,
        h('label', {}, this.turn, t('turn')), this.ringsLabel, this.remove));
    this.element = h('div', { class: 'goal', role: 'group', 'aria-label': name },
      h('div', { class: 'goal-head' }, h('label', {}, this.has, name), this.reached), this.details);
    this.element.addEventListener('focusin', () => {
      if (this.goal) studio.select(effector);
    });
  }

  private get mostLoad(): number { // kg
    return this.studio.facts.ranges.load_kg[1];
  }

  private get goal(): Goal | undefined {
    const { document } = this.studio;
    return document === null ? undefined : goalOf(document, this.effector);
  }

  update(document: Document, selected: string): void {
    const goal = goalOf(document, this.effector);
    this.element.classList.toggle('selected', goal !== undefined && selected === this.effector);
    this.has.checked = goal !== undefined;
    this.has.disabled = goal !== undefined && document.goals.length < 2;
    this.details.hidden = goal === undefined;
    fill(this.reached);
    if (!goal) return;
    goal.position_m.forEach((value, index) => show(this.axes[index]!, round(value)));
    show(this.load, String(goal.load_kg ?? 0));
    this.turn.checked = goal.rotation_xyzw !== undefined;
    this.rings.checked = this.view.rotate;
    this.ringsLabel.hidden = goal.rotation_xyzw === undefined;
    this.remove.hidden = document.goals.length < 2;
    this.showReached(document);
  }

  private showReached(document: Document): void {
    const candidate = chosenCandidate(document);
    const reached = candidate?.summary.reached.find((r) => r.effector === this.effector);
    if (!candidate || !reached) return;
    const { verdict } = candidate.summary;
    const met = isMet(reached.error_mm);
    this.reached.className = !met || verdict === 'impossible' ? 'bad' : verdict === 'strains' ? 'hard' : 'good';
    const words = verdict === 'impossible' ? t('impossible') : t(verdict === 'strains' ? 'metHard' : 'reachedBy');
    fill(this.reached, met ? words : t('short', { cm: round(reached.error_mm / 10, 1) }));
  }

  private place(input: HTMLInputElement, index: number): void {
    const { goal } = this;
    if (!goal) return;
    const position: Vec3 = [...goal.position_m];
    if (input.value === '') return show(input, round(position[index]!), true);
    position[index] = Math.min(Math.max(Number(input.value), -kFarthest), kFarthest);
    void this.studio.dropGoal(this.effector, position);
    const { document } = this.studio;
    const least = document === null ? 0 : leastHeight(document.character, this.effector, goal.rotation_xyzw);
    if (position[1] < least) this.studio.tell({ kind: 'text', key: 'onFloor', values: { name: jointName(this.effector), m: least.toFixed(3) } });
  }

  private hold(): void {
    void this.studio.changeGoal(this.effector, (old) => {
      const kilograms = Math.min(Math.max(Number(this.load.value) || 0, 0), this.mostLoad);
      const { load_kg: _, ...rest } = old;
      return kilograms > 0 ? { ...rest, load_kg: kilograms } : rest;
    });
  }

  private askRotation(): void {
    const { document } = this.studio;
    if (!document) return;
    void this.studio.changeGoal(this.effector, (old) => {
      const { rotation_xyzw: _, ...rest } = old;
      return this.turn.checked ? { ...rest, rotation_xyzw: this.rotationNow(document) } : rest;
    });
  }

  /** How the motion at hand turns the effector, so that asking for a rotation changes nothing at first. */
  private rotationNow(document: Document): Quat {
    const reached = chosenCandidate(document)?.summary.reached.find((r) => r.effector === this.effector);
    return reached?.rotation_xyzw ?? [0, 0, 0, 1];
  }
}

/** Leaves alone what a person is typing, unless told. */
function show(input: HTMLInputElement, value: string, always = false): void {
  if (always || document.activeElement !== input || Number(input.value) !== Number(value)) input.value = value;
}
