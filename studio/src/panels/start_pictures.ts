// SPDX-License-Identifier: MIT
// Small pictures of the tasks to begin with: how a motion for each ends, as lines in a field of 96 × 72.

interface Drawing {
  readonly far: string; // limbs of the left side
  readonly near: string;
  readonly head: readonly [x: number, y: number];
  readonly things: string;
  readonly goals: readonly (readonly [x: number, y: number])[];
}

const kDrawings = {
  pick: {
    far: 'M54 42L52 51L57 57L58 60M40 51L52 54L45 64L49 65',
    near: 'M39 51L41 49L45 47L49 46L53 45M54 42L53 45L51 50M40 51L39 51L38 52M51 50L47 58L52 62L52 63M38 52L48 55L42 64L46 66',
    head: [58, 45], things: '', goals: [[52, 63]],
  },
  shelf: {
    far: 'M53 22L52 32L53 40L53 43M47 37L47 51L46 64L50 65',
    near: 'M46 38L46 35L46 29L46 25L47 20M53 22L47 20L42 22M47 37L46 38L45 38M42 22L48 26L53 20L54 18M45 38L45 51L44 64L47 66',
    head: [47, 15], things: 'M46 24L60 21L68 21L68 22L54 25L46 25z', goals: [[54, 18]],
  },
  box: {
    far: 'M53 33L54 43L56 51L57 53M43 44L51 53L45 63L49 65',
    near: 'M41 44L42 42L44 38L46 35L50 33M53 33L50 33L45 36M43 44L41 44L39 45M45 36L46 46L48 53L49 56M39 45L46 55L42 64L45 67',
    head: [53, 31], things: 'M46 51L54 49L61 50L61 58L54 61L46 59z', goals: [[49, 56], [57, 53]],
  },
  seated: {
    far: 'M42 34L40 44L48 44L51 45M35 48L47 50L47 63L51 65',
    near: 'M34 49L35 46L37 42L40 39L44 36M42 34L44 36L46 39M35 48L34 49L32 49M46 39L55 40L61 41L64 42M32 49L43 51L43 64L46 66',
    head: [47, 33], things: 'M49 47L68 43L84 44L84 45L66 49L49 48zM32 53L38 51L49 52L49 65L43 67L32 66z', goals: [[64, 42]],
  },
  vrm: {
    far: 'M55 22L55 32L55 40L55 42M50 37L50 51L50 64L52 66',
    near: 'M48 38L48 34L48 29L48 25L48 20M55 22L48 20L41 22M50 37L48 38L45 38M41 22L41 32L41 40L41 43M45 38L45 51L45 64L46 66',
    head: [48, 15], things: '', goals: [],
  },
  overhead: {
    far: 'M52 22L52 32L53 40L54 43M51 38L51 51L50 64L53 65',
    near: 'M49 38L49 35L48 30L47 25L46 20M52 22L46 20L42 19M51 38L49 38L47 38M42 19L43 13L45 6L47 5M47 38L47 51L46 64L48 66',
    head: [44, 16], things: '', goals: [[47, 5]],
  },
} as const satisfies Record<string, Drawing>;

export type StartPicture = keyof typeof kDrawings;

const kSvg = 'http://www.w3.org/2000/svg';

function shape(tag: string, attributes: Record<string, string | number>): SVGElement {
  const element = document.createElementNS(kSvg, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  return element;
}

export function startPicture(name: StartPicture): SVGElement {
  const { far, near, head, things, goals }: Drawing = kDrawings[name];
  const svg = shape('svg', { viewBox: '12 2 76 68', class: 'start-picture', 'aria-hidden': 'true' });
  svg.append(shape('path', { d: 'M16 66.5H84', class: 'floor' }), shape('path', { d: things, class: 'thing' }), shape('path', { d: far, class: 'far' }),
    shape('path', { d: near, class: 'near' }), shape('circle', { cx: head[0], cy: head[1], r: 4, class: 'head' }),
    ...goals.map(([cx, cy]) => shape('circle', { cx, cy, r: 3, class: 'aim' })));
  if (name === 'vrm') svg.append(shape('path', { d: 'M26 6H62L70 14V69H26zM62 6V14H70', class: 'sheet' }));
  return svg;
}
