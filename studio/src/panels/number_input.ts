// SPDX-License-Identifier: MIT
// The field of a number, as it is typed, dragged and shown; what the number is of, others know.
import { h, round } from './dom';
import { scrubbable } from './scrub';

export interface NumberInputSettings {
  readonly low: number;
  readonly high: number;
  readonly step: number; // of a drag and of the arrow keys; of a logarithmic number, a share
  readonly log?: boolean;
  /** The number as the field says it. */
  readonly words: (value: number) => string;
  readonly key?: string; // of the element, for tests
  readonly label?: string; // for screen readers, where no name stands in a label with it
  /** Where a drag of an empty field begins; null: there is none. */
  readonly begin?: () => number | null;
  /** With each movement of a drag, after which `keep` or `back` comes. */
  readonly move?: (value: number) => void;
  readonly keep: (value: number) => void;
  readonly back?: () => void;
  /** A number out of range was typed; without this the nearest one inside is taken. */
  readonly outside?: (typed: string) => void;
  /** The field was emptied; without this the number comes back. */
  readonly empty?: () => void;
}

export const isNumberField = (target: EventTarget | null): target is HTMLInputElement =>
  target instanceof HTMLInputElement && (target.type === 'number' || target.inputMode === 'numeric');

/** Shows a number that is the document's, beside which `isBeingTyped` sees one that is not yet. */
export function writeNumber(field: HTMLInputElement, text: string): void {
  field.value = field.defaultValue = text;
}

export const isBeingTyped = ({ value, defaultValue }: HTMLInputElement): boolean => value !== defaultValue;

export class NumberInput {
  readonly element: HTMLInputElement;
  private value: number | null = null;
  private held = false;

  constructor(private readonly settings: NumberInputSettings, name?: HTMLElement) {
    const { low, high, step, log, key, label } = settings;
    this.element = h('input', {
      type: 'number', min: settings.words(low), max: settings.words(high), step: log ? 'any' : String(step), 'data-key': key, 'aria-label': label, onChange: () => this.typed(),
    });
    const to = (value: number): number => (log ? Math.log(value) : value);
    const from = (value: number): number => (log ? Math.exp(value) : value);
    scrubbable(name ? [this.element, name] : [this.element], {
      step, low: to(low), high: to(high),
      begin: () => {
        const value = this.value === null ? (settings.begin?.() ?? null) : Number(settings.words(this.value));
        return value === null || this.element.disabled ? null : to(value);
      },
      move: (value) => {
        this.held = true;
        this.element.value = settings.words(from(value));
        settings.move?.(from(value));
      },
      end: (value) => {
        this.held = false;
        this.value = from(value);
        this.write();
        settings.keep(this.value);
      },
      back: () => {
        this.held = false;
        this.write();
        settings.back?.();
      },
    });
  }

  private typed(): void {
    const { low, high, outside, empty, keep } = this.settings;
    const text = this.element.value;
    if (text === '' && empty) {
      this.value = null;
      return empty();
    }
    const typed = text === '' ? NaN : Number(text);
    if (outside && !(typed >= low && typed <= high)) {
      this.write();
      return outside(text);
    }
    if (!Number.isFinite(typed)) return this.write();
    this.value = Math.min(Math.max(typed, low), high);
    this.write();
    keep(this.value);
  }

  private write(): void {
    writeNumber(this.element, this.value === null ? '' : this.settings.words(this.value));
  }

  /** Leaves alone what a person is dragging, and what is being typed, unless it is another number. */
  show(value: number | null): void {
    const isSame = value === null || this.value === null ? value === this.value : Math.abs(value - this.value) < 1e-9;
    if (isSame && document.activeElement === this.element) return;
    this.value = value;
    if (!this.held) this.write();
  }

  set disabled(disabled: boolean) {
    this.element.disabled = disabled;
  }
}

/** The words of numbers, with the same number of digits after each point. */
export function withDigits(digits: number): (value: number) => string {
  return (value) => round(value, digits);
}
