// SPDX-License-Identifier: MIT
// A number with its name, as it is typed and shown.
import { h, round } from './dom';

export interface NumberSettings {
  readonly key: string; // of the element, for tests
  readonly label: string;
  readonly low: number;
  readonly high: number;
  readonly step: number;
  readonly digits: number;
  readonly times?: number; // the factor from the value to the number that is shown; 1 when not given
  readonly onChange: (value: number) => void;
}

export class NumberField {
  readonly element: HTMLLabelElement;
  private readonly input: HTMLInputElement;
  private value = 0;

  constructor(private readonly settings: NumberSettings) {
    const { key, label, low, high, step } = settings;
    this.input = h('input', {
      type: 'number', min: String(low * this.times), max: String(high * this.times), step: String(step), 'data-key': key, onChange: () => this.typed(),
    });
    this.element = h('label', {}, h('span', {}, label), this.input);
  }

  private get times(): number {
    return this.settings.times ?? 1;
  }

  private typed(): void {
    const { low, high, onChange } = this.settings;
    const number = this.input.value === '' ? NaN : Number(this.input.value);
    const value = Math.min(Math.max(number / this.times, low), high);
    if (Number.isNaN(value)) return this.write();
    this.value = value;
    this.write();
    onChange(value);
  }

  private write(): void {
    this.input.value = round(this.value * this.times, this.settings.digits);
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
