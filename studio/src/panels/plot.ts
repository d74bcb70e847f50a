// SPDX-License-Identifier: MIT
// One plot over time: lines, levels, and the time that is shown, which follows the pointer.
import { h, round } from './dom';

export interface Curve {
  label: string;
  values: Float64Array; // a value a frame
}

export interface PlotData {
  times: Float64Array; // s
  curves: readonly Curve[];
  low: number;
  high: number;
  levels: readonly { value: number; label: string }[];
  digits?: number;
  unit?: string;
}

const kHeight = 118; // px
const kLeft = 34;
const kBottom = 14;
const kTop = 6;
const kColours = 5; // --plot-1 …

export class Plot {
  readonly element: HTMLElement;
  private readonly canvas: HTMLCanvasElement;
  private readonly legend = h('div', { class: 'legend' });
  private data: PlotData | null = null;

  constructor(readonly title: string, private readonly onTime: (time: number) => void) {
    this.canvas = h('canvas', { class: 'plot', role: 'img', 'aria-label': title });
    this.canvas.addEventListener('pointermove', (event) => this.point(event));
    this.canvas.addEventListener('pointerdown', (event) => this.point(event));
    this.element = h('figure', {}, h('figcaption', {}, title), this.canvas, this.legend);
  }

  private point(event: PointerEvent): void {
    if (!this.data) return;
    const last = this.data.times[this.data.times.length - 1] ?? 0;
    const width = this.canvas.clientWidth - kLeft - 4;
    this.onTime((Math.min(Math.max(event.offsetX - kLeft, 0), width) / width) * last);
  }

  show(data: PlotData | null): void {
    this.data = data;
    this.canvas.hidden = data === null;
  }

  draw(time: number): void {
    const data = this.data;
    const width = this.canvas.clientWidth;
    if (!data || width === 0) return;
    const ratio = Math.min(window.devicePixelRatio, 2);
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(kHeight * ratio);
    const pen = this.canvas.getContext('2d')!;
    pen.scale(ratio, ratio);
    const style = getComputedStyle(this.canvas);
    const last = data.times[data.times.length - 1] || 1;
    const x = (t: number): number => kLeft + ((width - kLeft - 4) * t) / last;
    const y = (v: number): number => kTop + ((kHeight - kTop - kBottom) * (data.high - v)) / (data.high - data.low);
    pen.font = `10px ${style.fontFamily}`;
    this.drawLevels(pen, data, style, width, y);
    data.curves.forEach((curve, k) => {
      pen.strokeStyle = style.getPropertyValue(`--plot-${(k % kColours) + 1}`);
      pen.lineWidth = 1.6;
      pen.beginPath();
      for (let f = 0; f < data.times.length; ++f) {
        const value = Math.min(Math.max(curve.values[f] ?? 0, data.low), data.high);
        pen[f === 0 ? 'moveTo' : 'lineTo'](x(data.times[f]!), y(value));
      }
      pen.stroke();
    });
    pen.strokeStyle = style.getPropertyValue('--accent');
    pen.lineWidth = 1.5;
    pen.beginPath();
    pen.moveTo(x(time), kTop);
    pen.lineTo(x(time), kHeight - kBottom);
    pen.stroke();
    this.drawLegend(data, time, style);
  }

  private drawLevels(pen: CanvasRenderingContext2D, data: PlotData, style: CSSStyleDeclaration, width: number, y: (v: number) => number): void {
    pen.fillStyle = style.getPropertyValue('--text-quiet');
    pen.strokeStyle = style.getPropertyValue('--line-strong');
    pen.textAlign = 'right';
    pen.textBaseline = 'middle';
    pen.lineWidth = 1;
    for (const level of data.levels) {
      pen.fillText(level.label, kLeft - 4, y(level.value));
      pen.setLineDash([3, 3]);
      pen.beginPath();
      pen.moveTo(kLeft, y(level.value));
      pen.lineTo(width - 4, y(level.value));
      pen.stroke();
    }
    pen.setLineDash([]);
    pen.strokeRect(kLeft, kTop, width - kLeft - 4, kHeight - kTop - kBottom);
    pen.textBaseline = 'alphabetic';
    const last = data.times[data.times.length - 1] ?? 0;
    pen.fillText(`${round(last)} s`, width - 4, kHeight - 3);
    pen.textAlign = 'left';
    pen.fillText('0', kLeft, kHeight - 3);
  }

  private drawLegend(data: PlotData, time: number, style: CSSStyleDeclaration): void {
    let frame = 0;
    while (frame + 1 < data.times.length && (data.times[frame + 1] ?? 0) <= time) ++frame;
    while (this.legend.children.length > data.curves.length) this.legend.lastChild!.remove();
    while (this.legend.children.length < data.curves.length) this.legend.append(h('span', {}, h('i'), h('span')));
    data.curves.forEach((curve, k) => {
      const item = this.legend.children[k]!;
      (item.firstChild as HTMLElement).style.background = style.getPropertyValue(`--plot-${(k % kColours) + 1}`);
      item.lastChild!.textContent = `${curve.label} ${round(curve.values[frame] ?? 0, data.digits ?? 2)}${data.unit ?? ''}`;
    });
  }
}
