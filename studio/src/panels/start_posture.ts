// SPDX-License-Identifier: MIT
// The posture that a file's person starts from: as they rest, or a frame of one of the file's motions.
import type { CharacterSpec } from '../../../bindings/wasm/src/types';
import { t } from '../i18n';
import type { Document } from '../state/model';
import { h, select } from './dom';
import { NumberInput, withDigits } from './number_input';

type Change = (more: Pick<CharacterSpec, 'animation' | 'frame'>) => void;

const kRate = 60; // Hz, of a glTF file's frames

/** What can be chosen, each with what it makes of the spec. */
type Choice = readonly [text: string, asked: Pick<CharacterSpec, 'animation' | 'frame'>];

/** Where the person stands as the file shows them, at rest, and each animation of glTF or a frame of BVH. */
function choicesOf(animations: readonly string[]): Choice[] {
  const always: Choice[] = [[t('startAuto'), {}], [t('startRest'), { frame: 'rest' }]];
  if (animations.length === 0) return [...always, [t('startFrame'), { frame: 0 }]];
  const isOnly = (name: string): boolean => animations.filter((other) => other === name).length === 1;
  return [...always, ...animations.map((name, index): Choice => [name, { animation: isOnly(name) ? name : String(index), frame: 0 }])];
}

function chosenOf(choices: readonly Choice[], { animation, frame }: CharacterSpec): number {
  const found = choices.findIndex(([, asked]) => asked.animation === animation && typeof asked.frame === typeof frame);
  return Math.max(found, 0);
}

/** Nothing where the file has one posture alone. */
export function startPosture({ spec, description }: Document['character'], change: Change): HTMLElement | null {
  const { animations = [], frames = 0 } = description;
  if (animations.length === 0 && frames === 0) return null;
  const choices = choicesOf(animations);
  const now = chosenOf(choices, spec);
  const choice = select(t('startPosture'), choices.map(([text], index) => [String(index), text] as const), String(now), (index) =>
    change({ animation: undefined, frame: undefined, ...choices[Number(index)]![1] }));
  choice.dataset['key'] = 'start posture';
  return h('div', { class: 'fields' }, h('label', {}, h('span', {}, t('startPosture')), choice),
    typeof spec.frame === 'number' && frames > 1 ? frameField(spec, frames, animations.length > 0, change) : null);
}

function frameField({ animation, frame }: CharacterSpec, frames: number, timed: boolean, change: Change): HTMLElement {
  const last = frames - 1;
  const text = (value: number): string => (timed ? t('seconds', { t: (value / kRate).toFixed(2) }) : `/ ${last}`);
  const time = h('span', { class: 'quiet' }, text(Number(frame)));
  const range = h('input', { type: 'range', min: '0', max: String(last), step: '1', value: String(frame), 'aria-label': t('frame') });
  const show = (value: number): void => {
    range.value = String(value);
    number.show(value);
    time.textContent = text(value);
  };
  const take = (value: number): void => {
    show(Math.round(value));
    change({ animation, frame: Math.round(value) });
  };
  const name = h('span', { title: t('scrubAbout') }, t('frame'));
  const number = new NumberInput({
    low: 0, high: last, step: 1, words: withDigits(0), label: t('frame'), key: 'frame', keep: take, back: () => show(Number(frame)),
    move: (value) => {
      range.value = String(Math.round(value));
      time.textContent = text(Math.round(value));
    },
  }, name);
  show(Number(frame));
  range.addEventListener('input', () => show(Number(range.value)));
  range.addEventListener('change', () => take(Number(range.value)));
  return h('div', { class: 'frame' }, name, range, number.element, time);
}
