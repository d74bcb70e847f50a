// SPDX-License-Identifier: MIT
// A slider with its number and a mark for a value to come back to; logarithmic where asked.
import { h, round } from './dom';

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
}

const kSteps = 1000;
let drags = 0;

export class Slider {
  readonly element: HTMLElement;
  readonly range: HTMLInputElement;
  private readonly number: HTMLInputElement;
  private readonly mark: HTMLElement | null;
  private drag = '';
  private held = false;

  constructor(private readonly settings: SliderSettings) {
    const { label, mark, markTitle } = settings;
    this.range = h('input', {
      type: 'range', min: '0', max: String(kSteps), step: '1', 'aria-label': label,
      onPointerdown: () => this.begin(),
      onInput: () => this.moved(),
      onChange: () => this.end(),
    });
    this.number = h('input', {
      type: 'number', class: 'number', step: 'any', 'aria-label': settings.unit ? `${label} (${settings.unit})` : label,
      onChange: () => this.typed(),
    });
    this.mark = mark === undefined ? null : h('span', { class: 'mark', title: markTitle ?? '' });
    if (this.mark) this.place(mark!);
    this.element = h('div', { class: 'slider' },
      h('div', { class: 'track' }, this.mark, this.range), this.number, h('span', { class: 'unit' }, settings.unit ?? ''));
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
    if (this.drag === '') this.drag = `${this.settings.label} ${++drags}`;
    const { value } = this;
    this.number.value = this.text(value);
    this.range.setAttribute('aria-valuetext', `${this.text(value)} ${this.settings.unit ?? ''}`.trim());
    this.settings.onInput(value, this.drag);
  }

  private end(): void {
    this.held = false;
    this.drag = '';
    this.settings.onEnd?.();
  }

  private typed(): void {
    const value = Number(this.number.value);
    if (!Number.isFinite(value) || this.number.value === '') return this.show(this.value);
    const inside = Math.min(Math.max(value, this.settings.low), this.settings.high);
    this.show(inside);
    this.settings.onInput(inside, `${this.settings.label} ${++drags}`);
    this.settings.onEnd?.();
  }

  /** From outside: does not disturb a drag. */
  show(value: number): void {
    if (this.held) return;
    this.range.value = String(Math.round(this.share(value) * kSteps));
    if (document.activeElement !== this.number) this.number.value = this.text(value);
    this.range.setAttribute('aria-valuetext', `${this.text(value)} ${this.settings.unit ?? ''}`.trim());
  }

  set disabled(disabled: boolean) {
    this.range.disabled = disabled;
    this.number.disabled = disabled;
  }
}
