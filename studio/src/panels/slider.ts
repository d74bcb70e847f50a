// SPDX-License-Identifier: MIT
// A slider with its number, which is dragged and typed too, and a mark for a value to come back to; logarithmic where asked.
import { h, round } from './dom';
import { NumberInput } from './number_input';

export interface SliderSettings {
  label: string;
  value: number;
  low: number;
  high: number;
  log?: boolean;
  mark?: number; // the search's value
  markTitle?: string;
  unit?: string;
  digits?: number;
  /** With each movement; `drag` is the same for all of one drag. */
  onInput: (value: number, drag: string) => void;
  onEnd?: () => void;
  /** The drag is given up: all is as it was before it. */
  onBack: (drag: string) => void;
  /** What the number is dragged by besides. */
  name: HTMLElement;
}

const kSteps = 1000;
const kLogStep = 0.05; // a twentieth more
let drags = 0;

export class Slider {
  readonly element: HTMLElement;
  readonly range: HTMLInputElement;
  private readonly number: NumberInput;
  private readonly mark: HTMLElement | null;
  private drag = '';
  private held = false;

  constructor(private readonly settings: SliderSettings) {
    const { label, low, high, log, unit, mark, markTitle } = settings;
    this.range = h('input', {
      type: 'range', min: '0', max: String(kSteps), step: '1', 'aria-label': label,
      onPointerdown: () => this.begin(),
      onInput: () => this.moved(),
      onChange: () => this.end(),
    });
    this.number = new NumberInput({
      low, high, log, step: log ? kLogStep : 10 ** -(settings.digits ?? 2), words: (value) => this.text(value), label: unit ? `${label} (${unit})` : label,
      move: (value) => {
        if (!this.held) this.begin();
        this.set(value);
        this.input(value);
      },
      keep: (value) => {
        this.set(value);
        this.input(value);
        this.end();
      },
      back: () => {
        const { drag } = this;
        this.held = false;
        this.drag = '';
        if (drag !== '') settings.onBack(drag);
      },
    }, settings.name);
    this.number.element.classList.add('number');
    this.mark = mark === undefined ? null : h('span', { class: 'mark', title: markTitle ?? '' });
    if (this.mark) this.place(mark!);
    this.element = h('div', { class: 'slider' },
      h('div', { class: 'track' }, this.mark, this.range), this.number.element, h('span', { class: 'unit' }, settings.unit ?? ''));
    this.show(settings.value);
  }

  private place(value: number): void {
    // the thumb's middle runs from 7 px to 7 px before the end
    const share = this.share(value);
    this.mark!.style.left = `calc(${(100 * share).toFixed(2)}% + ${(7 - 14 * share).toFixed(2)}px)`;
  }

  private share(value: number): number {
    const { low, high, log } = this.settings;
    const inside = Math.min(Math.max(value, low), high);
    if (log) return Math.log(inside / low) / Math.log(high / low);
    return high > low ? (inside - low) / (high - low) : 0;
  }

  private get value(): number {
    const { low, high, log } = this.settings;
    const share = Number(this.range.value) / kSteps;
    return log ? low * (high / low) ** share : low + (high - low) * share;
  }

  private text(value: number): string {
    if (this.settings.log) return String(Number(value.toPrecision(3)));
    return round(value, this.settings.digits ?? 2);
  }

  private begin(): void {
    this.held = true;
    this.drag = `${this.settings.label} ${++drags}`;
  }

  private moved(): void {
    const { value } = this;
    this.number.show(value);
    this.tell(value);
    this.input(value);
  }

  private input(value: number): void {
    if (this.drag === '') this.drag = `${this.settings.label} ${++drags}`;
    this.settings.onInput(value, this.drag);
  }

  private tell(value: number): void {
    this.range.setAttribute('aria-valuetext', `${this.text(value)} ${this.settings.unit ?? ''}`.trim());
  }

  private set(value: number): void {
    this.range.value = String(Math.round(this.share(value) * kSteps));
    this.tell(value);
  }

  private end(): void {
    this.held = false;
    this.drag = '';
    this.settings.onEnd?.();
  }

  /** From outside: does not disturb a drag. */
  show(value: number): void {
    if (this.held) return;
    this.set(value);
    this.number.show(value);
  }

  set disabled(disabled: boolean) {
    this.range.disabled = disabled;
    this.number.disabled = disabled;
  }
}
