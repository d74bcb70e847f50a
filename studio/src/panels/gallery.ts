// SPDX-License-Identifier: MIT
// The candidates as cards: a moving picture, the word that tells one from the others, its strip, a bar for each criterion.
import type { Candidate, Summary } from '../../../bindings/wasm/src/types';
import { differenceWords, fewerWords, scoreWords } from '../i18n/motion_words';
import { engineText, engineWord, t } from '../i18n';
import { reasonsWords, verdictMark } from '../i18n/verdict_words';
import { ranking, scoreOf } from '../state/criteria';
import { candidateAt, type Document } from '../state/model';
import type { Studio } from '../state/studio';
import type { Thumbnails } from '../view/thumbnails';
import { fill, h, iconButton, type Panel, round } from './dom';
import { undrawnText, verdictClass } from './verdict';

const kNamedBars = 3;

interface Card {
  element: HTMLElement;
  pick: HTMLButtonElement;
  canvas: HTMLCanvasElement;
  strip: HTMLImageElement;
  words: HTMLElement;
  score: HTMLElement;
  bars: HTMLElement;
  warning: HTMLElement;
  compare: HTMLButtonElement;
}

export class Gallery implements Panel {
  readonly element: HTMLElement;
  private readonly list = h('ol', { class: 'cards' });
  private readonly mode = h('div', { class: 'segmented', role: 'group', 'aria-label': t('compare') });
  private readonly empty = h('p', { class: 'quiet' }, t('noCandidates'));
  private readonly fewer = h('p', { class: 'quiet' });
  private cards = new Map<number, Card>();
  private strips = new Map<Candidate, string>();
  private result: Document['result'] = null;
  private readonly end: () => void;

  constructor(private readonly studio: Studio, private readonly thumbnails: Thumbnails) {
    this.element = h('section', { class: 'gallery', 'aria-label': t('candidates') },
      h('header', {}, h('h2', {}, t('candidates')), this.mode), this.empty, this.list, this.fewer);
    this.end = studio.store.subscribe((state, previous) => {
      if (state.document !== previous.document || state.undrawn !== previous.undrawn || state.compareMode !== previous.compareMode) this.update();
    });
    this.update();
  }

  private update(): void {
    const { document } = this.studio;
    const result = document?.result ?? null;
    if (result !== this.result) {
      this.result = result;
      this.rebuild(document);
    }
    this.empty.hidden = result !== null;
    this.showMode(document);
    if (!document || !result) return;
    const order = ranking(document);
    const highest = Math.max(0.05, ...order.flatMap((index) => Object.values(candidateAt(document, index)?.summary.criteria ?? {})));
    const doable = order.filter((index) => verdictClass(candidateAt(document, index)!) !== 'bad');
    const best = Math.min(...doable.map((index) => scoreOf(candidateAt(document, index)!, document.weights)));
    order.forEach((index, place) => this.updateCard(document, index, place, highest, best));
    this.tellNotes(result.summary);
    const elements = order.map((index) => this.cards.get(index)!.element);
    // only where the order has changed, so that the focus stays
    if (elements.some((element, i) => this.list.children[i] !== element)) fill(this.list, ...elements);
  }

  /** What is to be said of the goals, and that there are fewer motions than were asked for; why is told on hovering. */
  private tellNotes({ status, goal_note_messages: goalNotes = [], conflict_message: conflict, fewer_message: fewer }: Summary): void {
    const notes = [...goalNotes, ...(conflict === undefined ? [] : [conflict])].map(engineText);
    const tellsFewer = conflict === undefined && fewer !== undefined && status !== 'unreachable';
    if (tellsFewer) notes.push(fewerWords(fewer));
    this.fewer.hidden = notes.length === 0;
    this.fewer.textContent = notes.join(' ');
    this.fewer.title = tellsFewer ? engineText(fewer) : '';
  }

  private showMode(document: Document | null): void {
    this.mode.hidden = document?.compared == null;
    const { compareMode } = this.studio.store.state;
    fill(this.mode, ...(['beside', 'over'] as const).map((mode) =>
      h('button', { type: 'button', 'aria-pressed': String(mode === compareMode), onClick: () => this.studio.store.set({ compareMode: mode }) }, t(mode))));
  }

  private rebuild(document: Document | null): void {
    this.cards.clear();
    this.freeStrips();
    fill(this.list);
    const count = document?.result?.candidates.length ?? 0;
    for (let index = 0; index < count; ++index) this.cards.set(index, this.makeCard(index));
    this.thumbnails.show(Array.from({ length: count }, (_, index) => this.cards.get(index)!.canvas));
  }

  private makeCard(index: number): Card {
    const canvas = h('canvas', { class: 'thumbnail', 'aria-hidden': 'true' });
    const strip = h('img', { class: 'strip' });
    const words = h('span', { class: 'words' });
    const score = h('span', { class: 'score' });
    const bars = h('span', { class: 'bars', 'aria-hidden': 'true' });
    const warning = h('span', { class: 'warning' });
    const pick = h('button', { type: 'button', class: 'pick', onClick: () => this.studio.choose(index) },
      canvas, h('span', { class: 'about' }, words, bars, h('span', { class: 'judged' }, warning, score)),
      h('span', { class: 'strip-frame' }, strip));
    const compare = iconButton('compare', t('compare'), () => this.studio.compare(index), { class: 'icon-button compare' });
    const element = h('li', { class: 'card' }, pick, compare);
    return { element, pick, canvas, strip, words, score, bars, warning, compare };
  }

  /** `highest`: the largest penalty of all cards, which is a full bar; `best`: the lowest score of those that a body can make. */
  private updateCard(document: Document, index: number, place: number, highest: number, best: number): void {
    const card = this.cards.get(index);
    const candidate = candidateAt(document, index);
    if (!card || !candidate) return;
    const chosen = index === document.chosen;
    const compared = index === document.compared;
    const edited = document.edits[index] !== undefined;
    const words = differenceWords(document, index);
    const score = scoreOf(candidate, document.weights);
    card.element.classList.toggle('chosen', chosen);
    card.element.classList.toggle('compared', compared);
    card.pick.setAttribute('aria-pressed', String(chosen));
    card.strip.alt = t('strip', { n: place + 1 });
    card.compare.setAttribute('aria-label', t('compareWith', { n: place + 1 }));
    card.compare.setAttribute('aria-pressed', String(compared));
    card.compare.hidden = chosen;
    fill(card.words, h('b', {}, `${place + 1}`), ` ${words}`);
    const told = round(score, 3);
    const judged = verdictClass(candidate);
    fill(card.score, judged === 'bad' ? null : h('span', {}, scoreWords(score, best)), edited ? h('em', {}, t('edited')) : null, h('span', {}, told));
    card.score.dataset['score'] = told;
    card.score.title = `${t('score')} ${told}, ${t('lowerIsBetter')}`;
    this.showBars(card.bars, document, candidate, highest);
    card.warning.hidden = judged === 'good' || undrawnText(this.studio.store.state) !== '';
    card.warning.className = `warning ${judged}`;
    card.warning.textContent = verdictMark(candidate);
    card.warning.title = reasonsWords(document, candidate).join('\n');
    void this.drawStrip(card, candidate, index);
  }

  /** A bar with its name for each of the criteria that cost the motion most; all of them are told on hovering. */
  private showBars(element: HTMLElement, document: Document, candidate: Candidate, highest: number): void {
    const paid = Object.entries(candidate.summary.criteria).map(([name, penalty]) => ({ name, penalty, cost: penalty * (document.weights[name] ?? 0) }))
      .filter(({ name }) => (document.weights[name] ?? 0) > 0).sort((a, b) => b.cost - a.cost);
    element.title = paid.map(({ name, penalty }) => `${engineWord('criteria', name)}: ${round(penalty)}`).join('\n');
    fill(element, ...paid.slice(0, kNamedBars).map(({ name, penalty }) => {
      const bar = h('i');
      bar.style.setProperty('--share', String(Math.max(penalty / highest, 0.02)));
      return h('span', {}, h('span', {}, engineWord('criteria', name)), bar);
    }));
  }

  private async drawStrip(card: Card, candidate: Candidate, index: number): Promise<void> {
    if (this.strips.has(candidate)) {
      card.strip.src = this.strips.get(candidate)!;
      return;
    }
    const svg = await this.studio.strip(index, candidate);
    if (!svg || this.cards.get(index) !== card) return;
    const url = URL.createObjectURL(new Blob([svg as BlobPart], { type: 'image/svg+xml' }));
    this.strips.set(candidate, url);
    card.strip.src = url;
  }

  private freeStrips(): void {
    for (const url of this.strips.values()) URL.revokeObjectURL(url);
    this.strips.clear();
  }

  dispose(): void {
    this.end();
    this.freeStrips();
  }
}
