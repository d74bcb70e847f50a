// SPDX-License-Identifier: MIT
// The sentence and the small picture that tell what a slider does: shown where the pointer rests on it, where it has the focus of the
// keyboard, and by a tap on its name. Escape closes it.
import { h } from './dom';

const kWait = 450; // ms that a pointer rests
const kGap = 6; // px

export interface Tip {
  readonly text: string;
  /** Comes later, or not at all. */
  readonly picture?: () => Promise<SVGElement | null>;
}

const box = h('div', { class: 'tip', id: 'tip', role: 'tooltip', hidden: true });
let owner: HTMLElement | null = null;
let timer = 0;

function hide(): void {
  window.clearTimeout(timer);
  owner?.removeAttribute('aria-describedby');
  owner = null;
  box.hidden = true;
}

/** Below its control, or above it if there is no room. */
function place(beside: HTMLElement): void {
  const { left, right, top, bottom } = beside.getBoundingClientRect();
  const { offsetWidth: width, offsetHeight: height } = box;
  const x = Math.max(kGap, Math.min((left + right - width) / 2, window.innerWidth - width - kGap));
  const below = bottom + kGap + height <= window.innerHeight;
  box.style.left = `${x}px`;
  box.style.top = `${below ? bottom + kGap : Math.max(kGap, top - kGap - height)}px`;
}

async function show(row: HTMLElement, control: HTMLElement, { text, picture }: Tip): Promise<void> {
  window.clearTimeout(timer);
  if (owner === control || text === '') return;
  hide();
  owner = control;
  control.setAttribute('aria-describedby', box.id);
  document.body.append(box);
  box.replaceChildren(h('p', {}, text));
  box.hidden = false;
  place(row);
  const drawn = await picture?.();
  if (!drawn || owner !== control) return;
  box.append(drawn);
  place(row);
}

/** Gives a row with a control its tip; `name` is what a finger taps. */
export function giveTip(row: HTMLElement, name: HTMLElement, control: HTMLElement, tip: () => Tip): void {
  const now = (): void => void show(row, control, tip());
  const away = (): void => {
    window.clearTimeout(timer);
    if (!control.matches(':focus-visible')) timer = window.setTimeout(() => owner === control && hide(), kGap * 20);
  };
  name.classList.add('has-tip');
  name.addEventListener('click', () => (owner === control ? hide() : now()));
  row.addEventListener('pointerenter', (event) => {
    if (event.pointerType === 'touch' || event.buttons !== 0) return;
    window.clearTimeout(timer);
    timer = window.setTimeout(now, kWait);
  });
  row.addEventListener('pointerleave', away);
  row.addEventListener('pointerdown', (event) => {
    if (event.target !== name) hide(); // the effect of a dragged control is visible in the view
  });
  control.addEventListener('focus', () => control.matches(':focus-visible') && now());
  control.addEventListener('blur', () => owner === control && hide());
}

box.addEventListener('pointerenter', () => window.clearTimeout(timer));
box.addEventListener('pointerleave', hide);
document.addEventListener('keydown', (event) => event.key === 'Escape' && hide(), true);
document.addEventListener('scroll', hide, true);
