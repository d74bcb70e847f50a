// SPDX-License-Identifier: MIT
// One effector among the goals: whether it has one, where, how turned, what it holds. Its elements stay while values change, so
// that a click that begins by leaving a field ends on what it began on.
import type { Goal, Quat, Vec3 } from '../../../bindings/wasm/src/types';
import { jointName, t } from '../i18n';
import { chosenCandidate, type Document, goalOf } from '../state/model';
import { leastOf, moved, withGoal } from '../state/places';
import type { Studio } from '../state/studio';
import { isMet, isTurned } from '../state/verdict';
import { kFarthest } from '../view/handles';
import { fill, h, iconButton, round } from './dom';
import { GoalMore } from './goal_more';
import { fieldGroup, NumberField } from './number_field';

const kAxes = ['left', 'up', 'ahead'] as const;

export class GoalRow {
  readonly element: HTMLElement;
  private readonly has: HTMLInputElement;
  private readonly reached = h('span', { class: 'reached' });
  private readonly details = h('div');
  private readonly axes: readonly NumberField[];
  private readonly load: NumberField;
  private readonly passes = h('p', { class: 'quiet' }, t('loadPasses'));
  private readonly turn: HTMLInputElement;
  private readonly rings: HTMLInputElement;
  private readonly ringsLabel: HTMLElement;
  private readonly remove: HTMLElement;
  private readonly more: GoalMore;

  constructor(private readonly studio: Studio, readonly effector: string) {
    const name = jointName(effector);
    const key = (what: string): { 'data-key': string } => ({ 'data-key': `${effector} ${what}` });
    this.has = h('input', {
      type: 'checkbox', ...key('has'), onChange: () => void (this.has.checked ? studio.addGoal(effector) : studio.removeGoal(effector)),
    });
    this.axes = kAxes.map((axis, index) => new NumberField(studio, {
      key: `${effector} ${axis}`, label: t(axis), low: -kFarthest, high: kFarthest, kind: 'length',
      change: (document, value) => this.placed(document, value, index), onKept: (value) => index === 1 && this.tellFloor(value),
    }));
    this.load = new NumberField(studio, {
      key: `${effector} load`, label: t('load'), low: 0, high: studio.facts.ranges.load_kg[1], kind: { step: 0.5, digits: 1 },
      change: (document, value) => this.loaded(document, value),
    });
    this.turn = h('input', { type: 'checkbox', ...key('turn'), onChange: () => this.askRotation() });
    this.rings = h('input', {
      type: 'checkbox', ...key('rings'), onChange: () => studio.store.set({ rings: this.rings.checked }),
    });
    this.ringsLabel = h('label', {}, this.rings, t('rings'));
    this.remove = iconButton('close', `${t('remove')}: ${name}`, () => void studio.removeGoal(effector));
    this.more = new GoalMore(studio, effector);
    this.details.append(
      fieldGroup(name, this.axes),
      h('div', { class: 'extras' },
        effector.endsWith('hand') ? this.load.element : null,
        h('label', {}, this.turn, t('turn')), this.ringsLabel),
      this.passes,
      this.more.element);
    this.element = h('div', { class: 'goal', role: 'group', 'aria-label': name },
      h('div', { class: 'goal-head' }, h('label', {}, this.has, name), this.reached, this.remove), this.details);
    this.element.addEventListener('focusin', () => {
      if (this.goal) studio.select(effector);
    });
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
    this.has.title = this.has.disabled ? t('lastGoal') : '';
    this.details.hidden = goal === undefined;
    this.remove.hidden = goal === undefined || document.goals.length < 2;
    fill(this.reached);
    if (!goal) return;
    goal.position_m.forEach((value, index) => this.axes[index]!.show(value));
    this.load.show(goal.load_kg ?? 0);
    this.passes.hidden = !goal.load_kg;
    this.turn.checked = goal.rotation_xyzw !== undefined;
    this.rings.checked = this.studio.store.state.rings;
    this.ringsLabel.hidden = goal.rotation_xyzw === undefined;
    this.more.update(goal);
    this.showReached(document);
  }

  private showReached(document: Document): void {
    const candidate = chosenCandidate(document);
    const reached = candidate?.summary.reached.find((r) => r.effector === this.effector);
    if (!candidate || !reached) return;
    const { verdict } = candidate.summary;
    const met = isMet(reached.error_mm);
    const turned = isTurned(reached);
    this.reached.className = `reached ${met && turned ? 'good' : 'bad'}`;
    // no goal is met by a motion that nobody can make
    const words = verdict === 'impossible' ? '' : t('reachedBy');
    fill(this.reached, !met ? t('short', { length: reached.error_mm / 1000 }) : turned ? words : t('unturned', { deg: round(reached.rotation_error_deg!, 0) }));
  }

  private placed(document: Document, value: number, index: number): Document {
    const position: Vec3 = [...goalOf(document, this.effector)!.position_m];
    position[index] = value;
    return moved(document, this.effector, position);
  }

  private tellFloor(height: number): void {
    const { document } = this.studio;
    const least = document ? leastOf(document, this.effector) : 0;
    if (height < least) this.studio.tell({ kind: 'text', key: 'onFloor', values: { name: jointName(this.effector), length: least } });
  }

  private loaded(document: Document, kilograms: number): Document {
    const { load_kg: _, ...rest } = goalOf(document, this.effector)!;
    return withGoal(document, kilograms > 0 ? { ...rest, load_kg: kilograms } : rest);
  }

  private askRotation(): void {
    const { document } = this.studio;
    if (!document) return;
    void this.studio.changeGoal(this.effector, (old) => {
      const { rotation_xyzw: _, axis, ...rest } = old; // a rotation in place of an axis
      if (this.turn.checked) return { ...rest, rotation_xyzw: this.rotationNow(document) };
      return axis === undefined ? rest : { ...rest, axis };
    });
  }

  /** How the motion at hand turns the effector, so that asking for a rotation changes nothing at first. */
  private rotationNow(document: Document): Quat {
    const reached = chosenCandidate(document)?.summary.reached.find((r) => r.effector === this.effector);
    return reached?.rotation_xyzw ?? [0, 0, 0, 1];
  }
}
