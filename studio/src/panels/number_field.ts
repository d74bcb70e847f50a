// SPDX-License-Identifier: MIT
// A number of the document with its name: the body follows a drag, and what is typed or let go of is a step.
import { t } from '../i18n';
import { lengths } from '../i18n/lengths';
import type { Document } from '../state/model';
import type { Studio } from '../state/studio';
import { h } from './dom';
import { NumberInput, withDigits } from './number_input';

export interface NumberSettings {
  readonly key: string; // of the element, for tests
  readonly label: string;
  readonly low: number;
  readonly high: number;
  /** A length is in metres and shown in the unit of lengths; another number is as it is, with its step and digits. */
  readonly kind: 'length' | { readonly step: number; readonly digits: number };
  /** The document with another value. */
  readonly change: (document: Document, value: number) => Document;
  /** A value is kept. */
  readonly onKept?: (value: number) => void;
}

export class NumberField {
  readonly element: HTMLLabelElement;
  private readonly input: NumberInput;
  private readonly times: number; // from the value to the number that is shown

  constructor(studio: Studio, { key, label, low, high, kind, change, onKept }: NumberSettings) {
    const { perMetre, step, digits } = kind === 'length' ? lengths() : { perMetre: 1, ...kind };
    this.times = perMetre;
    const name = h('span', { title: t('scrubAbout') }, label);
    this.input = new NumberInput({
      key, step, low: low * perMetre, high: high * perMetre, words: withDigits(digits),
      move: (number) => {
        if (studio.document) void studio.attempt(change(studio.document, number / perMetre));
      },
      keep: (number) => {
        if (studio.document) void studio.settle(change(studio.document, number / perMetre));
        onKept?.(number / perMetre);
      },
      back: () => studio.abandon(),
    }, name);
    this.element = h('label', {}, name, this.input.element);
  }

  show(value: number): void {
    this.input.show(value * this.times);
  }
}

/** Fields beside one another, with a name for all. */
export function fieldGroup(label: string, fields: readonly NumberField[]): HTMLElement {
  return h('div', { class: 'axes', role: 'group', 'aria-label': label }, ...fields.map(({ element }) => element));
}
