// SPDX-License-Identifier: MIT
// Two small figures side by side: the effect of a slider at either end.
import type { Character } from '../../../bindings/wasm/src/types';
import type { Drawing } from '../view/stick_drawing';

const kSvg = 'http://www.w3.org/2000/svg';
const kWidth = 120; // px, of one figure
const kHeight = 112;
const kMargin = 9;

function shape(tag: string, attributes: Record<string, string | number>): SVGElement {
  const element = document.createElementNS(kSvg, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  return element;
}

/** One end of a slider: the posture half way and at the end, and what stands below. */
export interface End {
  readonly half: Drawing;
  readonly whole: Drawing;
  readonly caption: string;
}

export function tipPicture(character: Character, ends: readonly End[]): SVGElement {
  const points = ends.flatMap(({ half, whole }) => [...whole.limbs, ...half.limbs, ...whole.paths].flat());
  const xs = points.map(([x]) => x);
  const tall = Math.max(character.description.stature_m, ...points.map(([, y]) => y));
  const middle = (Math.min(...xs) + Math.max(...xs)) / 2;
  const scale = Math.min((kHeight - 2 * kMargin) / tall, (kWidth - 2 * kMargin) / (Math.max(...xs) - Math.min(...xs)));
  const svg = shape('svg', { viewBox: `0 0 ${kWidth * ends.length} ${kHeight + 14}`, class: 'tip-picture', 'aria-hidden': 'true' });
  ends.forEach(({ half, whole, caption }, index) => {
    const x = (value: number): number => kWidth * (index + 0.5) + scale * (value - middle);
    const y = (value: number): number => kHeight - kMargin - scale * value;
    const lines = (list: Drawing['limbs']): string =>
      list.map((line) => line.map((point, k) => `${k === 0 ? 'M' : 'L'}${x(point[0]).toFixed(1)} ${y(point[1]).toFixed(1)}`).join('')).join('');
    svg.append(shape('path', { d: `M${kWidth * index + 12} ${y(0)}h${kWidth - 24}`, class: 'floor' }), shape('path', { d: lines(half.limbs), class: 'far' }),
      shape('path', { d: lines(whole.limbs), class: 'near' }), shape('path', { d: lines(whole.paths), class: 'way' }));
    if (whole.head) svg.append(shape('circle', { cx: x(whole.head[0]), cy: y(whole.head[1]) - 3, r: 0.06 * scale * character.description.stature_m, class: 'head' }));
    const text = shape('text', { x: kWidth * (index + 0.5), y: kHeight + 8 });
    text.textContent = caption;
    svg.append(text);
  });
  return svg;
}
