// SPDX-License-Identifier: MIT
// A number is changed by dragging its field or its name to the side: finer with Shift, back as it was with Escape. A press without a drag is
// left to the field, as is a drag in a field that somebody types in.
import { t } from '../i18n';

const kStart = 4; // px that a press may move and still be none
const kPixels = 4; // for each step
const kFine = 0.1; // with Shift

export interface Scrub {
  /** The number that a drag begins with; null: none now. */
  begin: () => number | null;
  readonly step: number;
  /** With each movement. */
  move: (value: number) => void;
  end: (value: number) => void;
  /** As it was. */
  back: () => void;
}

interface Drag {
  readonly pointer: number;
  readonly from: number;
  value: number; // not rounded
  x: number;
  begun: boolean;
}

export function scrubbable(input: HTMLInputElement, name: HTMLElement, scrub: Scrub): void {
  let drag: Drag | null = null;
  name.title = t('scrubAbout');

  const rounded = (value: number, fine: boolean): number => {
    const step = scrub.step * (fine ? kFine : 1);
    return Number((Math.round(value / step) * step).toFixed(6));
  };
  const finish = (): void => {
    drag = null;
    document.body.classList.remove('scrubbing');
    window.removeEventListener('keydown', key, true);
  };
  const key = (event: KeyboardEvent): void => {
    if (event.key !== 'Escape' || !drag) return;
    event.preventDefault();
    event.stopPropagation();
    finish();
    window.addEventListener('pointerup', swallowClick, { capture: true, once: true });
    scrub.back();
  };
  const start = (target: HTMLElement, pointer: number): void => {
    drag!.begun = true;
    input.blur();
    target.setPointerCapture(pointer);
    document.body.classList.add('scrubbing');
    window.addEventListener('keydown', key, true);
  };

  for (const target of [input, name]) {
    target.classList.add('scrub-handle');
    target.addEventListener('pointerdown', (event) => {
      if (event.button !== 0 || input.disabled || (target === input && document.activeElement === input)) return;
      const from = scrub.begin();
      if (from !== null) drag = { pointer: event.pointerId, from, value: from, x: event.clientX, begun: false };
    });
    target.addEventListener('pointermove', (event) => {
      if (drag?.pointer !== event.pointerId) return;
      if (event.buttons === 0) return finish();
      const way = event.clientX - drag.x;
      if (!drag.begun && Math.abs(way) < kStart) return;
      if (!drag.begun) start(target, event.pointerId);
      drag.x = event.clientX;
      drag.value += (way / kPixels) * scrub.step * (event.shiftKey ? kFine : 1);
      scrub.move(rounded(drag.value, event.shiftKey));
    });
    target.addEventListener('pointerup', (event) => {
      if (drag?.pointer !== event.pointerId) return;
      const { begun, from, value } = drag;
      finish();
      if (!begun) return;
      swallowClick();
      const number = rounded(value, event.shiftKey);
      if (number === from) scrub.back();
      else scrub.end(number);
    });
    target.addEventListener('pointercancel', () => {
      if (!drag) return;
      const { begun } = drag;
      finish();
      if (begun) scrub.back();
    });
  }
}

/** The press has been a drag, not a click that brings the focus. */
function swallowClick(): void {
  window.addEventListener('click', swallow, { capture: true, once: true });
  setTimeout(() => window.removeEventListener('click', swallow, true));
}

function swallow(event: Event): void {
  event.preventDefault();
  event.stopPropagation();
}
