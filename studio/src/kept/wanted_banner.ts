// SPDX-License-Identifier: MIT
// Asks for the file of a work's character, where it is not at hand.
import { t } from '../i18n';
import { button, fill, h, iconButton, type Panel } from '../panels/dom';
import { characterEndings } from '../state/formats';
import type { State, Wanted } from '../state/model';
import type { Studio } from '../state/studio';
import { takeWanted, wantedNow } from './wanted';

const kLongestName = 60;

export class WantedBanner implements Panel {
  readonly element = h('div', { class: 'wanted', role: 'status' });
  private readonly input: HTMLInputElement;
  private shown: Wanted | null = null;
  private readonly end: () => void;

  constructor(private readonly studio: Studio) {
    this.input = h('input', {
      type: 'file', accept: characterEndings(studio.facts).join(), hidden: true, tabIndex: -1,
      onChange: () => void this.take([...(this.input.files ?? [])]),
    });
    this.end = studio.store.subscribe((state) => this.update(state));
    this.update(studio.store.state);
  }

  private async take(files: readonly File[]): Promise<void> {
    const name = this.name();
    const [file] = files;
    this.input.value = '';
    if (file && !(await takeWanted(this.studio, files))) {
      this.studio.tell({ kind: 'text', key: 'unknownWanted', values: { file: file.name, name } });
    }
  }

  private name(): string {
    const name = this.shown?.work.character.spec.source ?? '';
    return name.length > kLongestName ? `${name.slice(0, kLongestName)}…` : name;
  }

  private update(state: State): void {
    const wanted = wantedNow(state);
    this.element.hidden = wanted === null;
    if (wanted === this.shown) return;
    this.shown = wanted;
    if (!wanted) return fill(this.element);
    fill(this.element, h('span', {}, t(wanted.character ? 'wanted' : 'wantedFirst', { name: this.name() })),
      button(t('chooseFile'), () => this.input.click()), this.input,
      iconButton('close', t('dismiss'), () => this.studio.store.set({ wanted: null })));
  }

  dispose(): void {
    this.end();
  }
}
