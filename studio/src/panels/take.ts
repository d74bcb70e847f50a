// SPDX-License-Identifier: MIT
// Take away: animation files, figures, the task and the result, a link.
import { engineWord, type Key, t } from '../i18n';
import { openFiles } from '../state/files';
import type { Studio } from '../state/studio';
import { canTake, link, missingFiles, motionFormats, save, type Taken, takeAway } from '../state/take_away';
import { button, fill, h, type Panel } from './dom';
import { TakeChoices } from './take_choices';
import type { TakeFilm } from './take_film';
import type { TakePicture } from './take_picture';

export class TakePanel implements Panel {
  readonly element: HTMLElement;
  private readonly buttons = new Map<Taken, HTMLButtonElement>();
  private readonly shown = h('div');
  private readonly choices: TakeChoices;
  private readonly end: () => void;

  constructor(private readonly studio: Studio, picture: TakePicture, private readonly film: TakeFilm) {
    const input = h('input', {
      type: 'file', accept: '.json', hidden: true, multiple: true,
      onChange: () => {
        void openFiles(studio, [...(input.files ?? [])]);
        input.value = '';
      },
    });
    this.choices = new TakeChoices(studio);
    const { animations, figures } = motionFormats(studio.facts);
    const made: readonly (readonly [Key, readonly Taken[]])[] = [['animation', animations], ['figure', figures], ['again', ['result', 'task']]];
    const groups = made.map(([title, formats]) => h('section', {}, h('h3', {}, t(title)),
      h('div', { class: 'take' }, ...formats.map((format) => {
        const element = button(engineWord('formats', format), () => void this.take(format), { 'data-format': format });
        this.buttons.set(format, element);
        return element;
      }))));
    groups[0]?.append(this.choices.element);
    groups[2]?.append(h('div', { class: 'take' }, button(t('link'), () => void this.copyLink(), { 'data-format': 'link' }),
      button(t('openResult'), () => input.click()), input), this.shown);
    this.element = h('div', { class: 'panel' }, h('p', { class: 'quiet' }, t('takeIntro')), ...groups, picture.element, film.element);
    this.end = studio.store.subscribe(() => this.update());
    this.update();
  }

  private update(): void {
    for (const [format, element] of this.buttons) {
      element.disabled = !canTake(this.studio, format);
      const missing = missingFiles(this.studio, format);
      element.title = missing.length > 0 ? t('onlyFor', { formats: missing.map((name) => name.toUpperCase()).join(', ') }) : '';
    }
  }

  private async take(format: Taken): Promise<void> {
    try {
      const file = await takeAway(this.studio, format);
      save(file);
      this.studio.tell({ kind: 'text', key: 'saved', values: { name: file.name } });
    } catch (error) {
      this.studio.fail(error);
    }
  }

  private async copyLink(): Promise<void> {
    const text = await link(this.studio);
    if (text === null) {
      this.studio.tell({ kind: 'text', key: 'largeLink' });
      return fill(this.shown, button(engineWord('formats', 'result'), () => void this.take('result')));
    }
    try {
      await navigator.clipboard.writeText(text);
      this.studio.tell({ kind: 'text', key: 'linkCopied' });
      fill(this.shown);
    } catch {
      // no clipboard: the person copies it
      const field = h('input', { type: 'text', value: text, 'aria-label': t('linkShown') });
      fill(this.shown, h('label', { class: 'stack' }, t('linkShown'), field));
      field.readOnly = true;
      field.select();
    }
  }

  dispose(): void {
    this.choices.dispose();
    this.film.dispose();
    this.end();
  }
}
