// SPDX-License-Identifier: MIT
// Things in the way, as numbers: where each is, how large, how turned, and away with it.
import type { Obstacle, Vec3 } from '../../../bindings/wasm/src/types';
import { t } from '../i18n';
import { thingWords } from '../i18n/place_words';
import type { Document } from '../state/model';
import { thingName, thingsOf, withThing, withThingTurned } from '../state/places';
import type { Studio } from '../state/studio';
import { withNewThing, withoutThing } from '../state/things';
import { angles, anglesOf, withAngle } from '../state/turning';
import { button, fill, h, iconButton } from './dom';
import { fieldGroup, NumberField } from './number_field';

const kAxes = ['left', 'up', 'ahead'] as const;
const kFarthest = 10; // m
const kLargest = 10; // m

/** A thing with another number of its place or size. */
function along(document: Document, index: number, field: 'position_m' | 'size_m', axis: number, value: number): Document {
  const now: Vec3 = [...thingsOf(document)[index]?.[field] ?? [0, 0, 0]];
  now[axis] = value;
  return withThing(document, index, { [field]: now });
}

class ThingRow {
  readonly element: HTMLElement;
  private readonly name = h('span');
  private readonly place: readonly NumberField[];
  private readonly size: readonly NumberField[];
  private readonly angles: readonly NumberField[];
  private readonly rounding: NumberField;
  private readonly rings: HTMLInputElement;

  constructor(private readonly studio: Studio, index: number, name: string) {
    const fields = (what: string, field: 'position_m' | 'size_m', low: number, high: number): NumberField[] =>
      kAxes.map((axis, k) => new NumberField(studio, {
        key: `thing ${index} ${what} ${axis}`, label: t(axis), low, high, kind: 'length', change: (document, value) => along(document, index, field, k, value),
      }));
    this.place = fields('place', 'position_m', -kFarthest, kFarthest);
    this.size = fields('size', 'size_m', 0, kLargest);
    this.angles = angles.map(([angle, most], k) => new NumberField(studio, {
      key: `thing ${index} ${angle}`, label: t(angle), low: -most, high: most, kind: { step: 1, digits: 0 },
      change: (document, degrees) => withThingTurned(document, index, withAngle(thingsOf(document)[index]?.rotation_xyzw, k, degrees)),
    }));
    this.rings = h('input', { type: 'checkbox', 'data-key': `thing ${index} rings`, onChange: () => studio.store.set({ rings: this.rings.checked }) });
    this.rounding = new NumberField(studio, {
      key: `thing ${index} rounding`, label: t('rounding'), low: 0, high: kLargest / 2, kind: 'length', change: (document, radius_m) => withThing(document, index, { radius_m }),
    });
    const remove = iconButton('close', `${t('remove')}: ${name}`, () => void studio.settle(withoutThing(studio.document!, index)), { 'data-key': `thing ${index} remove` });
    this.element = h('div', { class: 'goal', role: 'group', 'aria-label': name },
      h('div', { class: 'goal-head' }, this.name, remove),
      h('h4', {}, t('thingPlace')), fieldGroup(t('thingPlace'), this.place),
      h('h4', {}, t('thingSize')), fieldGroup(t('thingSize'), this.size),
      h('h4', {}, t('thingTurn')), fieldGroup(t('thingTurn'), this.angles),
      h('div', { class: 'extras' }, this.rounding.element, h('label', {}, this.rings, t('rings'))));
    this.name.textContent = name;
    this.element.addEventListener('focusin', () => studio.select(thingName(index)));
  }

  update({ position_m, size_m, radius_m = 0, rotation_xyzw }: Obstacle, isSelected: boolean): void {
    this.element.classList.toggle('selected', isSelected);
    this.place.forEach((field, k) => field.show(position_m[k]!));
    this.size.forEach((field, k) => field.show(size_m?.[k] ?? 0));
    anglesOf(rotation_xyzw).forEach((degrees, k) => this.angles[k]!.show(degrees));
    this.rounding.show(radius_m);
    this.rings.checked = this.studio.store.state.rings;
  }
}

export class ThingList {
  readonly element: HTMLElement;
  private readonly list = h('div');
  private readonly clears = h('p', { class: 'quiet' }, t('thingsClear'));
  private readonly add: HTMLButtonElement;
  private rows: ThingRow[] = [];
  private names = '';

  constructor(private readonly studio: Studio) {
    this.add = button(t('addThing'), () => this.addOne(), { 'data-key': 'add thing' });
    this.element = h('section', { class: 'things', 'aria-label': t('things') }, h('h3', {}, t('things')), this.clears, this.list, this.add);
  }

  private addOne(): void {
    const { document } = this.studio;
    if (!document) return;
    const index = thingsOf(document).length;
    void this.studio.settle(withNewThing(document, t('thing')));
    this.studio.select(thingName(index));
  }

  update(document: Document, selected: string): void {
    const things = thingsOf(document);
    const names = things.map((_, index) => thingWords(document, index));
    // rows stay while values change, so that a click that first leaves a field ends where it began
    if (JSON.stringify(names) !== this.names) {
      this.names = JSON.stringify(names);
      this.rows = names.map((name, index) => new ThingRow(this.studio, index, name));
      fill(this.list, ...this.rows.map(({ element }) => element));
    }
    things.forEach((thing, index) => this.rows[index]!.update(thing, selected === thingName(index)));
    this.clears.hidden = things.length === 0;
    this.add.disabled = things.length >= this.studio.facts.ranges.obstacles[1];
  }
}
