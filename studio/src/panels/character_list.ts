// SPDX-License-Identifier: MIT
// The characters that were opened: a picture of each, and a click to go back to it with what was last done with it.
import { engineWord, t } from '../i18n';
import { statureWords } from '../i18n/lengths';
import { isBuiltIn } from '../state/formats';
import type { Document } from '../state/model';
import { isRobot } from '../state/start';
import type { Studio } from '../state/studio';
import type { Portraits } from '../view/portraits';
import { fill, h, iconButton, type Panel, round } from './dom';

export class CharacterList implements Panel {
  readonly element = h('ul', { class: 'characters', 'aria-label': t('characters') });
  private shown = '';
  private readonly ends: (() => void)[];

  constructor(private readonly studio: Studio, private readonly portraits: Portraits) {
    this.ends = [
      studio.store.subscribe((state, previous) => {
        if (state.shelf !== previous.shelf || state.document !== previous.document) this.update();
      }),
      portraits.subscribe(() => {
        this.shown = '';
        this.update();
      }),
    ];
    this.update();
  }

  private update(): void {
    const { shelf } = this.studio.store.state;
    const now = this.studio.document?.character;
    const key = `${now?.id} of ${shelf.map(({ character }) => character.id).join()}`;
    if (key === this.shown) return;
    this.shown = key;
    const focused = this.element.contains(globalThis.document.activeElement);
    fill(this.element, ...shelf.map((document) => this.row(document, document.character === now)));
    if (focused) this.element.querySelector<HTMLElement>('[aria-pressed="true"]')?.focus();
  }

  private row(document: Document, current: boolean): HTMLElement {
    const { spec, description } = document.character;
    const name = isBuiltIn(this.studio.facts, spec) ? engineWord('bodies', spec.source) : spec.source;
    const portrait = this.portraits.of(document.character);
    const picture = h('canvas', { class: 'portrait', 'aria-hidden': 'true' });
    if (portrait) {
      picture.width = portrait.picture.width;
      picture.height = portrait.picture.height;
      picture.getContext('2d')!.drawImage(portrait.picture, 0, 0);
    }
    const facts = t('statureAndMass', { stature: statureWords(description.stature_m), kg: round(description.mass_kg, 0) });
    const drawnAs = portrait && document.character.bytes && !portrait.mesh ? h('span', { class: 'quiet' }, t(isRobot(description) ? 'robotRods' : 'noMesh')) : null;
    const pick = h('button', { type: 'button', class: 'pick-character', 'aria-pressed': String(current), onClick: () => this.goTo(document) },
      picture, h('span', { class: 'about-character' }, h('b', {}, name), h('span', { class: 'quiet' }, facts), drawnAs));
    const remove = current ? null : iconButton('close', `${t('remove')}: ${name}`, () => this.studio.takeOff(document));
    return h('li', {}, pick, remove);
  }

  private goTo(document: Document): void {
    if (document.character === this.studio.document?.character) return;
    this.studio.begin(document).catch((error: unknown) => this.studio.fail(error));
  }

  dispose(): void {
    for (const end of this.ends) end();
  }
}
