// SPDX-License-Identifier: MIT
// A number of the document with its name, as it is typed, dragged and shown.
import { lengths } from '../i18n/lengths';
import type { Document } from '../state/model';
import type { Studio } from '../state/studio';
import { h, round } from './dom';
import { scrubbable } from './scrub';

export interface NumberSettings {
  readonly key: string; // of the element, for tests
  readonly label: string;
  readonly low: number;
  readonly high: number;
  /** A length is in metres and shown in the unit of lengths; another number is as it is, with its step and digits. */
  readonly kind: 'length' | { readonly step: number; readonly digits: number };
  /** The document with another value. */
  readonly change: (document: Document, value: number) => Document;
  /** A value was typed. */
  readonly onTyped?: (value: number) => void;
}

export class NumberField {
  readonly element: HTMLLabelElement;
  private readonly input: HTMLInputElement;
  private readonly times: number; // from the value to the number that is shown
  private readonly digits: number;
  private value = 0;

  constructor(private readonly studio: Studio, private readonly settings: NumberSettings) {
    const { key, label, low, high, kind } = settings;
    const { perMetre, step, digits } = kind === 'length' ? lengths() : { perMetre: 1, ...kind };
    this.times = perMetre;
    this.digits = digits;
    this.input = h('input', {
      type: 'number', min: round(low * perMetre, digits), max: round(high * perMetre, digits), step: String(step), 'data-key': key, onChange: () => this.typed(),
    });
    const name = h('span', {}, label);
    this.element = h('label', {}, name, this.input);
    scrubbable(this.input, name, {
      step,
      begin: () => Number((this.value * perMetre).toFixed(digits)),
      move: (number) => this.try(number),
      end: (number) => void this.settle(this.inside(number)),
      back: () => studio.abandon(),
    });
  }

  private inside(number: number): number {
    return Math.min(Math.max(number / this.times, this.settings.low), this.settings.high);
  }

  private try(number: number): void {
    const { document } = this.studio;
    if (document) void this.studio.attempt(this.settings.change(document, this.inside(number)));
  }

  private settle(value: number): Promise<void> {
    const { document } = this.studio;
    return document ? this.studio.settle(this.settings.change(document, value)) : Promise.resolve();
  }

  private typed(): void {
    const value = this.inside(this.input.value === '' ? NaN : Number(this.input.value));
    if (Number.isNaN(value)) return this.write();
    this.value = value;
    this.write();
    void this.settle(value);
    this.settings.onTyped?.(value);
  }

  private write(): void {
    this.input.value = round(this.value * this.times, this.digits);
  }

  /** Leaves alone what a person is typing, unless it is another number. */
  show(value: number): void {
    if (document.activeElement === this.input && Math.abs(value - this.value) < 1e-9) return;
    this.value = value;
    this.write();
  }
}

/** Fields beside one another, with a name for all. */
export function fieldGroup(label: string, fields: readonly NumberField[]): HTMLElement {
  return h('div', { class: 'axes', role: 'group', 'aria-label': label }, ...fields.map(({ element }) => element));
}
