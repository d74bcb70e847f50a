// SPDX-License-Identifier: MIT
// One plot over time on the page: its curves, the time that is shown, which follows the pointer, and a legend by side.
import { t } from '../i18n';
import { fill, h, round } from './dom';
import { type Side, sides } from './plot_colours';
import { drawPlot, type Curve, type Ink, leftDashes, type PlotData, plotHeight, svg, timeToX, xToTime } from './plot_svg';

const kSideWords = { right: 'sideRight', left: 'sideLeft', middle: 'sideMiddle' } as const;

export class Plot {
  readonly element: HTMLElement;
  private readonly picture: SVGSVGElement;
  private readonly now = svg('line', { y1: 7, y2: plotHeight - 15, class: 'now' });
  private readonly legend = h('div', { class: 'legend' });
  private values: { curve: Curve; shown: HTMLElement }[] = [];
  private drawn: { data: PlotData; width: number; ink: Ink } | null = null;
  private held: PlotData | null = null;

  constructor(readonly title: string, private readonly onTime: (time: number) => void) {
    this.picture = svg('svg', { class: 'plot', role: 'img', 'aria-label': title, height: plotHeight });
    this.picture.addEventListener('pointermove', (event) => this.point(event));
    this.picture.addEventListener('pointerdown', (event) => this.point(event));
    this.element = h('figure', {}, h('figcaption', {}, title), this.picture, this.legend);
  }

  get data(): PlotData | null {
    return this.held;
  }

  private point(event: PointerEvent): void {
    if (this.held) this.onTime(xToTime(this.held, this.picture.clientWidth, event.offsetX));
  }

  show(data: PlotData | null): void {
    this.held = data;
    this.element.hidden = data === null;
    this.values = [];
    fill(this.legend, ...(data === null ? [] : sides.map((side) => this.legendOf(side, data.curves))));
  }

  /** The curves of one side under its name; without one where no curve has a side. */
  private legendOf(side: Side, all: readonly Curve[]): HTMLElement | null {
    const curves = all.filter((curve) => curve.side === side);
    if (curves.length === 0) return null;
    const named = all.some((curve) => curve.side !== 'middle');
    return h('div', { 'data-side': side }, named ? h('b', {}, t(kSideWords[side])) : null, ...curves.map((curve) => {
      const shown = h('span');
      this.values.push({ curve, shown });
      const sample = svg('svg', { width: 18, height: 4, 'aria-hidden': 'true' },
        svg('line', { x1: 0, x2: 18, y1: 2, y2: 2, stroke: curve.colour, 'stroke-width': 2.5, ...(side === 'left' ? { 'stroke-dasharray': leftDashes } : {}) }));
      return h('span', {}, sample, shown);
    }));
  }

  draw(time: number, ink: Ink): void {
    const { held: data } = this;
    const width = this.picture.clientWidth;
    if (!data || width === 0) return;
    if (this.drawn?.data !== data || this.drawn.width !== width || this.drawn.ink !== ink) {
      this.drawn = { data, width, ink };
      this.picture.setAttribute('viewBox', `0 0 ${width} ${plotHeight}`);
      fill(this.picture, drawPlot(data, width, ink), this.now);
    }
    const x = String(timeToX(data, width, time));
    this.now.setAttribute('x1', x);
    this.now.setAttribute('x2', x);
    let frame = 0;
    while (frame + 1 < data.times.length && (data.times[frame + 1] ?? 0) <= time) ++frame;
    for (const { curve, shown } of this.values) shown.textContent = `${curve.label} ${round(curve.values[frame] ?? 0, data.digits ?? 2)}${data.unit ?? ''}`;
  }
}
