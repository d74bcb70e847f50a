// SPDX-License-Identifier: MIT
// How a goal wants its effector turned, by words or by numbers, and the box about it in which any place will do.
import type { Goal, GoalAxis, Vec3 } from '../../../bindings/wasm/src/types';
import { type Key, t } from '../i18n';
import { goalOf } from '../state/model';
import { withGoal } from '../state/places';
import type { Studio } from '../state/studio';
import { angles, anglesOf, withAngle } from '../state/turning';
import { h, select } from './dom';
import { fieldGroup, NumberField } from './number_field';

const kAxes = ['none', 'palm', 'thumb', 'fingers', 'other'] as const; // of a hand, by words
type Axis = (typeof kAxes)[number];
const kAxisKeys: Readonly<Record<Axis, Key>> = { none: 'axisNone', palm: 'axisPalm', thumb: 'axisThumb', fingers: 'axisFingers', other: 'asInTask' };

const kDirections = ['up', 'down', 'in', 'out', 'ahead', 'back', 'other'] as const;
type Direction = (typeof kDirections)[number];
const kDirectionKeys: Readonly<Record<Direction, Key>> = {
  up: 'facesUp', down: 'facesDown', in: 'facesIn', out: 'facesOut', ahead: 'facesAhead', back: 'facesBack', other: 'asInTask',
};
/** What an axis is asked to do first. */
const kFirst: Readonly<Record<'palm' | 'thumb' | 'fingers', Direction>> = { palm: 'down', thumb: 'up', fingers: 'ahead' };

const kSides = ['left', 'up', 'ahead'] as const;
const kMostTolerance = 0.5; // m: half a side

/** The world's direction that is in or out for a hand. */
function sideways(effector: string, inward: boolean): 'left' | 'right' {
  return effector.startsWith('left') === inward ? 'right' : 'left';
}

function axisOf({ axis }: Goal): Axis {
  if (axis === undefined) return 'none';
  return typeof axis.axis === 'string' ? axis.axis : 'other';
}

function directionOf({ axis, effector }: Goal): Direction {
  if (axis === undefined || typeof axis.direction !== 'string') return 'other';
  if (axis.direction === 'left' || axis.direction === 'right') return axis.direction === sideways(effector, true) ? 'in' : 'out';
  return axis.direction;
}

function inWorld(direction: Direction, { effector, axis }: Goal): GoalAxis['direction'] {
  switch (direction) {
    case 'in': return sideways(effector, true);
    case 'out': return sideways(effector, false);
    case 'other': return axis?.direction ?? 'up';
    default: return direction;
  }
}

/** The goal with one of its angles changed. */
function turned(goal: Goal, index: number, degrees: number): Goal {
  return goal.rotation_xyzw ? { ...goal, rotation_xyzw: withAngle(goal.rotation_xyzw, index, degrees) } : goal;
}

/** The goal with half a side of its box changed; without a box where none is left. */
function widened({ tolerance_m = [0, 0, 0], ...rest }: Goal, index: number, half: number): Goal {
  const tolerance: Vec3 = [...tolerance_m];
  tolerance[index] = half;
  return tolerance.every((side) => side === 0) ? rest : { ...rest, tolerance_m: tolerance };
}

/** A list with one entry that is there only where a task says what the others cannot. */
function choice<Value extends string>(label: Key, keys: Readonly<Record<Value, Key>>, values: readonly Value[], key: string, change: (value: Value) => void): HTMLSelectElement {
  const list = select(t(label), values.map((value) => [value, t(keys[value])] as const), values[0]!, change);
  list.dataset['key'] = key;
  return list;
}

function showChoice(list: HTMLSelectElement, value: string): void {
  list.value = value;
  for (const option of list.options) option.hidden = option.value === 'other' && value !== 'other';
}

export class GoalMore {
  readonly element: HTMLElement;
  private readonly axis: HTMLSelectElement;
  private readonly direction: HTMLSelectElement;
  private readonly facing: HTMLElement;
  private readonly angles: readonly NumberField[];
  private readonly turns: HTMLElement;
  private readonly sides: readonly NumberField[];
  private readonly tolerance: HTMLDetailsElement;
  private goal: Goal | null = null;

  constructor(private readonly studio: Studio, private readonly effector: string) {
    this.axis = choice('facing', kAxisKeys, kAxes, `${effector} axis`, (axis) => this.askAxis(axis));
    this.direction = choice('direction', kDirectionKeys, kDirections, `${effector} direction`, (direction) => this.face(direction));
    this.facing = h('div', { class: 'facing', role: 'group', 'aria-label': t('facing') }, h('span', { 'aria-hidden': 'true' }, t('facing')), this.axis, this.direction);
    this.angles = angles.map(([angle, most], index) => new NumberField(studio, {
      key: `${effector} ${angle}`, label: t(angle), low: -most, high: most, kind: { step: 1, digits: 0 },
      change: (document, degrees) => withGoal(document, turned(goalOf(document, effector)!, index, degrees)),
    }));
    this.turns = fieldGroup(t('turn'), this.angles);
    this.sides = kSides.map((side, index) => new NumberField(studio, {
      key: `${effector} tolerance ${side}`, label: t(side), low: 0, high: kMostTolerance, kind: 'length',
      change: (document, half) => withGoal(document, widened(goalOf(document, effector)!, index, half)),
    }));
    this.tolerance = h('details', { class: 'tolerance' }, h('summary', {}, t('tolerance')), fieldGroup(t('tolerance'), this.sides));
    this.element = h('div', {}, this.facing, this.turns, this.tolerance);
  }

  update(goal: Goal): void {
    if (goal === this.goal) return;
    if (goal.tolerance_m && !this.goal?.tolerance_m) this.tolerance.open = true;
    this.goal = goal;
    const axis = axisOf(goal);
    this.facing.hidden = !this.effector.endsWith('hand') && axis === 'none';
    showChoice(this.axis, axis);
    showChoice(this.direction, directionOf(goal));
    this.direction.hidden = axis === 'none';
    this.turns.hidden = goal.rotation_xyzw === undefined;
    anglesOf(goal.rotation_xyzw).forEach((degrees, index) => this.angles[index]!.show(degrees));
    this.sides.forEach((field, index) => field.show(goal.tolerance_m?.[index] ?? 0));
  }

  /** In place of a rotation. */
  private askAxis(axis: Axis): void {
    void this.studio.changeGoal(this.effector, (old) => {
      const { axis: before, rotation_xyzw: _, ...rest } = old;
      if (axis === 'none') return rest;
      if (axis === 'other') return old;
      return { ...rest, axis: { axis, direction: before?.direction ?? inWorld(kFirst[axis], old) } };
    });
  }

  private face(direction: Direction): void {
    void this.studio.changeGoal(this.effector, (old) => (old.axis ? { ...old, axis: { ...old.axis, direction: inWorld(direction, old) } } : old));
  }
}
