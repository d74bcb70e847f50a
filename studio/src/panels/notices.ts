// SPDX-License-Identifier: MIT
// Notices over the view: the first hint about dragging, the search's progress, messages.
import { failureText, t } from '../i18n';
import { noticeTones } from '../i18n/notice_tones';
import type { Notice, State } from '../state/model';
import type { Studio } from '../state/studio';
import { isMet } from '../state/verdict';
import { button, fill, h, iconButton, type Panel, round } from './dom';

export function noticeText(notice: Notice): string {
  if (notice.kind === 'several') return notice.of.map(noticeText).join(' ');
  if (notice.kind === 'text') return t(notice.key, notice.values);
  const first = notice.about === undefined ? t('failed') : t('failedFile', { name: notice.about });
  return `${first} ${failureText(notice.failure)}`;
}

function isBad(notice: Notice): boolean {
  if (notice.kind === 'several') return notice.of.some(isBad);
  return notice.kind === 'failure' || noticeTones[notice.key] === 'bad';
}

/** The one message that is shown; what `stays` goes with its cause, and nobody closes it. */
function toldNow({ pictureLost, opening, preview, dragging, previewRemaining_mm, notice }: State): { text: string; bad: boolean; stays: boolean } {
  if (pictureLost) return { text: t('pictureLost'), bad: true, stays: true };
  if (opening !== null) return { text: t('opening', { name: opening }), bad: false, stays: true };
  if (preview !== null && dragging && !isMet(previewRemaining_mm)) return { text: t('previewMisses', { length: previewRemaining_mm / 1000 }), bad: true, stays: true };
  if (notice) return { text: noticeText(notice), bad: isBad(notice), stays: false };
  return { text: '', bad: false, stays: true };
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
    fill(this.hint, h('span', {}, h('b', {}, t('hint')), ' ', t('hintMore')), iconButton('close', t('gotIt'), () => studio.learnHint()));
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
    const { text, bad, stays } = toldNow(state);
    if (this.message.dataset['text'] === text) return;
    this.message.dataset['text'] = text;
    this.message.classList.toggle('bad', bad);
    fill(this.message, ...(text === '' ? [] : [h('span', {}, text), stays ? null : iconButton('close', t('dismiss'), () => this.studio.tell(null))]));
  }

  dispose(): void {
    this.end();
  }
}
