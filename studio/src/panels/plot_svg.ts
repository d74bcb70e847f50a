// SPDX-License-Identifier: MIT
// A plot over time as SVG: on the page, and in the pictures that are saved.
import { t } from '../i18n';
import { round } from './dom';
import type { Side } from './plot_colours';

export interface Curve {
  name: string;
  label: string;
  side: Side;
  colour: string;
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

export interface Ink {
  text: string;
  line: string;
  paper: string;
}

const kLeft = 40;
const kRight = 4;
const kBottom = 15;
const kTop = 7;
export const plotHeight = 128; // px
export const leftDashes = '5 3';
const kSheetWidth = 760;
const kTitleHeight = 26;
const kLegendHeight = 16;
const kNamespace = 'http://www.w3.org/2000/svg';

type Attributes = Record<string, string | number>;

export function svg<K extends keyof SVGElementTagNameMap>(tag: K, attributes: Attributes, ...children: (Node | string)[]): SVGElementTagNameMap[K] {
  const element = document.createElementNS(kNamespace, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  element.append(...children);
  return element;
}

const lastOf = (times: Float64Array): number => times[times.length - 1] || 1;

/** Where a time lies, px from the left. */
export function timeToX(data: PlotData, width: number, time: number): number {
  return kLeft + ((width - kLeft - kRight) * time) / lastOf(data.times);
}

export function xToTime(data: PlotData, width: number, x: number): number {
  return (Math.min(Math.max((x - kLeft) / (width - kLeft - kRight), 0), 1)) * lastOf(data.times);
}

/** The range that holds all curves, and no less than the one that is given. */
export function rangeOf(curves: readonly Curve[], low: number, high: number): [number, number] {
  let [least, most] = [low, high];
  for (const { values } of curves) {
    for (const value of values) {
      if (value < least) least = value;
      if (value > most) most = value;
    }
  }
  const room = 0.03 * (most - least);
  return [least < low ? least - room : low, most > high ? most + room : high];
}

export function drawPlot(data: PlotData, width: number, ink: Ink): SVGGElement {
  const y = (value: number): number => kTop + ((plotHeight - kTop - kBottom) * (data.high - value)) / (data.high - data.low);
  const text = (x: number, at: number, anchor: string, words: string): SVGTextElement =>
    svg('text', { x, y: at, 'text-anchor': anchor, fill: ink.text, 'font-size': 10 }, words);
  const right = width - kRight;
  return svg('g', {},
    ...data.levels.map(({ value }) => svg('line', { x1: kLeft, x2: right, y1: y(value), y2: y(value), stroke: ink.line, 'stroke-dasharray': '3 3' })),
    ...data.levels.map(({ value, label }) => text(kLeft - 4, y(value) + 3.5, 'end', label)),
    svg('rect', { class: 'frame', x: kLeft, y: kTop, width: right - kLeft, height: plotHeight - kTop - kBottom, fill: 'none', stroke: ink.line }),
    text(kLeft, plotHeight - 3, 'start', '0'), text(right, plotHeight - 3, 'end', t('seconds', { t: round(lastOf(data.times)) })),
    ...data.curves.map(({ name, side, colour, values }) => svg('polyline', {
      'data-curve': name, fill: 'none', stroke: colour, 'stroke-width': 1.7, 'stroke-linejoin': 'round', ...(side === 'left' ? { 'stroke-dasharray': leftDashes } : {}),
      points: [...data.times].map((time, f) => `${timeToX(data, width, time).toFixed(1)},${y(values[f] ?? 0).toFixed(1)}`).join(' '),
    })));
}

/** Plots under each other with their titles and legends, to be saved. */
export function plotSheet(title: string, plots: readonly { title: string; data: PlotData }[], ink: Ink): string {
  const parts: Node[] = [svg('text', { x: 12, y: 24, fill: ink.text, 'font-size': 15, 'font-weight': 600 }, title)];
  let top = 40;
  for (const { title: name, data } of plots) {
    parts.push(svg('text', { x: 12, y: top + 16, fill: ink.text, 'font-size': 12, 'font-weight': 600 }, name));
    top += kTitleHeight;
    const plot = drawPlot(data, kSheetWidth - 24, ink);
    plot.setAttribute('transform', `translate(12 ${top})`);
    parts.push(plot);
    top += plotHeight + kLegendHeight;
    data.curves.forEach(({ label, side, colour }, k) => {
      const [x, y] = [12 + kLeft + (k % 2) * 350, top + Math.floor(k / 2) * kLegendHeight];
      parts.push(svg('line', { x1: x, x2: x + 18, y1: y - 4, y2: y - 4, stroke: colour, 'stroke-width': 2, ...(side === 'left' ? { 'stroke-dasharray': leftDashes } : {}) }),
        svg('text', { x: x + 24, y, fill: ink.text, 'font-size': 11 }, label));
    });
    top += Math.ceil(data.curves.length / 2) * kLegendHeight + 8;
  }
  const sheet = svg('svg', { xmlns: kNamespace, width: kSheetWidth, height: top, viewBox: `0 0 ${kSheetWidth} ${top}`, 'font-family': 'system-ui, sans-serif' },
    svg('rect', { width: kSheetWidth, height: top, fill: ink.paper }), ...parts);
  return new XMLSerializer().serializeToString(sheet);
}
