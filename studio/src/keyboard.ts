// SPDX-License-Identifier: MIT
// Keys for everything that a pointer does. Letters typed into a field stay there; after a number, Enter and Escape give the keys
// back to the view.
import type { Vec3 } from '../../bindings/wasm/src/types';
import { isBeingTyped, isNumberField } from './panels/number_input';
import type { ViewMenu } from './panels/view_menu';
import { ranking } from './state/criteria';
import { leastOf, placeNames, placeOf } from './state/places';
import type { Studio } from './state/studio';
import { screenAxes, type ScreenWay } from './view/screen_axes';

const kStep = 0.01; // m
const kLongStep = 0.1;
const kFrame = 1 / 60; // s
const kPause = 350; // ms after the last key until the whole search begins

const kMoves: Readonly<Record<string, readonly [ScreenWay, 1 | -1]>> = {
  ArrowRight: ['right', 1], ArrowLeft: ['right', -1], ArrowUp: ['up', 1], ArrowDown: ['up', -1], PageUp: ['near', 1], PageDown: ['near', -1],
};

const kLeave = new Set(['Enter', 'Escape']);

export class Keyboard {
  private timer = 0;
  private target: { name: string; position: Vec3 } | null = null;

  constructor(private readonly studio: Studio, private readonly canvas: HTMLElement, private readonly viewMenu: ViewMenu, private readonly openHelp: () => void) {
    document.addEventListener('keydown', this.key);
  }

  private readonly key = (event: KeyboardEvent): void => {
    const { target } = event;
    if (document.querySelector('dialog[open]')) return;
    const number = isNumberField(target) ? target : null;
    if (number && kLeave.has(event.key)) return this.leave(number, event.key);
    const field = target instanceof HTMLInputElement || target instanceof HTMLSelectElement || target instanceof HTMLTextAreaElement;
    const typing = field && !(target instanceof HTMLInputElement && (target.type === 'range' || target.type === 'checkbox'));
    if ((event.ctrlKey || event.metaKey) && !event.altKey) {
      if (event.key.toLowerCase() === 's') return this.done(event, () => this.studio.store.set({ tab: 'take' }));
      if (typing && (number === null || isBeingTyped(number))) return;
      if (event.key.toLowerCase() === 'z') this.done(event, () => (event.shiftKey ? this.studio.redo() : this.studio.undo()));
      if (event.key.toLowerCase() === 'y') this.done(event, () => this.studio.redo());
      return;
    }
    if (event.key === 'Escape') return this.escape();
    if (typing || event.altKey) return;
    if (target === this.canvas && this.moveGoal(event)) return;
    this.plain(event, target);
  };

  /** Enter accepts the typed number; Escape restores the former one. */
  private leave(field: HTMLInputElement, key: string): void {
    if (key === 'Escape') field.value = field.defaultValue;
    this.canvas.focus();
  }

  private plain(event: KeyboardEvent, target: EventTarget | null): void {
    const digit = /^Digit([1-9])$/.exec(event.code)?.[1];
    if (digit !== undefined) return this.done(event, () => this.pick(Number(digit) - 1, event.shiftKey));
    const presses = target instanceof HTMLButtonElement || target instanceof HTMLInputElement || (target instanceof HTMLElement && target.tagName === 'SUMMARY');
    if (event.key === ' ' && !presses) return this.done(event, () => this.studio.play(!this.studio.store.state.playing));
    if (event.key === ',' || event.key === '.') {
      return this.done(event, () => this.studio.scrub(this.studio.clock.time + (event.key === '.' ? kFrame : -kFrame)));
    }
    if (event.key.toLowerCase() === 'm') return this.done(event, () => void this.studio.mirror());
    const view = this.viewMenu.actionOf(event);
    if (view) return this.done(event, view);
    if (event.key === '?') return this.done(event, this.openHelp);
  }

  private done(event: KeyboardEvent, action: () => void): void {
    event.preventDefault();
    action();
  }

  /** By the order on the page. */
  private pick(place: number, compare: boolean): void {
    const { document } = this.studio;
    if (!document) return;
    const index = ranking(document)[place];
    if (index === undefined) return;
    if (compare) this.studio.compare(index);
    else this.studio.choose(index);
  }

  private escape(): void {
    if (this.studio.store.state.search) {
      this.studio.cancel();
      this.studio.store.set({ preview: null });
      this.studio.tell({ kind: 'text', key: 'cancelled' });
    } else {
      this.studio.tell(null);
    }
  }

  private moveGoal(event: KeyboardEvent): boolean {
    const { document, store } = this.studio;
    if (!document) return false;
    if (event.key === '[' || event.key === ']') {
      const names = placeNames(document);
      const next = names.indexOf(store.state.selected) + (event.key === ']' ? 1 : -1);
      this.studio.select(names[(next + names.length) % names.length]!);
      return true;
    }
    const move = kMoves[event.key];
    const look = this.studio.eye?.look();
    const name = store.state.selected;
    const place = placeOf(document, name);
    if (!move || !look || !place) return false;
    event.preventDefault();
    const from = this.target?.name === name ? this.target.position : place;
    const way = screenAxes(look)[move[0]];
    const step = move[1] * (event.shiftKey ? kLongStep : kStep);
    const position: Vec3 = [from[0] + way[0] * step, Math.max(from[1] + way[1] * step, leastOf(document, name)), from[2] + way[2] * step];
    this.target = { name, position };
    void this.studio.drag(name, position);
    window.clearTimeout(this.timer);
    this.timer = window.setTimeout(() => {
      this.target = null;
      void this.studio.drop(name, position);
    }, kPause);
    return true;
  }

  dispose(): void {
    window.clearTimeout(this.timer);
    document.removeEventListener('keydown', this.key);
  }
}
