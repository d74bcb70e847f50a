// SPDX-License-Identifier: MIT
// Takes the view away as a film.
import { t } from '../i18n';
import { fetchPart } from '../offline/part';
import type { Studio } from '../state/studio';
import { save } from '../state/take_away';
import type { View } from '../view/view';
import { button, h, select } from './dom';

const kSizes = { '1280 × 720': [1280, 720], '1920 × 1080': [1920, 1080], '1080 × 1080': [1080, 1080], '640 × 360': [640, 360] } as const;
type Size = keyof typeof kSizes;
const sizes = Object.keys(kSizes) as Size[];
const kRates = ['24', '30', '60'] as const;
const kPlays = ['1', '2', '3', '0'] as const;

export class TakeFilm {
  readonly element: HTMLElement;
  private size: Size = '1280 × 720';
  private fps = 30;
  private plays = 1;
  private readonly turntable: HTMLInputElement;
  private readonly transparent: HTMLInputElement;
  private readonly make: HTMLButtonElement;
  private readonly progress = h('progress', { max: '1', value: '0', 'aria-label': t('filming') });
  private readonly going: HTMLElement;
  private running: AbortController | null = null;

  constructor(private readonly studio: Studio, private readonly view: View) {
    const field = (label: string, key: string, element: HTMLElement): HTMLElement => {
      element.dataset['film'] = key;
      return h('label', {}, h('span', {}, label), element);
    };
    // other parts of the panel have fields of these names too
    const ofFilm = (label: string): string => `${t('film')} · ${label}`;
    const size = select(ofFilm(t('pictureSize')), sizes.map((name) => [name, name] as const), this.size, (value) => (this.size = value));
    const fps = select(ofFilm(t('fps')), kRates.map((rate) => [rate, rate] as const), '30', (value) => (this.fps = Number(value)));
    const plays = select(ofFilm(t('filmPlays')), kPlays.map((count) => [count, count === '0' ? t('filmHeld') : t('filmTimes', { n: count })] as const), '1',
      (value) => (this.plays = Number(value)));
    this.turntable = h('input', { type: 'checkbox', 'data-film': 'turntable' });
    this.transparent = h('input', { type: 'checkbox', 'data-film': 'transparent' });
    this.make = button('WebM', () => void this.take(), { 'data-format': 'film' });
    this.going = h('div', { class: 'filming', hidden: true }, h('span', {}, t('filming')), this.progress, button(t('cancel'), () => this.running?.abort(), { 'data-film': 'cancel' }));
    this.element = h('section', {}, h('h3', {}, t('film')),
      h('div', { class: 'fields' }, field(t('pictureSize'), 'size', size), field(t('fps'), 'fps', fps), field(t('filmPlays'), 'plays', plays)),
      h('label', { class: 'view-row' }, this.turntable, h('span', {}, t('turntable'))),
      h('label', { class: 'view-row' }, this.transparent, h('span', {}, t('filmTransparent'))),
      h('div', { class: 'take' }, this.make), this.going);
  }

  private async take(): Promise<void> {
    const { studio, fps, plays, view } = this;
    const films = await fetchPart(() => import('../view/film')).catch((error: unknown) => studio.fail(error));
    if (!films) return;
    if (!studio.chosen() || this.running) return;
    const { canFilm, isPlayed, secondsOf } = films;
    if (!canFilm()) return studio.tell({ kind: 'text', key: 'noFilm' });
    const controller = new AbortController();
    this.running = controller;
    this.show(true);
    const settings = { size: kSizes[this.size], fps, plays, turntable: this.turntable.checked, transparent: this.transparent.checked };
    // a page that is not seen plays nothing
    const hidden = (): void => {
      if (document.hidden) controller.abort();
    };
    try {
      if (await isPlayed(settings)) document.addEventListener('visibilitychange', hidden);
      const bytes = await view.film(settings, controller.signal, (share) => (this.progress.value = share));
      const file = { name: 'shigusa-view.webm', bytes, type: 'video/webm' };
      save(file);
      studio.tell({ kind: 'text', key: 'filmSaved', values: { name: file.name, s: secondsOf(settings, studio.clock.duration).toFixed(1) } });
    } catch (error) {
      if (controller.signal.aborted) studio.tell({ kind: 'text', key: document.hidden ? 'filmHidden' : 'filmCancelled' });
      else studio.fail(error);
    } finally {
      document.removeEventListener('visibilitychange', hidden);
      this.running = null;
      this.show(false);
    }
  }

  private show(isGoing: boolean): void {
    this.progress.value = 0;
    this.going.hidden = !isGoing;
    this.make.disabled = isGoing;
  }

  /** Ends a film that is being made. */
  dispose(): void {
    this.running?.abort();
  }
}
