// SPDX-License-Identifier: MIT
// The engine's verdict on the motion that is shown, with its worst reason: a line at the head of the timeline. All else
// that there is to say stands above the goals.
import type { Candidate, Reason } from '../../../bindings/wasm/src/types';
import { postureWords, t } from '../i18n';
import { detailWords, reasonsWords, verdictWords, enoughWords } from '../i18n/verdict_words';
import { ranking } from '../state/criteria';
import type { Document, State } from '../state/model';
import type { Studio } from '../state/studio';
import { reasonsOf, shortOf, unturnedOf } from '../state/verdict';
import { button, fill, h, type Panel } from './dom';

const kFirst = 3; // reasons that are seen at once

/** The text in place of a verdict if the shown figure is not the computed one; else "". */
export function undrawnText({ document, undrawn }: State): string {
  if (!undrawn || undrawn.character !== document?.character) return '';
  return undrawn.apart_m === null ? t('undrawnMesh') : t('undrawn', { length: undrawn.apart_m });
}

/** How a verdict is coloured. */
export function verdictClass(candidate: Candidate): 'good' | 'hard' | 'bad' {
  const { verdict } = candidate.summary;
  return verdict === 'impossible' || shortOf(candidate) > 0 || unturnedOf(candidate) > 0 ? 'bad' : verdict === 'strains' ? 'hard' : 'good';
}

/** Which motion is shown, and whether the body could make it. */
export class VerdictLine implements Panel {
  readonly element = h('div', { class: 'verdict-line' });
  private readonly end: () => void;

  constructor(private readonly studio: Studio) {
    this.end = studio.store.subscribe((state, previous) => {
      if (state.document !== previous.document || state.preview !== previous.preview || state.undrawn !== previous.undrawn) this.update();
    });
    this.update();
  }

  private update(): void {
    const { document } = this.studio;
    const shown = this.studio.shown();
    if (!document || !shown) return fill(this.element);
    const place = ranking(document).indexOf(document.chosen) + 1;
    const isPreview = this.studio.store.state.preview !== null;
    const undrawn = undrawnText(this.studio.store.state);
    const worst = reasonsOf(document, shown).find(({ time_s }) => time_s !== undefined);
    const words = verdictWords(document, shown);
    const told = { class: `verdict ${verdictClass(shown)}`, title: reasonsWords(document, shown).join('\n') || words };
    fill(this.element,
      h('span', { class: 'motion' }, isPreview ? '' : h('b', {}, t('candidate', { n: place })), ` ${postureWords(shown.summary.final_posture.words)}`),
      undrawn !== '' ? h('span', { class: 'verdict bad', title: undrawn }, undrawn)
        : worst && !isPreview ? button(words, () => this.studio.scrub(worst.time_s!), { ...told, 'aria-label': `${words} — ${t('showMoment')}` })
        : h('span', told, words));
  }

  dispose(): void {
    this.end();
  }
}

/** What keeps the chosen motion from being possible or easy beside its worst reason, and what would help; hidden where nothing does. */
export class VerdictBox {
  readonly element = h('section', { class: 'verdict-box', 'aria-label': t('why'), hidden: true });

  constructor(private readonly studio: Studio) {}

  update(document: Document, candidate: Candidate | null): void {
    const reasons = candidate ? reasonsOf(document, candidate).slice(1) : [];
    const undrawn = undrawnText(this.studio.store.state);
    const seconds = candidate?.summary.possible_in_s;
    this.element.hidden = reasons.length === 0 && seconds === undefined && undrawn === '';
    this.element.className = 'verdict-box bad';
    if (undrawn !== '') return fill(this.element, h('p', {}, undrawn));
    if (!candidate || this.element.hidden) return fill(this.element);
    this.element.className = `verdict-box ${verdictClass(candidate)}`;
    const items = reasons.map((reason) => h('li', {}, this.reason(document, candidate, reason)));
    const rest = items.slice(kFirst);
    fill(this.element,
      ...(reasons.length === 0 ? [] : [h('strong', {}, t('besides')), h('ul', {}, ...items.slice(0, kFirst))]),
      rest.length === 0 ? null : h('details', {}, h('summary', {}, t('andMore', { n: rest.length })), h('ul', {}, ...rest)),
      seconds === undefined ? null : this.slower(document, seconds));
  }

  /** With a press it shows the moment that it is about. */
  private reason(document: Document, candidate: Candidate, reason: Reason): HTMLElement | string {
    const words = detailWords(document, candidate, reason);
    const { time_s: time } = reason;
    return time === undefined ? words : button(words, () => this.studio.scrub(time), { class: 'link', title: t('showMoment') });
  }

  private slower(document: Document, seconds: number): HTMLElement {
    const s = enoughWords(seconds);
    return h('p', {}, t('couldIn', { s }), ' ', button(t('takeTime', { s }), () => {
      this.studio.commit({ ...document, settings: { ...document.settings, duration_s: Number(s) } });
      void this.studio.search();
    }, { 'data-key': 'slower' }));
  }
}
