// SPDX-License-Identifier: MIT
// A number is changed by dragging its field or its name to the side: finer with Shift, coarser with Alt, back as it was with Escape. A press
// without a drag is left to the field, as is a drag in a field that somebody types in.

const kStart = 4; // px that a press may move and still be none
const kTouchStart = 10; // px, of a finger, whose drag begins there
const kPixels = 4; // for each step
const kFine = 0.1; // with Shift
const kCoarse = 10; // with Alt

export interface Scrub {
  /** The number that a drag begins with; null: none now. */
  begin: () => number | null;
  readonly step: number;
  readonly low: number;
  readonly high: number;
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

/** The input, and its name where that is taken hold of too. */
export function scrubbable([input, ...names]: readonly [HTMLInputElement, ...HTMLElement[]], scrub: Scrub): void {
  let drag: Drag | null = null;

  const rounded = (value: number, fine: boolean): number => {
    const step = scrub.step * (fine ? kFine : 1);
    const even = Number((Math.round(value / step) * step).toFixed(6));
    return Math.min(Math.max(even, Math.min(scrub.low, drag!.from)), Math.max(scrub.high, drag!.from));
  };
  const finish = (): void => {
    drag = null;
    document.body.classList.remove('scrubbing');
    window.removeEventListener('keydown', key, true);
  };
  const key = (event: KeyboardEvent): void => {
    if (event.key === 'Alt') event.preventDefault(); // some browsers open their menu
    if (event.key !== 'Escape' || !drag) return;
    event.preventDefault();
    event.stopPropagation();
    finish();
    window.addEventListener('pointerup', swallowClick, { capture: true, once: true });
    scrub.back();
  };
  const start = (): void => {
    drag!.begun = true;
    input.blur();
    document.body.classList.add('scrubbing');
    window.addEventListener('keydown', key, true);
  };

  for (const target of [input, ...names]) {
    target.classList.add('scrub-handle');
    target.addEventListener('pointerdown', (event) => {
      if (event.button !== 0 || (target === input && document.activeElement === input)) return;
      const from = scrub.begin();
      if (from === null) return;
      target.setPointerCapture(event.pointerId); // a quick hand is off a small name with its first movement
      drag = { pointer: event.pointerId, from, value: from, x: event.clientX, begun: false };
    });
    target.addEventListener('pointermove', (event) => {
      if (drag?.pointer !== event.pointerId) return;
      if (event.buttons === 0) return finish();
      const way = event.clientX - drag.x;
      const isTouch = event.pointerType === 'touch';
      if (!drag.begun && Math.abs(way) < (isTouch ? kTouchStart : kStart)) return;
      drag.x = event.clientX;
      if (!drag.begun) {
        start();
        if (isTouch) return;
      }
      // a number that began out of its range may stay there
      const [low, high] = [Math.min(scrub.low, drag.from), Math.max(scrub.high, drag.from)];
      const times = event.shiftKey ? kFine : event.altKey ? kCoarse : 1;
      drag.value = Math.min(Math.max(drag.value + (way / kPixels) * scrub.step * times, low), high);
      scrub.move(rounded(drag.value, event.shiftKey));
    });
    target.addEventListener('pointerup', (event) => {
      if (drag?.pointer !== event.pointerId) return;
      const { begun, from, value } = drag;
      const number = rounded(value, event.shiftKey);
      finish();
      if (!begun) return;
      swallowClick();
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
