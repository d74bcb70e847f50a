// SPDX-License-Identifier: MIT
// Notices over the view: the sentence that says what to drag, the search's progress, messages.
import { failureText, type Key, t } from '../i18n';
import type { Notice } from '../state/model';
import type { Studio } from '../state/studio';
import { isMet } from '../state/verdict';
import { button, fill, h, iconButton, type Panel, round } from './dom';

export function noticeText(notice: Notice): string {
  if (notice.kind === 'text') return t(notice.key as Key, notice.values);
  const first = notice.about === undefined ? t('failed') : t('failedFile', { name: notice.about });
  return `${first} ${failureText(notice.failure)}`;
}

export class Notices implements Panel {
  readonly element: HTMLElement;
  private readonly hint = h('div', { class: 'hint' });
  private readonly progress = h('progress', { max: '1', value: '0', 'aria-label': t('searching') });
  private readonly best = h('span', { class: 'best' });
  private readonly search: HTMLElement;
  private readonly message = h('div', { class: 'message', role: 'status', 'aria-live': 'polite' });
  private readonly end: () => void;

  constructor(private readonly studio: Studio) {
    fill(this.hint, h('span', {}, h('b', {}, t('hint')), ' ', t('hintMore')), iconButton('close', t('gotIt'), () => studio.store.set({ hint: false })));
    this.search = h('div', { class: 'search' }, h('span', {}, t('searching')), this.progress, this.best,
      button(t('cancel'), () => {
        studio.cancel();
        studio.store.set({ preview: null });
        studio.tell({ kind: 'text', key: 'cancelled' });
      }));
    this.element = h('div', { class: 'notices' }, this.hint, this.search, this.message);
    this.end = studio.store.subscribe(() => this.update());
    this.update();
  }

  private update(): void {
    const { state } = this.studio.store;
    this.hint.hidden = !state.hint || state.document === null;
    this.search.hidden = state.search === null;
    this.progress.value = state.search?.fraction ?? 0;
    const best = state.search?.best ?? Infinity;
    this.best.textContent = Number.isFinite(best) && best < 1e6 ? t('best', { score: round(best, 3) }) : '';
    const short = state.preview !== null && state.dragging && !isMet(state.previewRemaining_mm);
    const text = state.opening !== null ? t('opening', { name: state.opening })
      : short ? t('previewMisses', { length: state.previewRemaining_mm / 1000 })
      : state.notice ? noticeText(state.notice) : '';
    if (this.message.dataset['text'] === text) return;
    this.message.dataset['text'] = text;
    const bad = short || state.notice?.kind === 'failure' || (state.notice?.kind === 'text' && /unreach|unturned|misses|unknown|bad|large/i.test(state.notice.key));
    this.message.classList.toggle('bad', text !== '' && state.opening === null && bad);
    fill(this.message, ...(text === '' ? [] : [h('span', {}, text), state.opening === null && !short && state.notice ? iconButton('close', t('dismiss'), () => this.studio.tell(null)) : null]));
  }

  dispose(): void {
    this.end();
  }
}
