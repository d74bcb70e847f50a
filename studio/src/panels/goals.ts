// SPDX-License-Identifier: MIT
// The goals as numbers: which effectors have one, where, how turned, what is held.
import type { Goal, Quat, Vec3 } from '../../../bindings/wasm/src/types';
import { jointName, t } from '../i18n';
import { chosenCandidate, type Document, goalOf, type SearchSettings } from '../state/model';
import { effectorsOf } from '../state/start';
import type { Studio } from '../state/studio';
import type { View } from '../view/view';
import { button, fill, h, iconButton, type Panel, round, select } from './dom';

const kAxes = [['left', 0], ['up', 1], ['ahead', 2]] as const;
/** Motions of a search: of the preset's own, or a number. */
const kEfforts: Record<string, number | null> = { effortQuick: 600, effortNormal: null, effortThorough: 6000 };

export class GoalsPanel implements Panel {
  readonly element: HTMLElement;
  private readonly list = h('div', { class: 'goal-list' });
  private readonly settings = h('div', { class: 'fields' });
  private readonly end: () => void;

  constructor(private readonly studio: Studio, private readonly view: View) {
    this.element = h('div', { class: 'panel' }, h('p', { class: 'quiet' }, t('goalsIntro')), this.list, this.settings);
    this.end = studio.store.subscribe((state, previous) => {
      if (state.document !== previous.document || state.selected !== previous.selected) this.update();
    });
    this.update();
  }

  private update(): void {
    const { document } = this.studio;
    if (!document) return;
    const focused = (globalThis.document.activeElement as HTMLElement | null)?.dataset['key'];
    fill(this.list, ...effectorsOf(document.character).map((effector) => this.row(document, effector)));
    fill(this.settings, ...this.fields(document));
    if (focused) this.element.querySelector<HTMLElement>(`[data-key="${CSS.escape(focused)}"]`)?.focus();
  }

  private row(document: Document, effector: string): HTMLElement {
    const goal = goalOf(document, effector);
    const name = jointName(effector);
    const box = h('input', {
      type: 'checkbox', checked: goal !== undefined, disabled: goal !== undefined && document.goals.length < 2, 'data-key': `has ${effector}`,
      onChange: () => void (box.checked ? this.studio.addGoal(effector) : this.studio.removeGoal(effector)),
    });
    const head = h('div', { class: 'goal-head' }, h('label', {}, box, name), goal ? this.reached(document, goal) : null);
    const chosen = goal !== undefined && this.studio.store.state.selected === effector;
    const element = h('div', { class: `goal${chosen ? ' selected' : ''}`, role: 'group', 'aria-label': name }, head);
    if (!goal) return element;
    element.addEventListener('focusin', () => this.studio.select(effector));
    element.append(h('div', { class: 'axes' }, ...kAxes.map(([axis, index]) => this.coordinate(goal, axis, index))), this.extras(document, goal));
    return element;
  }

  private coordinate(goal: Goal, axis: 'left' | 'up' | 'ahead', index: 0 | 1 | 2): HTMLElement {
    const input = h('input', {
      type: 'number', step: '0.01', value: round(goal.position_m[index]), 'data-key': `${goal.effector} ${axis}`,
      onChange: () => {
        const place: Vec3 = [...goal.position_m];
        const value = Number(input.value);
        if (!Number.isFinite(value)) return;
        place[index] = index === 1 ? Math.max(value, 0.01) : value;
        void this.studio.dropGoal(goal.effector, place);
      },
    });
    return h('label', {}, h('span', {}, t(axis)), input);
  }

  private reached(document: Document, goal: Goal): HTMLElement | null {
    const reached = chosenCandidate(document)?.summary.reached.find((r) => r.effector === goal.effector);
    if (!reached) return null;
    const good = reached.error_mm <= 1;
    return h('span', { class: good ? 'good' : 'bad' }, good ? t('reachedBy') : t('short', { cm: round(reached.error_mm / 10, 1) }));
  }

  private extras(document: Document, goal: Goal): HTMLElement {
    const load = h('input', {
      type: 'number', min: '0', max: '200', step: '0.5', value: String(goal.load_kg ?? 0), 'data-key': `${goal.effector} load`,
      onChange: () => void this.studio.changeGoal(goal.effector, (old) => {
        const kilograms = Math.min(Math.max(Number(load.value) || 0, 0), 200);
        const { load_kg: _, ...rest } = old;
        return kilograms > 0 ? { ...rest, load_kg: kilograms } : rest;
      }),
    });
    const turned = goal.rotation_xyzw !== undefined;
    const turn = h('input', {
      type: 'checkbox', checked: turned, 'data-key': `${goal.effector} turn`,
      onChange: () => void this.studio.changeGoal(goal.effector, (old) => {
        const { rotation_xyzw: _, ...rest } = old;
        return turn.checked ? { ...rest, rotation_xyzw: this.rotationNow(document, goal.effector) } : rest;
      }),
    });
    const rings = h('input', {
      type: 'checkbox', checked: this.view.rotate, 'data-key': `${goal.effector} rings`,
      onChange: () => {
        this.view.rotate = rings.checked;
        this.view.stage.invalidate();
      },
    });
    return h('div', { class: 'extras' },
      goal.effector.endsWith('hand') ? h('label', {}, t('load'), load, t('kg')) : null,
      h('label', {}, turn, t('turn')), turned ? h('label', {}, rings, t('rings')) : null,
      document.goals.length > 1 ? iconButton('close', `${t('remove')}: ${jointName(goal.effector)}`, () => void this.studio.removeGoal(goal.effector)) : null);
  }

  /** How the motion at hand turns the effector, so that asking for a rotation changes nothing at first. */
  private rotationNow(document: Document, effector: string): Quat {
    const reached = chosenCandidate(document)?.summary.reached.find((r) => r.effector === effector) as Record<string, unknown> | undefined;
    const rotation = reached?.['rotation_xyzw'];
    return Array.isArray(rotation) ? (rotation as Quat) : [0, 0, 0, 1];
  }

  private fields(document: Document): HTMLElement[] {
    const { settings } = document;
    const change = (more: Partial<SearchSettings>): void => {
      this.studio.commit({ ...document, settings: { ...settings, ...more } });
      void this.studio.search();
    };
    const duration = h('input', {
      type: 'number', min: '0.2', max: '20', step: '0.1', value: settings.duration_s === null ? '' : String(settings.duration_s),
      placeholder: t('auto'), 'data-key': 'duration',
      onChange: () => change({ duration_s: duration.value === '' ? null : Math.min(Math.max(Number(duration.value), 0.2), 20) }),
    });
    const layered = document.character.spec.source !== 'half_body' && document.character.spec.source !== 'full_body';
    const method = select(t('method'), layered ? [['flat', t('flat')], ['human', t('human')]] : [['flat', t('flat')]], settings.preset, (value) =>
      change({ preset: value as SearchSettings['preset'] }));
    const now = Object.keys(kEfforts).find((key) => kEfforts[key] === settings.evaluations) ?? 'effortNormal';
    const effort = select(t('effort'), (['effortQuick', 'effortNormal', 'effortThorough'] as const).map((key) => [key, t(key)] as const), now, (key) =>
      change({ evaluations: kEfforts[key] ?? null }));
    return [
      h('label', {}, h('span', {}, t('duration')), duration, t('s')),
      h('label', {}, h('span', {}, t('method')), method),
      h('label', {}, h('span', {}, t('effort')), effort),
      button(t('seed'), () => void this.studio.searchAgain()),
    ];
  }

  dispose(): void {
    this.end();
  }
}
