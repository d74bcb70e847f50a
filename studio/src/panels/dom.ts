// SPDX-License-Identifier: MIT
// Elements, in few words. Nothing here takes markup as text.

type Child = Node | string | null | undefined | false;
type Props = Record<string, string | number | boolean | ((event: never) => void) | undefined>;

const kProperties = new Set(['value', 'checked', 'disabled', 'type', 'min', 'max', 'step', 'tabIndex', 'hidden', 'open', 'selected', 'htmlFor', 'id', 'title', 'src', 'alt', 'download', 'href', 'accept']);

/** `on…` are listeners, known properties are set, the rest are attributes (class, aria-label, role). */
export function h<K extends keyof HTMLElementTagNameMap>(tag: K, props: Props = {}, ...children: Child[]): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(props)) {
    if (value === undefined || value === false && name !== 'checked') continue;
    if (typeof value === 'function') element.addEventListener(name.slice(2).toLowerCase(), value as EventListener);
    else if (kProperties.has(name)) (element as unknown as Record<string, unknown>)[name] = value;
    else element.setAttribute(name, value === true ? '' : String(value));
  }
  element.append(...children.filter((child): child is Node | string => child !== null && child !== undefined && child !== false));
  return element;
}

const kSvg = 'http://www.w3.org/2000/svg';

/** Icons of 24 × 24, as strokes. */
const kIcons = {
  undo: 'M9 7 4 12l5 5M4 12h10a6 6 0 0 1 0 12',
  redo: 'm15 7 5 5-5 5M20 12H10a6 6 0 0 0 0 12',
  mirror: 'M12 3v18M9 7 3 17h6zM15 7l6 10h-6z',
  help: 'M9 9a3 3 0 1 1 4 2.800c-.8.4-1 1-1 2M12 17.500v.1',
  play: 'M7 5v14l12-7z',
  pause: 'M8 5v14M16 5v14',
  loop: 'M17 3l3 3-3 3M4 11V9a3 3 0 0 1 3-3h13M7 21l-3-3 3-3M20 13v2a3 3 0 0 1-3 3H4',
  lock: 'M6 11h12v9H6zM8.500 11V8a3.500 3.500 0 0 1 7 0v3',
  unlock: 'M6 11h12v9H6zM8.500 11V8a3.500 3.500 0 0 1 6.800-1.200',
  compare: 'M4 5h7v14H4zM13 5h7v14h-7z',
  close: 'M6 6l12 12M18 6 6 18',
  file: 'M6 3h8l4 4v14H6zM14 3v4h4',
  eye: 'M2 12c3-5 6.500-7 10-7s7 2 10 7c-3 5-6.500 7-10 7s-7-2-10-7zM12 9a3 3 0 1 0 .1 0z',
  folder: 'M3 6h6l2 2.500h10V19H3z',
  pencil: 'M4 20l1-4L16.500 4.500l3 3L8 19zM14 7l3 3',
  copy: 'M9 9h11v11H9zM6 15H4V4h11v2',
  bin: 'M5 7h14M10 7V4h4v3M7 7l1 13h8l1-13M10.500 11v5M13.500 11v5',
  more: 'M5 11.500a.5.5 0 1 0 .1 0zM12 11.500a.5.5 0 1 0 .1 0zM19 11.500a.5.5 0 1 0 .1 0z',
  path: 'M4 18c4 0 4-10 8-10s4 6 8 6M4 18v.1M20 14v.1',
} as const;
export type Icon = keyof typeof kIcons;

export function icon(name: Icon): SVGSVGElement {
  const svg = document.createElementNS(kSvg, 'svg');
  const box = name === 'undo' || name === 'redo' ? '0 2.500 24 24' : '0 0 24 24';
  for (const [key, value] of Object.entries({ viewBox: box, class: 'icon', 'aria-hidden': 'true' })) svg.setAttribute(key, value);
  const path = document.createElementNS(kSvg, 'path');
  path.setAttribute('d', kIcons[name]);
  svg.append(path);
  return svg;
}

/** A button with a picture; its name is for screen readers and shown on hovering. */
export function iconButton(name: Icon, label: string, onClick: () => void, props: Props = {}): HTMLButtonElement {
  return h('button', { type: 'button', class: 'icon-button', 'aria-label': label, title: label, onClick, ...props }, icon(name));
}

export function button(label: string, onClick: () => void, props: Props = {}): HTMLButtonElement {
  return h('button', { type: 'button', onClick, ...props }, label);
}

export function select<Value extends string>(label: string, options: readonly (readonly [value: Value, text: string])[], value: Value, onChange: (value: Value) => void): HTMLSelectElement {
  const element = h('select', { 'aria-label': label, onChange: () => onChange(element.value as Value) },
    ...options.map(([key, text]) => h('option', { value: key }, text)));
  element.value = value;
  return element;
}

/** Puts new children in place of the old ones. */
export function fill(element: Element, ...children: Child[]): void {
  element.replaceChildren(...children.filter((child): child is Node | string => child !== null && child !== undefined && child !== false));
}

/** What a panel is to the page around it. */
export interface Panel {
  readonly element: HTMLElement;
  dispose(): void;
}

export function round(value: number, digits = 2): string {
  return value.toFixed(digits).replace(/^-(0(\.0*)?)$/, '$1');
}
