// SPDX-License-Identifier: MIT
// How tall, how heavy and how strong the body is.
import type { CharacterSpec } from '../../../bindings/wasm/src/types';
import { engineWord, t } from '../i18n';
import { lengths, statureWords } from '../i18n/lengths';
import type { Document } from '../state/model';
import { isRobot } from '../state/start';
import type { Studio } from '../state/studio';
import { h, select } from './dom';
import { NumberInput } from './number_input';

const kChair = 0.26; // statures: the height of a seat at first

interface Measure {
  readonly label: string;
  readonly unit: string;
  readonly step: number;
  readonly key: string;
  readonly value: number;
  readonly range: readonly [number, number];
  readonly apply: (value: number) => void;
}

/** A field for a number; one out of range is reported and has no effect. */
function field(studio: Studio, { label, unit, step, key, value, range: [low, high], apply }: Measure): HTMLElement {
  const words = (number: number): string => String(Number(number.toFixed(1)));
  const name = h('span', { title: t('scrubAbout') }, label);
  const input = new NumberInput({
    key, low, high, step, words, keep: apply,
    outside: (typed) => studio.tell({ kind: 'text', key: 'badRange', values: { what: label, low: words(low), high: words(high), unit, value: typed } }),
  }, name);
  input.show(value);
  return h('label', {}, name, input.element, unit);
}

/** The fields of a character's measures; `change` opens it anew with others. */
export function measures(
  studio: Studio, { spec, description, bytes }: Document['character'], change: (more: Partial<CharacterSpec>) => void,
): HTMLElement | null {
  if (isRobot(description)) return null;
  const { ranges, sexes } = studio.facts;
  const { name: unit, perMetre, step } = lengths();
  const sex = select(t('sex'), sexes.map((name) => [name, engineWord('sexes', name)] as const), spec.sex ?? sexes[0]!, (value) =>
    change({ sex: value as NonNullable<CharacterSpec['sex']> }));
  const seated = h('input', {
    type: 'checkbox', checked: spec.seat_m !== undefined, 'data-key': 'seated',
    // heels can lift only for a standing person
    onChange: () => change(seated.checked ? { seat_m: kChair * description.stature_m, heels: undefined } : { seat_m: undefined }),
  });
  const seat = spec.seat_m === undefined ? null : field(studio, {
    label: t('seat'), unit, step, key: 'seat', value: perMetre * spec.seat_m,
    range: [perMetre * ranges.seat_m[0], perMetre * ranges.seat_m[1]], apply: (value) => change({ seat_m: value / perMetre }),
  });
  const heels = h('input', { type: 'checkbox', checked: spec.heels === true, onChange: () => change({ heels: heels.checked }) });
  const stature = field(studio, {
    label: t('stature'), unit: unit === 'cm' ? unit : `${unit} (${statureWords(description.stature_m)})`, step, key: 'stature', value: perMetre * description.stature_m,
    range: [perMetre * ranges.stature_m[0], perMetre * ranges.stature_m[1]],
    apply: (value) => change({ stature_m: value / perMetre }),
  });
  const mass = field(studio, {
    label: t('mass'), unit: t('kg'), step: 1, key: 'mass', value: description.mass_kg, range: ranges.mass_kg, apply: (value) => change({ mass_kg: value }),
  });
  const guessed = description.stature_guessed === true;
  return h('div', { class: guessed ? 'fields asked' : 'fields' },
    guessed ? h('p', {}, t('statureGuessed', { stature: statureWords(description.stature_m) })) : null, stature, mass, h('label', {}, h('span', {}, t('sex')), sex),
    h('label', { class: 'check' }, seated, t('seated')), seat,
    spec.seat_m === undefined && (spec.source === 'human' || bytes) ? h('label', { class: 'check' }, heels, t('heels')) : null);
}
